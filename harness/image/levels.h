// The levels of an image below its first.
#pragma once

#include "image/image.h"

namespace etalon {

// Adds all levels, down to 1 x 1. A texel is the mean of the area of the level above that it covers
// (of an odd size, with parts of texels), taken in binary64 through the whole chain and rounded to
// binary32 once. The image must have one level.
void AddLevels(Image& image);

}  // namespace etalon
