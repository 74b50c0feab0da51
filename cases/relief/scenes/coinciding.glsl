// Two layers that are one wave along u, as wave_height.glsl has it.
#include "fetches.glsl"
#include "wave_height.glsl"

uniform vec4 wave;

float solid_height(vec2 uv)
{
    count_fetch();
    return wave_height(wave, uv);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return wave_height(wave, uv);
}
