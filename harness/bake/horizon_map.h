// The horizon map: how high the surface rises around each texel.
#pragma once

#include <vector>

#include "bake/heights.h"

namespace etalon::bake {

// Bearing by bearing, in it row by row: the tangent of the least elevation at which a ray from the
// texel's point of the surface meets nothing, 0 where it looks over all the rest. Bearing k of n
// has the angle 2 pi k / n, from +x to +y. Exact for the bilinear surface within `reach`; what is
// farther away rises by less than its height over `reach`.
std::vector<double> HorizonTangents(const Heights& heights, int bearings, double reach,
                                    const PartDone& done = {});

}  // namespace etalon::bake
