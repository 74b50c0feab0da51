// Waves of the translucent layer over waves of the solid one, with their normals; the oracles
// relief.sine. albedo and the surroundings' brightness are constant.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "relief/scenes/sine_of_turns.glsl"

uniform float solid_amplitude;        // box heights
uniform vec2 solid_wave;              // waves per texture
uniform float solid_level;            // z
uniform float translucent_amplitude;
uniform vec2 translucent_wave;
uniform float translucent_level;
uniform vec3 albedo;
uniform vec3 sky;

// -1 mirrors the scene at u = 0.
float mirror_u = 1.0;
// Exchanges the two layers.
bool exchanged = false;

float wave_height(vec2 uv, float level, float amplitude, vec2 wave)
{
    return level + amplitude * sine_of_turns(dot(wave, vec2(mirror_u * uv.x, uv.y)));
}

// 0.1 texture coordinates are a box height.
vec3 wave_normal(vec2 uv, float amplitude, vec2 wave)
{
    float turns = dot(wave, vec2(mirror_u * uv.x, uv.y));
    vec2 slope = 0.1 * 6.2831853 * amplitude * sine_of_turns(turns + 0.25) * wave;
    return normalize(vec3(-mirror_u * slope.x, -slope.y, 1.0));
}

float solid_height(vec2 uv)
{
    return exchanged ? wave_height(uv, translucent_level, translucent_amplitude, translucent_wave)
                     : wave_height(uv, solid_level, solid_amplitude, solid_wave);
}

float translucent_height(vec2 uv)
{
    return exchanged ? wave_height(uv, solid_level, solid_amplitude, solid_wave)
                     : wave_height(uv, translucent_level, translucent_amplitude, translucent_wave);
}

vec3 solid_normal(vec2 uv)
{
    return exchanged ? wave_normal(uv, translucent_amplitude, translucent_wave)
                     : wave_normal(uv, solid_amplitude, solid_wave);
}

vec3 translucent_normal(vec2 uv)
{
    return exchanged ? wave_normal(uv, solid_amplitude, solid_wave)
                     : wave_normal(uv, translucent_amplitude, translucent_wave);
}

vec3 solid_normal_texel(vec2 uv)
{
    return vec3(0.5) + 0.5 * vec3(1.0, -1.0, 1.0) * solid_normal(uv);
}

vec3 translucent_normal_texel(vec2 uv)
{
    return vec3(0.5) + 0.5 * vec3(1.0, -1.0, 1.0) * translucent_normal(uv);
}

vec3 solid_color(vec2 uv)
{
    return albedo;
}

vec3 environment(vec3 direction)
{
    return sky;
}
