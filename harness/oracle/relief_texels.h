// Where a ray first meets a height field of texels, and the field's height: the fields of
// relief_fields.h, bilinear between the texels' centres, which lie at ((i + 0.5) / size, ...).
//
// The ray is that of shaders/relief/ray.glsl: at start + t * velocity after the way t, its xy in
// texture coordinates, its z in the box's; t runs from 0 to end. It may fall, rise or run level.
//
//   relief.hit_smooth(start(3), velocity(3), end), ...  the first t at which the height is not
//                                                       below the ray; -1 where there is none
//   relief.height_smooth(uv(2)), ...                    the height
//
// A hit is NaN, undecided, where heights raised or lowered by 2^-20 would move it by more than 2^-8
// on the whole, or make it a miss, or a miss a hit: at a ray that nearly touches, or runs along,
// the surface, and at a hit within 2^-8 of the ray's end. NaN also where the ray is more than 65536
// cells long, or is no ray: something is not finite or the end is negative.
//
// Domain of the bounds: floats, the ray within 16 textures from their origin.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ReliefTexelFunctions();

}  // namespace etalon::oracle
