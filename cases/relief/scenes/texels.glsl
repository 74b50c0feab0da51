// A solid layer of texels: solid_map holds heights as z in the box.
#include "fetches.glsl"
#include "texel_height.glsl"

uniform highp sampler2D solid_map;

float solid_height(vec2 uv)
{
    count_fetch();
    return texel_height(solid_map, uv);
}
