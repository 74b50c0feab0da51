#include "chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace etalon {

std::vector<bool> ParetoFront(std::span<const CostAndError> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) {
            order.push_back(i);
        }
    }
    const auto key = [points](std::size_t i) { return std::pair(points[i].cost, points[i].error); };
    std::sort(order.begin(), order.end(),
              [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<bool> front(points.size(), false);
    double least = std::numeric_limits<double>::infinity();
    std::pair<double, double> last = {-1, -1};
    for (const std::size_t i : order) {
        if (points[i].error < least || key(i) == last) {
            front[i] = true;
            least = points[i].error;
            last = key(i);
        }
    }
    return front;
}

std::optional<std::size_t> CheapestWithin(std::span<const CostAndError> points, double bound) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!std::isfinite(points[i].cost) || !(points[i].error <= bound)) {
            continue;
        }
        if (!best || std::pair(points[i].cost, points[i].error) <
                         std::pair(points[*best].cost, points[*best].error)) {
            best = i;
        }
    }
    return best;
}

}  // namespace etalon
