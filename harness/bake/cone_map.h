// Cone maps: above every texel the widest cone that a ray may cross in one step.
#pragma once

#include <vector>

#include "bake/heights.h"

namespace etalon::bake {

// A cone stands on its tip, on the surface; its value is the ratio of its radius to its height.
// Wider than this none is stored.
inline constexpr double kWidestCone = 64;

// Ratios, row by row, for a box of that height.
//
// Safe: the cone of a ratio that is read at a point, from the nearest texel or bilinearly, with its
// tip on the bilinear surface at that point, has no surface in it. Bounded from pairs of cells, so
// less wide than the widest such cone where cells are close (by half at a step in the heights).
// Every cell is held against rings of others until a wider ring cannot matter: the square of the
// number of texels at worst, on fields with details everywhere about 100 cells for each.
std::vector<double> SafeCones(const Heights& heights, const PartDone& done = {});

// Safe, and relaxed: a ray that comes down from above the tip enters the surface in the cone at
// most once, and does not leave it again there. Wider where the surface only rises away from the
// tip. The same work.
std::vector<double> SafeRelaxedCones(const Heights& heights, const PartDone& done = {});

// As published: from the texels' centres to each other; nothing between them is considered. Relaxed
// ones stop at those texels beyond which the field falls.
std::vector<double> SampledCones(const Heights& heights, const PartDone& done = {});
std::vector<double> SampledRelaxedCones(const Heights& heights, const PartDone& done = {});

}  // namespace etalon::bake
