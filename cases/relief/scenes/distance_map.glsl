// The distances of distance_map, of 32 slices, trilinear; beside texels.glsl.
#include "tiles.glsl"

uniform highp sampler2D distance_map;

float distance_at(vec3 position)
{
    const int slices = 32;
    float place = clamp((position.z + 0.5) * float(slices) - 0.5, 0.0, float(slices - 1));
    int lower = min(int(place), slices - 2);
    ivec2 size = textureSize(solid_map, 0);
    float below = tile_value(distance_map, size, lower, position.xy);
    float above = tile_value(distance_map, size, lower + 1, position.xy);
    return below + (place - float(lower)) * (above - below);
}
