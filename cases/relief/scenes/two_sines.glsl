// Two waves, which may cross; the oracle relief.first of two relief.sine.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"
#include "sine_of_turns.glsl"

uniform float solid_amplitude;  // box heights
uniform vec2 solid_wave;        // waves per texture
uniform float solid_phase;      // waves
uniform float solid_level;      // z
uniform float translucent_amplitude;
uniform vec2 translucent_wave;
uniform float translucent_phase;
uniform float translucent_level;

float solid_height(vec2 uv)
{
    count_fetch();
    return solid_level + solid_amplitude * sine_of_turns(dot(solid_wave, uv) + solid_phase);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return translucent_level +
           translucent_amplitude * sine_of_turns(dot(translucent_wave, uv) + translucent_phase);
}
