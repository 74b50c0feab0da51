// The shares of light that a smooth metal of index n2 + i k2 reflects in a medium of index n1.
//
//   conductor.reflectance_sp(n1, n2, k2, cos_i)  (R_s, R_p), the two polarisations
//   conductor.reflectance(n1, n2, k2, cos_i)     their mean
//
// Domain of the bounds: floats n1 and n2 in [2^-3, 2^3], k2 in [1/2, 16], cos_i in [0, 1].
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ConductorFunctions();

}  // namespace etalon::oracle
