#include "chart/pareto.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace etalon {
namespace {

bool Beats(const CostAndError& a, const CostAndError& b) {
    return a.error < b.error ? a.low <= b.high : a.error == b.error && a.high < b.low;
}

}  // namespace

std::vector<bool> ParetoFront(std::span<const CostAndError> points) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) {
            order.push_back(i);
        }
    }
    // Nothing is beaten by what comes after it.
    const auto key = [points](std::size_t i) { return std::pair(points[i].error, points[i].low); };
    std::sort(order.begin(), order.end(),
              [&key](std::size_t a, std::size_t b) { return key(a) < key(b); });
    std::vector<bool> is_on_front(points.size(), false);
    std::vector<std::size_t> front;
    for (const std::size_t i : order) {
        if (std::none_of(front.begin(), front.end(), [points, i](std::size_t other) {
                return Beats(points[other], points[i]);
            })) {
            front.push_back(i);
            is_on_front[i] = true;
        }
    }
    return is_on_front;
}

std::optional<std::size_t> CheapestWithin(std::span<const CostAndError> points, double bound) {
    std::vector<std::size_t> within;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::isfinite(points[i].cost) && points[i].error <= bound) {
            within.push_back(i);
        }
    }
    if (within.empty()) {
        return std::nullopt;
    }
    const auto by_cost = [points](std::size_t a, std::size_t b) {
        return points[a].cost < points[b].cost;
    };
    const double cheap = points[*std::min_element(within.begin(), within.end(), by_cost)].high;
    const auto value = [points, cheap](std::size_t i) {
        return std::pair(points[i].low > cheap, points[i].error);
    };
    return *std::min_element(within.begin(), within.end(), [&value](std::size_t a, std::size_t b) {
        return value(a) < value(b);
    });
}

}  // namespace etalon
