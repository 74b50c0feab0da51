// The position that the fragment stage has: divided by w, planes at 0.1 and 10.
#include "light.glsl"

vec3 fragment_position(vec3 position)
{
    vec4 clip = light_projection(0.1, 10.0) * vec4(position, 1.0);
    return clip.xyz / clip.w;
}
