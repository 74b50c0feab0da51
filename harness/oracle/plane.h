// Where a ray i + t v meets a plane; NaN where it is parallel to it.
//
// Domain of the bounds: floats; positions within +-16, directions within +-1 in each component,
// |dot(v, n)| and |v.z| at least 2^-20.
//
//   plane.ray_parameter(i, v, s, n)  dot(s - i, n) / dot(v, n), the plane through s with normal n
//   plane.flat_layer(h, i, v)        (h - i.z) / v.z, the plane z = h
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> PlaneFunctions();

}  // namespace etalon::oracle
