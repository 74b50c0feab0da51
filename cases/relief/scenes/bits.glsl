// Layers whose heights, normals and density are any bits.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform float solid_level;
uniform float translucent_level;
uniform vec3 normal;
uniform float density;

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
    return normal;
}

vec3 translucent_normal(vec2 uv)
{
    return normal.zxy;
}

float step_density(vec2 uv)
{
    return density;
}
