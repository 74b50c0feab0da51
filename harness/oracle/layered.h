// A layer seen through a refracting surface, and the blur of a disc.
//
//   layered.way(v, n, n1, n2, d)  from a point of the surface z = 0 to the point of the layer z =
//   -d
//                                 that is seen there: the offset along x and y, the way between
//                                 them
//   layered.disc(x)               the mean of cos(x p) over the unit disc, p along its diameter:
//                                 2 J1(x) / x, what a disc of radius r leaves of a wave of x / r
//
// v points to the eye and n out of the surface; both are directions of any length, and n is turned
// round where dot(v, n) < 0. The way is NaN at total internal reflection and where the refracted
// ray does not lead down. Domain of the bounds: vectors of floats of about unit length; n1, n2 in
// [1, 4]; a refracted ray with a cosine above 0.1 to the normal and to the surface's; d in [0, 8].
// x in [0, 64].
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> LayeredFunctions();

}  // namespace etalon::oracle
