// What theory says of a map's cells, held against what was seen.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "map/map_plan.h"

namespace etalon {

// What the case's [map] predicts of each cell; undecided cells, and those at which the rounding of
// the expression itself leaves it undecided, are open. Absent where nothing is predicted. Fails
// where both are true in a cell; and with `whole`, which says that the picture is the [map]'s own,
// where one of them is true in none.
Result<std::optional<PredictionSeen>> Predict(const MapPlan& plan, bool whole);

// Adds the device's agreement, and its first contradiction where there was none before. `repeat` is
// the command, but for its input.
void Hold(const MapPlan& plan, const MappedDevice& device, const std::string& repeat,
          PredictionSeen& prediction);

}  // namespace etalon
