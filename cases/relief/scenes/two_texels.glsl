// Two layers of texels: solid_map and translucent_map hold heights as z in the box.
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
