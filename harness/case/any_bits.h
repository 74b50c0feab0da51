// Values of any bits: what a function is fed that must be good for any input at all.
#pragma once

#include <cstdint>

#include "case/input_values.h"

namespace etalon {

// First the type's special values, in all components: of a float both zeros, the ends of the
// subnormal, normal and finite numbers, 1, both infinities, quiet and signalling NaNs of both
// signs; of an integer 0, 1, -1 and the ends of its range. Then `count` values whose components are
// drawn one by one: four of eight from the ordinary (floats in -2..2, int -32..31, uint 0..63), one
// from the special values, three from all 2^32 patterns. A bool is drawn from false and true.
//
// Side by side there are exactly `count` values in random order, the special ones among them unless
// they were more than half.
ValueList AnyBits(const TypeShape& shape, std::uint64_t count, std::uint64_t seed,
                  bool side_by_side);

}  // namespace etalon
