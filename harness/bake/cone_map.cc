#include "bake/cone_map.h"

#include <algorithm>
#include <cmath>

namespace etalon::bake {
namespace {

// Calls visit(di, dj) for the places whose greater coordinate is `radius` away.
template <typename Visit>
void ForRing(int radius, Visit&& visit) {
    for (int d = -radius; d <= radius; ++d) {
        visit(d, -radius);
        visit(d, radius);
    }
    for (int d = -radius + 1; d < radius; ++d) {
        visit(-radius, d);
        visit(radius, d);
    }
}

// The least value of a * b with a and b in these ranges.
double LeastProduct(double a0, double a1, double b0, double b1) {
    return std::min({a0 * b0, a0 * b1, a1 * b0, a1 * b1});
}

// What is known of a cell.
struct Bounds {
    explicit Bounds(const Cell& cell)
        : lowest(cell.lowest),
          highest(cell.highest),
          steepest(cell.Steepest()),
          twist(std::fabs(cell.twist)),
          least_x(std::min(cell.slope_x, cell.slope_x + cell.twist)),
          most_x(std::max(cell.slope_x, cell.slope_x + cell.twist)),
          least_y(std::min(cell.slope_y, cell.slope_y + cell.twist)),
          most_y(std::max(cell.slope_y, cell.slope_y + cell.twist)) {}

    // Whether some way from a cell so far off to this one may end downwards.
    bool MayFallFrom(int di, int dj) const {
        return LeastProduct(least_x, most_x, di - 1, di + 1) +
                   LeastProduct(least_y, most_y, dj - 1, dj + 1) <
               0;
    }

    double lowest;
    double highest;
    double steepest;
    double twist;
    double least_x;  // of the slope
    double most_x;
    double least_y;
    double most_y;
};

class Cells {
  public:
    explicit Cells(const Heights& heights) : heights_(heights) {
        for (int j = 0; j < heights.height(); ++j) {
            for (int i = 0; i < heights.width(); ++i) {
                cells_.emplace_back(Cell(heights, i, j));
            }
        }
    }

    const Bounds& At(int i, int j) const {
        return cells_[static_cast<std::size_t>(Heights::Wrapped(j, heights_.height())) *
                          static_cast<std::size_t>(heights_.width()) +
                      static_cast<std::size_t>(Heights::Wrapped(i, heights_.width()))];
    }

    // No line from a point of this cell's surface up to another point of the surface (for relaxed
    // cones: to one at which the surface falls) is steeper.
    double Steepest(int i, int j, bool relaxed) const {
        const Bounds& from = At(i, j);
        // Within the cell a line is a parabola, which must bend down by as much as it rises.
        double most =
            relaxed ? std::min(from.steepest, from.twist * std::sqrt(0.5)) : from.steepest;
        most = std::max(most, 1 / kWidestCone);
        double steepest_near = from.steepest;
        for (int radius = 1;; ++radius) {
            const int nearest = radius - 1;  // of the ring's points, and those beyond
            if (nearest > 0 && heights_.highest() - from.lowest <= most * nearest) {
                return most;
            }
            ForRing(radius, [&](int di, int dj) {
                steepest_near = std::max(steepest_near, At(i + di, j + dj).steepest);
            });
            ForRing(radius, [&](int di, int dj) {
                const Bounds& to = At(i + di, j + dj);
                const double rise = to.highest - from.lowest;
                if (rise <= 0 || (relaxed && !to.MayFallFrom(di, dj))) {
                    return;
                }
                const double apart =
                    std::hypot(std::max(std::abs(di) - 1, 0), std::max(std::abs(dj) - 1, 0));
                most = std::max(most,
                                apart > 0 ? std::min(steepest_near, rise / apart) : steepest_near);
            });
        }
    }

  private:
    const Heights& heights_;
    std::vector<Bounds> cells_;
};

std::vector<double> Safe(const Heights& heights, bool relaxed, const PartDone& done) {
    const Cells cells(heights);
    const auto width = static_cast<std::size_t>(heights.width());
    std::vector<double> steepest;
    for (int j = 0; j < heights.height(); ++j) {
        for (int i = 0; i < heights.width(); ++i) {
            steepest.push_back(cells.Steepest(i, j, relaxed));
        }
        Tell(done, heights.height());
    }
    const auto of = [&](int i, int j) {
        return steepest[static_cast<std::size_t>(Heights::Wrapped(j, heights.height())) * width +
                        static_cast<std::size_t>(Heights::Wrapped(i, heights.width()))];
    };
    std::vector<double> ratios;
    for (int j = 0; j < heights.height(); ++j) {
        for (int i = 0; i < heights.width(); ++i) {
            // A texel is read in the four cells around it.
            const double most = std::max({of(i - 1, j - 1), of(i, j - 1), of(i - 1, j), of(i, j)});
            ratios.push_back((1 - 0x1p-20) / most);
        }
    }
    return ratios;
}

std::vector<double> Sampled(const Heights& heights, bool relaxed, const PartDone& done) {
    std::vector<double> ratios;
    for (int j = 0; j < heights.height(); ++j) {
        for (int i = 0; i < heights.width(); ++i) {
            const double from = heights.Texel(i, j);
            double most = 1 / kWidestCone;
            for (int radius = 1; heights.highest() - from > most * radius; ++radius) {
                ForRing(radius, [&](int di, int dj) {
                    const double to = heights.Texel(i + di, j + dj);
                    const double apart = std::hypot(di, dj);
                    if (to - from <= most * apart) {
                        return;
                    }
                    const bool falls = heights.At(i + di + di / apart, j + dj + dj / apart) < to;
                    if (!relaxed || falls) {
                        most = (to - from) / apart;
                    }
                });
            }
            ratios.push_back(1 / most);
        }
        Tell(done, heights.height());
    }
    return ratios;
}

}  // namespace

std::vector<double> SafeCones(const Heights& heights, const PartDone& done) {
    return Safe(heights, false, done);
}

std::vector<double> SafeRelaxedCones(const Heights& heights, const PartDone& done) {
    return Safe(heights, true, done);
}

std::vector<double> SampledCones(const Heights& heights, const PartDone& done) {
    return Sampled(heights, false, done);
}

std::vector<double> SampledRelaxedCones(const Heights& heights, const PartDone& done) {
    return Sampled(heights, true, done);
}

}  // namespace etalon::bake
