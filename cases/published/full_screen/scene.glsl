// The picture whose times are compared: two layers from maps, seen obliquely by a camera that looks
// down at 45 degrees, its field 36 degrees high. Lengths are in texture coordinates; the polygon is
// 0 .. 4, of which the picture shows 0.9 .. 3.1 by 1.1 .. 3.0, at 27 to 65 degrees from its normal.
#include "published/full_screen.glsl"

uniform highp sampler2D color_map;
uniform highp sampler2D solid_height_map;
uniform highp sampler2D solid_normal_map;
uniform highp sampler2D translucent_height_map;
uniform highp sampler2D translucent_normal_map;
uniform highp samplerCube environment_map;

#ifndef VIEW_SEARCH
#define VIEW_SEARCH ivec2(24, 6)
#endif
#ifndef REFRACTION_SEARCH
#define REFRACTION_SEARCH ivec2(8, 5)
#endif
#ifndef OCCLUSION_SEARCH
#define OCCLUSION_SEARCH ivec2(16, 5)
#endif

const vec3 CAMERA = vec3(2.0, 0.5, 1.25);
const vec3 LAMP = vec3(3.5, 3.0, 2.0);

float solid_height(vec2 uv)
{
    return decode_height(textureLod(solid_height_map, uv, 0.0).x, 0.2, -0.25);
}

float translucent_height(vec2 uv)
{
    return decode_height(textureLod(translucent_height_map, uv, 0.0).x, 1.0, -0.5);
}

vec3 solid_normal_texel(vec2 uv)
{
    return textureLod(solid_normal_map, uv, 0.0).xyz;
}

vec3 translucent_normal_texel(vec2 uv)
{
    return textureLod(translucent_normal_map, uv, 0.0).xyz;
}

vec3 solid_color(vec2 uv)
{
    return textureLod(color_map, uv, 0.0).xyz;
}

vec3 environment(vec3 direction)
{
    return textureLod(environment_map, direction, 0.0).xyz;
}

// What the rasteriser interpolates over the polygon: both directions are affine in uv.
vec3 eye_at(vec2 uv)
{
    return vec3(CAMERA.xy - uv, CAMERA.z);
}

TranslucentSurface surface_at(vec2 uv)
{
    return TranslucentSurface(1.0, 1.6, vec3(1.0, 1.0, 0.0), 0.25, 0.05, vec2(0.2, -0.25), 4.0,
                              vec3(LAMP.xy - uv, LAMP.z), vec3(1.0, 0.05, 0.02), vec3(0.2),
                              vec3(0.1), vec3(0.8), vec3(1.0), VIEW_SEARCH, REFRACTION_SEARCH,
                              OCCLUSION_SEARCH);
}

vec3 fragment(vec2 uv, int techniques)
{
    return full_screen(uv, eye_at(uv), surface_at(uv), techniques);
}
