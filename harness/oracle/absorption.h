// Light that fades on its way through a medium.
//
// d is the length of the way, half_distance the length that halves the light, absorb_color how
// strongly each channel is absorbed. Domain of the bounds: floats d >= 0, half_distance >= 2^-126,
// d / half_distance <= 1000, absorb_color in [0, 1].
//
//   absorption.absorbed(d, half_distance)                    1 - 2^(-d / half_distance)
//   absorption.transmitted(d, half_distance)                 2^(-d / half_distance)
//   absorption.hued(d, half_distance, absorb_color)          1 - absorb_color * absorbed
//   absorption.beer_lambert(d, half_distance, absorb_color)  2^(-absorb_color d / half_distance)
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> AbsorptionFunctions();

}  // namespace etalon::oracle
