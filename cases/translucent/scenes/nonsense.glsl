// A scene whose heights, normals and colours are any bits.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

uniform vec3 bits;

float solid_height(vec2 uv)
{
    return bits.x;
}

float translucent_height(vec2 uv)
{
    return bits.y;
}

vec3 solid_normal(vec2 uv)
{
    return bits.zxy;
}

vec3 translucent_normal(vec2 uv)
{
    return bits.yzx;
}

vec3 solid_color(vec2 uv)
{
    return bits;
}

vec3 environment(vec3 direction)
{
    return bits.zyx;
}
