// What a ray meets first of two layers, from the ways to its hits with each of them alone
// (negative: none; NaN: undecided).
//
//   relief.first(t_translucent, t_solid)        the way to the first hit; -1 where there is none
//   relief.first_layer(t_translucent, t_solid)  0 none, 1 the translucent layer, 2 the solid one,
//                                               which also a ray meets that meets both at once
//
// Both are NaN where either way is. The layer is NaN too where the ways differ, but by less than
// 2^-20 box heights: which of them is shorter no float decides.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ReliefLayerFunctions();

}  // namespace etalon::oracle
