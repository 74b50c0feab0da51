#include "oracle/shadow.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace etalon::oracle {
namespace {

// 64 bits of mantissa: the differences of floats are exact, or nearly.
using Real = long double;

constexpr Real kFloor = -0.5L;

struct Place {
    Real u;
    Real v;
    Real z;
};

Place PlaceAt(const double* const* in, std::size_t row) {
    return {in[0][row], in[1][row], in[2][row]};
}

// Of directions of any length: the light's, and that of the horizon, whose tangent is given.
double Opening(const Place& direction, Real horizon) {
    const Real aside = std::hypot(direction.u, direction.v);
    return static_cast<double>((direction.z - aside * horizon) / (aside + direction.z * horizon));
}

void Ramp(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Place direction = PlaceAt(in, row);
        const Real aside = std::hypot(direction.u, direction.v);
        const Real rise =
            (in[3][row] * direction.u + in[4][row] * direction.v) / aside * Real{in[5][row]};
        out[0][row] = Opening(direction, std::max(rise, Real{0}));
    }
}

void Steps(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Place point = PlaceAt(in, row);
        const Place direction = PlaceAt(in + 3, row);
        const Real width = in[6][row];
        const Real above = Real{in[8][row]} + in[7][row] - point.z;
        const Real terrace = std::floor(point.u / width);
        Real horizon = 0;
        if (std::fmod(terrace, Real{2}) == 0 && direction.u != 0 && above > 0) {
            const Real wall = (direction.u > 0 ? terrace + 1 : terrace) * width;
            const Real share = direction.u / std::hypot(direction.u, direction.v);
            horizon = above * in[9][row] * share / (wall - point.u);
        }
        out[0][row] = Opening(direction, horizon);
    }
}

void Cap(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Place point = PlaceAt(in, row);
        const Place direction = PlaceAt(in + 3, row);
        const Real scale = in[10][row];
        const Real to_u = (in[6][row] - point.u) / scale;
        const Real to_v = (in[7][row] - point.v) / scale;
        const Real aside = std::hypot(direction.u, direction.v);
        // The circle that the plane cuts out of the sphere.
        const Real along = (to_u * direction.u + to_v * direction.v) / aside;
        const Real beside = (to_u * direction.v - to_v * direction.u) / aside;
        const Real radius = in[8][row];
        const Real square = (radius - beside) * (radius + beside);
        const Real below = point.z - kFloor;
        Real horizon = 0;
        if (square > below * below && along > 0) {
            // The tangent to it: the difference below is a sum, for its second term is negative.
            const Real reach = std::sqrt(std::max(along * along + below * below - square, Real{0}));
            horizon = (square - below * below) / (std::sqrt(square) * reach + along * below);
        }
        out[0][row] = Opening(direction, horizon);
    }
}

void Disc(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Real x = std::clamp(in[0][row], -1.0, 1.0);
        const Real near = std::acos(-x) + x * std::sqrt((1 - x) * (1 + x));
        out[0][row] = static_cast<double>(near / std::numbers::pi_v<Real>);
    }
}

}  // namespace

std::vector<Function> ShadowFunctions() {
    constexpr double kRelative = 0x1p-52;
    return {
        {"shadow.ramp",
         {{"direction", 3}, {"slope", 2}, {"texture_per_height", 1}},
         1,
         Ramp,
         kRelative,
         0x1p-52},
        {"shadow.steps",
         {{"point", 3},
          {"direction", 3},
          {"width", 1},
          {"rise", 1},
          {"level", 1},
          {"texture_per_height", 1}},
         1,
         Steps,
         kRelative,
         0x1p-52},
        {"shadow.cap",
         {{"point", 3},
          {"direction", 3},
          {"centre", 2},
          {"radius", 1},
          {"level", 1},
          {"texture_per_height", 1}},
         1,
         Cap,
         kRelative,
         0x1p-50},
        {"shadow.disc", {{"x", 1}}, 1, Disc, kRelative, 0x1p-62},
    };
}

}  // namespace etalon::oracle
