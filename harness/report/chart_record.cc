#include "report/chart_record.h"

#include <limits>

namespace etalon {

double CostOf(const ChartRecord& chart, const ChartPoint& point) {
    if (chart.cost_by == "time" && point.cost) {
        return point.cost->nanoseconds;
    }
    if (chart.cost_by == "operations" && point.mean) {
        return point.mean->total;
    }
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace etalon
