// Light that meets a plane-parallel slab of index n2 in a medium of index n1, re-reflections
// between its faces included, incoherent.
//
//   slab.shares(n1, n2, cos_i, thickness, half_distance)  (reflected, transmitted)
//
// is the mean over the polarisations of R (1 + a t) and t = T^2 a / (1 - R^2 a^2), where a halves
// every half_distance along the way thickness / max(cos_t, 2^-12); (1, 0) where T = 0. Domain of
// the bounds: indices and cosine as in fresnel.h, floats thickness >= 0, half_distance >= 2^-126.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> SlabFunctions();

}  // namespace etalon::oracle
