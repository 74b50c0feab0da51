// Layers from maps: heights of both layers, their normals as texels, and the solid's colour.
#include "relief/search.glsl"
#include "translucent/normal.glsl"

uniform highp sampler2D height_map;  // the heights of the solid and of the layer
uniform highp sampler2D solid_normal_map;
uniform highp sampler2D translucent_normal_map;
uniform highp sampler2D color_map;
uniform vec3 sky;

float solid_height(vec2 uv)
{
    return decode_height(textureLod(height_map, uv, 0.0).x, 0.25, -0.5);
}

float translucent_height(vec2 uv)
{
    return decode_height(textureLod(height_map, uv, 0.0).y, 1.0, -0.5);
}

vec3 solid_normal(vec2 uv)
{
    return decode_normal(textureLod(solid_normal_map, uv, 0.0).xyz, true);
}

vec3 translucent_normal(vec2 uv)
{
    return decode_normal(textureLod(translucent_normal_map, uv, 0.0).xyz, true);
}

vec3 solid_color(vec2 uv)
{
    return textureLod(color_map, uv, 0.0).xyz;
}

vec3 environment(vec3 direction)
{
    return sky;
}
