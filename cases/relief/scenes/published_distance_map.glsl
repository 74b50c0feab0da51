// The distances of published_distance_map, of 32 slices, trilinear; beside sampled.glsl.
#include "tiles.glsl"

uniform highp sampler2D published_distance_map;

float distance_at(vec3 position)
{
    return volume_value(published_distance_map, textureSize(solid_map, 0), 32, position);
}
