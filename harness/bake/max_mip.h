// The maximum mipmap: for every block of cells the greatest height in it.
#pragma once

#include <vector>

#include "bake/heights.h"

namespace etalon::bake {

struct MaxLevel {
    int width;
    int height;
    std::vector<double> most;  // row by row
};

// Level 0 has a value for each cell, between the texels (i, j) and (i + 1, j + 1): its bilinear
// surface is not higher, and reaches it. A value of every further level is the greatest of 2 x 2,
// down to one; of a field that is not square, of 2 x 1 at last. Sides must be powers of two.
std::vector<MaxLevel> MaxLevels(const Heights& heights);

}  // namespace etalon::bake
