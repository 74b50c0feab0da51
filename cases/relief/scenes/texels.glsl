// A solid layer of texels: solid_map, whose first channel is z. The oracles are relief.hit_smooth
// and its kind. The translucent layer is the box's floor, and costs no fetch.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"
#include "texel_height.glsl"

uniform highp sampler2D solid_map;

float solid_height(vec2 uv)
{
    count_fetch();
    return texel_height(solid_map, uv);
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
