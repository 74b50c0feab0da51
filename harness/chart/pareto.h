// The front of points that cost something and err by something.
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace etalon {

// Both at least 0. NaN: it is not known.
struct CostAndError {
    double cost = 0;
    double error = 0;
};

// Which points are on the front: both numbers are finite, and no other point is as good in both and
// better in one. Points that are equal in both are on it together. Points with a number that is not
// finite are never on it and keep no other from it.
std::vector<bool> ParetoFront(std::span<const CostAndError> points);

// The cheapest point of finite cost whose error is at most the bound: of several the one with the
// least error, of these the first.
std::optional<std::size_t> CheapestWithin(std::span<const CostAndError> points, double bound);

}  // namespace etalon
