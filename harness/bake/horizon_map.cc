#include "bake/horizon_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etalon::bake {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// One coordinate of a line through the cells, from a texel's centre.
struct Axis {
    Axis(int texel, double along, int cells)
        : start(texel),
          speed(along),
          size(cells),
          cell(speed < 0 ? texel - 1 : texel),
          index(Heights::Wrapped(cell, size)) {}

    double Exit() const {
        return speed == 0 ? kInfinity
                          : (static_cast<double>(speed > 0 ? cell + 1 : cell) - start) / speed;
    }
    void Next() {
        const int step = speed > 0 ? 1 : -1;
        cell += step;
        index += step;
        index += index < 0 ? size : index >= size ? -size : 0;
    }

    double start;
    double speed;
    int size;
    int cell;
    int index;  // of the cell within the field
};

class Horizons {
  public:
    Horizons(const Heights& heights, double reach) : heights_(heights), reach_(reach) {
        for (int j = 0; j < heights.height(); ++j) {
            for (int i = 0; i < heights.width(); ++i) {
                cells_.emplace_back(heights, i, j);
            }
        }
    }

    // The greatest (height(way) - from) / way, or 0, along a line from a texel's centre.
    double Tangent(int i, int j, double cosine, double sine) const {
        const double from = heights_.Texel(i, j);
        Axis x(i, cosine, heights_.width());
        Axis y(j, sine, heights_.height());
        double most = 0;
        double in = 0;
        while (in < reach_ && heights_.highest() - from > most * in) {
            const double exit_x = x.Exit();
            const double exit_y = y.Exit();
            const double out = std::min(exit_x, exit_y);
            const Cell& cell = cells_[static_cast<std::size_t>(y.index) *
                                          static_cast<std::size_t>(heights_.width()) +
                                      static_cast<std::size_t>(x.index)];
            if (cell.highest - from > most * in) {
                most = std::max(most, InCell(cell, x, y, from, in, out));
            }
            if (exit_x <= exit_y) {
                x.Next();
            }
            if (exit_y <= exit_x) {
                y.Next();
            }
            in = out;
        }
        return most;
    }

  private:
    static double InCell(const Cell& cell, const Axis& x, const Axis& y, double from, double in,
                         double out) {
        // Along the line the height is a + b way + c way^2.
        const double x0 = x.start - x.cell;
        const double y0 = y.start - y.cell;
        const double a = cell.base + cell.slope_x * x0 + cell.slope_y * y0 + cell.twist * x0 * y0;
        const double b = cell.slope_x * x.speed + cell.slope_y * y.speed +
                         cell.twist * (x0 * y.speed + y0 * x.speed);
        const double c = cell.twist * x.speed * y.speed;
        if (in == 0) {  // there a is `from`
            return std::max(b, b + c * out);
        }
        const auto tangent = [&](double way) { return (a - from) / way + b + c * way; };
        const double peak = std::sqrt(std::max((a - from) / c, 0.0));
        return peak > in && peak < out ? std::max(tangent(peak), tangent(out)) : tangent(out);
    }

    const Heights& heights_;
    double reach_;
    std::vector<Cell> cells_;
};

}  // namespace

std::vector<double> HorizonTangents(const Heights& heights, int bearings, double reach,
                                    const PartDone& done) {
    const Horizons horizons(heights, reach);
    std::vector<double> tangents;
    for (int k = 0; k < bearings; ++k) {
        const double angle = 2 * std::numbers::pi * k / bearings;
        // Along the axes exactly, so that a line keeps to the texels.
        const double cosine = 4 * k % (2 * bearings) == bearings ? 0 : std::cos(angle);
        const double sine = 2 * k % bearings == 0 ? 0 : std::sin(angle);
        for (int j = 0; j < heights.height(); ++j) {
            for (int i = 0; i < heights.width(); ++i) {
                tangents.push_back(horizons.Tangent(i, j, cosine, sine));
            }
            Tell(done, std::int64_t{bearings} * heights.height());
        }
    }
    return tangents;
}

}  // namespace etalon::bake
