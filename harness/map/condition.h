// The condition number of a mapped oracle: what no method can better.
#pragma once

#include <vector>

#include "map/map_plan.h"

namespace etalon {

// For each cell the sum of |x df/dx| / |f| over the mapped inputs x that are floats, the greatest
// of all mapped components; inputs that follow from them are computed anew. By central differences
// of the oracle in binary64, a step of 2^-18 of x to either side; one-sided where the oracle has no
// value on one side. Infinite where f is zero and that sum is not; NaN where there is no truth.
// Empty where the plan has no oracle of a float, or no axis of floats.
std::vector<double> ConditionNumbers(const MapPlan& plan);

}  // namespace etalon
