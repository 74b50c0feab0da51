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
    TranslucentSurface made;
    made.n1 = n1;
    made.n2 = n2;
    made.absorb_color = c;
    made.half_distance = bits.z;
    made.texture_per_height = c.y;
    made.extent = vec4(-65536.0, c.x, 65536.0, 65536.0);
    made.lamp = lamp;
    made.attenuation = c.zxy;
    made.global_ambient = bits.yxz;
    made.ambient = c.yzx;
    made.diffuse = bits.xzy;
    made.specular = lamp.xyz;
    made.gloss = c.z;
    made.strength = lamp.w;
    made.light_way = counts.z & 1;
    made.mirror = counts.z & 3;
    made.plane = bits.x;
    made.frame = mat3(bits, c, lamp.yzw);
    made.view_search = (counts.xy & 63) - 8;
    made.refraction_search = (counts.yx & 63) - 8;
    made.light_search = (counts.xz & 63) - 8;
    return made;
}
