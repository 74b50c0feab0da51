// A flat translucent layer over a flat solid one of one colour, in surroundings of one brightness;
// the oracle translucent.flat.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform float translucent_level;  // z
uniform float solid_level;        // z
uniform vec3 albedo;
uniform vec3 sky;

float solid_height(vec2 uv)
{
    return solid_level;
}

float translucent_height(vec2 uv)
{
    return translucent_level;
}

vec3 solid_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 translucent_normal(vec2 uv)
{
    return vec3(0.0, 0.0, 1.0);
}

vec3 solid_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 translucent_normal_texel(vec2 uv)
{
    return vec3(0.5, 0.5, 1.0);
}

vec3 solid_color(vec2 uv)
{
    return albedo;
}

vec3 environment(vec3 direction)
{
    return sky;
}
