// Two layers of texels, whose maps' first channel is z; the oracle is
// relief.first(relief.hit_film(...), relief.hit_bricks(...)), for any two fields.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"
#include "texel_height.glsl"

uniform highp sampler2D solid_map;
uniform highp sampler2D translucent_map;

float solid_height(vec2 uv)
{
    count_fetch();
    return texel_height(solid_map, uv);
}

float translucent_height(vec2 uv)
{
    count_fetch();
    return texel_height(translucent_map, uv);
}
