// A wave as the solid layer; the oracle relief.sine. The translucent layer is the box's floor.

#ifdef GL_ES
precision highp float;
#endif

#include "sine_of_turns.glsl"

uniform float amplitude;  // box heights
uniform vec2 wave;        // waves per texture
uniform float phase;      // waves
uniform float level;      // z

float solid_height(vec2 uv)
{
    return level + amplitude * sine_of_turns(dot(wave, uv) + phase);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
