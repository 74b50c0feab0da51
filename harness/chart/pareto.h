// The front of points that cost something and err by something.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace etalon {

// All at least 0, low <= cost <= high. NaN: it is not known. Costs whose spreads, `low` to `high`,
// have a number in common are alike: which is the lesser was not measured.
struct CostAndError {
    double cost = 0;
    double error = 0;
    double low = 0;
    double high = 0;

    // Of a cost that is known exactly.
    static CostAndError Exact(double cost, double error) { return {cost, error, cost, cost}; }
};

// Which points are on the front: both numbers are finite, and no point of the front beats them.
// What beats another has less error and costs less or alike, or has the same error and costs less,
// and not alike. Points that are alike in cost and equal in error are on it together. Points with
// a number that is not finite are never on it and keep no other from it. Where all costs are exact
// this is Pareto's front: no other point is as good in both and better in one.
std::vector<bool> ParetoFront(std::span<const CostAndError> points);

// Of the points of finite cost whose error is at most the bound, and that cost as little as the
// cheapest of them or alike: the one with the least error, of these the first.
std::optional<std::size_t> CheapestWithin(std::span<const CostAndError> points, double bound);

}  // namespace etalon
