// Two layers that are one wave; the oracle relief.sine, and of the layers always the solid one.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"
#include "sine_of_turns.glsl"

uniform float amplitude;  // box heights
uniform vec2 wave;        // waves per texture
uniform float phase;      // waves
uniform float level;      // z

float solid_height(vec2 uv)
{
    count_fetch();
    return level + amplitude * sine_of_turns(dot(wave, uv) + phase);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return level + amplitude * sine_of_turns(dot(wave, uv) + phase);
}
