// The distances of distance_map, of 32 slices, trilinear; beside texels.glsl.
#include "tiles.glsl"

uniform highp sampler2D distance_map;

float distance_at(vec3 position)
{
    return volume_value(distance_map, textureSize(solid_map, 0), 32, position);
}
