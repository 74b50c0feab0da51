#include "chart/bounds.h"

#include <algorithm>
#include <limits>
#include <map>

#include "chart/pareto.h"

namespace etalon {
namespace {

constexpr std::pair<double, const char*> kBounds[] = {{1.0, "1"},           {0.25, "1/4"},
                                                      {1.0 / 255, "1/255"}, {1e-3, "1e-3"},
                                                      {1e-4, "1e-4"},       {1e-6, "1e-6"}};

double ErrorOf(const ChartPoint& point, double ChartAccuracy::*error) {
    return point.accuracy && !point.refused ? (*point.accuracy).*error
                                            : std::numeric_limits<double>::quiet_NaN();
}

CostAndError CostAndErrorOf(const ChartRecord& chart, const ChartPoint& point,
                            double ChartAccuracy::*error) {
    CostAndError made = CostAndError::Exact(CostOf(chart, point), ErrorOf(point, error));
    if (chart.cost_by == "time" && point.cost) {
        made.low = point.cost->low;
        made.high = point.cost->high;
    }
    return made;
}

}  // namespace

void AddFrontAndBounds(ChartRecord& chart) {
    // Groups in the order of their first points.
    std::vector<std::pair<std::string, std::string>> groups;
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> points;
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        const std::pair group(chart.points[i].device, chart.points[i].scene);
        if (points[group].empty()) {
            groups.push_back(group);
        }
        points[group].push_back(i);
    }
    for (const auto& group : groups) {
        const std::vector<std::size_t>& members = points[group];
        const auto pairs = [&](double ChartAccuracy::*error) {
            std::vector<CostAndError> made;
            for (const std::size_t i : members) {
                made.push_back(CostAndErrorOf(chart, chart.points[i], error));
            }
            return made;
        };
        if (std::none_of(members.begin(), members.end(),
                         [&](std::size_t i) { return chart.points[i].accuracy.has_value(); })) {
            continue;
        }
        const std::vector<CostAndError> by_worst = pairs(&ChartAccuracy::worst);
        const std::vector<CostAndError> by_p999 = pairs(&ChartAccuracy::p999);
        const std::vector<bool> front = ParetoFront(by_worst);
        for (std::size_t k = 0; k < members.size(); ++k) {
            chart.points[members[k]].front = front[k];
        }
        for (const auto& [bound, text] : kBounds) {
            for (const bool worst : {true, false}) {
                const auto found = CheapestWithin(worst ? by_worst : by_p999, bound);
                chart.bounds.push_back({group.first, group.second, bound, text,
                                        worst ? "worst" : "p999",
                                        found ? std::optional(members[*found]) : std::nullopt});
            }
        }
    }
}

}  // namespace etalon
