#include "bake/heights.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"

namespace etalon::bake {

Heights::Heights(int width, int height, std::vector<double> texels)
    : width_(width), height_(height), texels_(std::move(texels)) {
    ETALON_CHECK(width_ > 0 && height_ > 0);
    ETALON_CHECK(texels_.size() ==
                 static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    const auto [lowest, highest] = std::ranges::minmax(texels_);
    lowest_ = lowest;
    highest_ = highest;
}

double Heights::At(double x, double y) const {
    const double column = std::floor(x);
    const double row = std::floor(y);
    const Cell cell(*this, static_cast<int>(column), static_cast<int>(row));
    const double in_x = x - column;
    const double in_y = y - row;
    return cell.base + cell.slope_x * in_x + cell.slope_y * in_y + cell.twist * in_x * in_y;
}

Cell::Cell(const Heights& heights, int i, int j) {
    const double right = heights.Texel(i + 1, j);
    const double upper = heights.Texel(i, j + 1);
    const double across = heights.Texel(i + 1, j + 1);
    base = heights.Texel(i, j);
    slope_x = right - base;
    slope_y = upper - base;
    twist = (across - upper) - slope_x;
    lowest = std::min({base, right, upper, across});
    highest = std::max({base, right, upper, across});
}

double Cell::Steepest() const {
    // Each component is linear in the other coordinate: the square is greatest in a corner.
    return std::hypot(std::max(std::fabs(slope_x), std::fabs(slope_x + twist)),
                      std::max(std::fabs(slope_y), std::fabs(slope_y + twist)));
}

}  // namespace etalon::bake
