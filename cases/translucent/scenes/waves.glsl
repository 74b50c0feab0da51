// Waves of the translucent layer over waves of the solid one, with their normals; the
// oracles relief.sine. The solid is striped along v.

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
uniform float stripes;                // how much darker the solid is in between, 0 .. 1
uniform vec3 sky;

// -1 mirrors the scene at u = 0.
float mirror_u = 1.0;
// Exchanges the two layers.
bool exchanged = false;

// Level, amplitude, and waves per texture of the solid or the translucent layer.
vec4 wave_of(bool solid)
{
    return solid != exchanged ? vec4(solid_level, solid_amplitude, solid_wave)
                              : vec4(translucent_level, translucent_amplitude, translucent_wave);
}

float wave_height(vec2 uv, vec4 wave)
{
    return wave.x + wave.y * sine_of_turns(dot(wave.zw, vec2(mirror_u * uv.x, uv.y)));
}

// 0.1 texture coordinates are a box height.
vec3 wave_normal(vec2 uv, vec4 wave)
{
    float turns = dot(wave.zw, vec2(mirror_u * uv.x, uv.y));
    vec2 slope = 0.1 * 6.2831853 * wave.y * sine_of_turns(turns + 0.25) * wave.zw;
    return normalize(vec3(-mirror_u * slope.x, -slope.y, 1.0));
}

float solid_height(vec2 uv)
{
    return wave_height(uv, wave_of(true));
}

float translucent_height(vec2 uv)
{
    return wave_height(uv, wave_of(false));
}

vec3 solid_normal(vec2 uv)
{
    return wave_normal(uv, wave_of(true));
}

vec3 translucent_normal(vec2 uv)
{
    return wave_normal(uv, wave_of(false));
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
    return albedo * (1.0 - stripes * (0.5 + 0.5 * sine_of_turns(3.0 * uv.y)));
}

vec3 environment(vec3 direction)
{
    return sky;
}
