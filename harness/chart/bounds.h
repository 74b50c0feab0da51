// Front and bounds of a chart that has its points.
#pragma once

#include "report/chart_record.h"

namespace etalon {

// Marks the points of each device's and scene's front of cost and worst error, and finds the
// cheapest that hold each of 1, 1/4, 1/255, 1e-3, 1e-4 and 1e-6 by their worst error, and by that
// of 99.9 % of the rows. Times whose spreads meet are alike (chart/pareto.h). A point that the
// family's `accept` refuses counts for neither. A device and scene without any errors has none.
// Where no point has errors there are neither.
void AddFrontAndBounds(ChartRecord& chart);

}  // namespace etalon
