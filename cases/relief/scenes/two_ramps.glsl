// Two planes, of the height x * u + y * v + z for a ramp (x, y, z). Nothing limits them to the box.
#include "fetches.glsl"

uniform vec3 solid_ramp;
uniform vec3 translucent_ramp;

float solid_height(vec2 uv)
{
    count_fetch();
    return dot(solid_ramp, vec3(uv, 1.0));
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return dot(translucent_ramp, vec3(uv, 1.0));
}
