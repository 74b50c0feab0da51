// Two waves along u, as wave_height.glsl has them; where they cross the layers do.
#include "fetches.glsl"
#include "wave_height.glsl"

uniform vec4 solid_wave;
uniform vec4 translucent_wave;

float solid_height(vec2 uv)
{
    count_fetch();
    return wave_height(solid_wave, uv);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return wave_height(translucent_wave, uv);
}
