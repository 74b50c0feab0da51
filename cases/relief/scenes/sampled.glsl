// A solid layer of texels as a shader reads it: solid_map's first channel is z, and the sampler's
// own filter makes it bilinear, so that a height is one fetch. The translucent layer is the box's
// floor.

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

#include "fetches.glsl"

uniform highp sampler2D solid_map;

float solid_height(vec2 uv)
{
    count_fetch();
    return textureLod(solid_map, uv, 0.0).x;
}

float translucent_height(vec2 uv)
{
    return -0.5;
}
