// The cells of solid_map and their greatest heights from max_map; a square map, its sides a power
// of two. Beside texels.glsl.
#include "tiles.glsl"

uniform highp sampler2D max_map;

vec4 solid_cell(ivec2 cell)
{
    ivec2 size = textureSize(solid_map, 0);
    ivec2 first = wrapped(cell, size);
    ivec2 second = wrapped(cell + 1, size);
    count_fetch();
    return vec4(image_texel(solid_map, first), image_texel(solid_map, ivec2(second.x, first.y)),
                image_texel(solid_map, ivec2(first.x, second.y)), image_texel(solid_map, second));
}

float max_height(ivec2 block, int level)
{
    int side = textureSize(solid_map, 0).x;
    ivec2 corner = level == 0 ? ivec2(0) : ivec2(side, side - (side >> (level - 1)));
    count_fetch();
    return image_texel(max_map, corner + wrapped(block, ivec2(max(side >> level, 1))));
}
