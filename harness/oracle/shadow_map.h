// Translucent shadow maps: the dipole, and the light that a whole map sends to one point.
//
// A medium has absorption sigma_a, reduced scattering sigma_s (per unit of length) and an index.
// Domain of the bounds: sigma_a in [0, 16], sigma_s in [2^-6, 16], index in [1, 3], lengths up to
// 64, at most 64 effective mean free paths.
//
//   shadow_map.reflectance(sigma_a, sigma_s, index, r)  R_d at the distance r
//   shadow_map.beyond(sigma_a, sigma_s, index, square)  its integral over that part of a plane
//   which
//                                                       is farther away than sqrt(square)
//   shadow_map.sum(scene, sigma_a, sigma_s, index, u, v, depth)
//
// The last is the sum of R_d over all 128 x 128 texels of a map of width 8, a parallel light of 1
// across it, times the area of the texel; the way is that from the texel's surface to the map
// coordinate (u, v) at that depth. With x and y from -4 to 4 across the map, the surfaces are,
// where x and y are within +-3:
//   scene 0  depth 2                           scene 1  depth 2 + x / 2
//   scene 2  a sphere, radius 2, depth 4       scene 3  depth 2 + |x| / 2
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ShadowMapFunctions();

}  // namespace etalon::oracle
