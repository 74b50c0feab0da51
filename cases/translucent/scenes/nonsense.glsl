// A scene whose heights, normals, colours and optics are any bits.
#include "translucent/material.glsl"

uniform vec3 bits;
uniform vec3 c;
uniform vec4 lamp;
uniform float n1;
uniform float n2;
uniform ivec3 counts;

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

// Searches of any length take long: their counts are -8 .. 55.
TranslucentSurface surface()
{
    TranslucentSurface any;
    any.n1 = n1;
    any.n2 = n2;
    any.absorb_color = c;
    any.half_distance = bits.z;
    any.texture_per_height = c.y;
    any.extent = vec4(-65536.0, c.x, 65536.0, 65536.0);
    any.lamp = lamp;
    any.attenuation = c.zxy;
    any.global_ambient = bits.yxz;
    any.ambient = c.yzx;
    any.diffuse = bits.xzy;
    any.specular = lamp.xyz;
    any.gloss = c.z;
    any.strength = lamp.w;
    any.light_way = counts.z & 1;
    any.mirror = counts.z & 3;
    any.plane = bits.x;
    any.frame = mat3(bits, c, lamp.yzw);
    any.view_search = (counts.xy & 63) - 8;
    any.refraction_search = (counts.yx & 63) - 8;
    any.light_search = (counts.xz & 63) - 8;
    return any;
}
