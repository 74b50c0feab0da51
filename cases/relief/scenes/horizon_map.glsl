// The horizons of horizon_map, bilinear; beside texels.glsl.
#include "tiles.glsl"

uniform highp sampler2D horizon_map;

float horizon_at(vec2 uv, int bearing)
{
    return tile_value(horizon_map, textureSize(solid_map, 0), bearing, uv);
}
