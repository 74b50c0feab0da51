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
    Axis(int texel, double along)
        : start(texel), speed(along), cell(speed < 0 ? texel - 1 : texel) {}

    double Exit() const {
        return speed == 0 ? kInfinity
                          : (static_cast<double>(speed > 0 ? cell + 1 : cell) - start) / speed;
    }
    double At(double way) const { return start + speed * way - cell; }
    void Next() { cell += speed > 0 ? 1 : -1; }

    double start;
    double speed;
    int cell;
};

// The greatest (height(way) - from) / way, or 0, along a line from a texel's centre.
double Tangent(const Heights& heights, Axis x, Axis y, double reach) {
    const double from = heights.Texel(static_cast<int>(x.start), static_cast<int>(y.start));
    double most = 0;
    double in = 0;
    while (in < reach && heights.highest() - from > most * in) {
        const Cell cell(heights, x.cell, y.cell);
        const double exit_x = x.Exit();
        const double exit_y = y.Exit();
        const double out = std::min(exit_x, exit_y);
        // Along the line the height is a + b way + c way^2.
        const double x0 = x.At(0);
        const double y0 = y.At(0);
        const double a = cell.base + cell.slope_x * x0 + cell.slope_y * y0 + cell.twist * x0 * y0;
        const double b = cell.slope_x * x.speed + cell.slope_y * y.speed +
                         cell.twist * (x0 * y.speed + y0 * x.speed);
        const double c = cell.twist * x.speed * y.speed;
        const auto tangent = [&](double way) { return (a - from) / way + b + c * way; };
        if (in == 0) {
            most = std::max(most, b);  // in the first cell a is `from`
        } else {
            const double peak = std::sqrt(std::max((a - from) / c, 0.0));
            if (peak > in && peak < out) {
                most = std::max(most, tangent(peak));
            }
        }
        most = std::max(most, in == 0 ? b + c * out : tangent(out));
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

}  // namespace

std::vector<double> HorizonTangents(const Heights& heights, int bearings, double reach) {
    std::vector<double> tangents;
    for (int k = 0; k < bearings; ++k) {
        const double angle = 2 * std::numbers::pi * k / bearings;
        // Along the axes exactly, so that a line keeps to the texels.
        const double cosine = 4 * k % (2 * bearings) == bearings ? 0 : std::cos(angle);
        const double sine = 2 * k % bearings == 0 ? 0 : std::sin(angle);
        for (int j = 0; j < heights.height(); ++j) {
            for (int i = 0; i < heights.width(); ++i) {
                tangents.push_back(Tangent(heights, Axis(i, cosine), Axis(j, sine), reach));
            }
        }
    }
    return tangents;
}

}  // namespace etalon::bake
