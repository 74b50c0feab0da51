#include "oracle/relief_texels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "oracle/relief_fields.h"

namespace etalon::oracle {
namespace {

// 64 bits of mantissa: a position 2048 texels away is known to 2^-53 of a texel.
using Real = long double;

constexpr Real kNone = -1;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

constexpr Real kMargin = 0x1p-20L;  // how much heights may differ
constexpr Real kReach = 0x1p-8L;    // and move the hit by
constexpr int kMostCells = 65536;

// One cell of the field: what lies between four texels' centres, as a function of the place in it.
struct Patch {
    Real base;
    Real slope_x;
    Real slope_y;
    Real twist;
    Real top;  // nothing in the cell is higher

    Patch(const HeightField& field, std::int64_t i, std::int64_t j) {
        const double h00 = field.Texel(i, j);
        const double h10 = field.Texel(i + 1, j);
        const double h01 = field.Texel(i, j + 1);
        const double h11 = field.Texel(i + 1, j + 1);
        base = h00;  // all exact: heights are multiples of 2^-12
        slope_x = h10 - h00;
        slope_y = h01 - h00;
        twist = (h11 - h01) - (h10 - h00);
        top = std::max(std::max(h00, h10), std::max(h01, h11));
    }

    Real Height(Real x, Real y) const {
        return base + (slope_x * x + slope_y * y + twist * (x * y));
    }
};

// The smallest s in (0, length] with a + b s + c s^2 <= 0, given a > 0; else kNone. Of the root's
// two forms that one which adds numbers of one sign; c = 0, a planar cell, is no special case.
Real FirstRoot(Real a, Real b, Real c, Real length) {
    if (b >= 0 && c >= 0) {
        return kNone;
    }
    const Real discriminant = b * b - 4 * a * c;
    if (discriminant < 0) {
        return kNone;
    }
    const Real root = std::sqrt(discriminant);
    const Real s = b < 0 ? 2 * a / (root - b) : (root + b) / (-2 * c);
    return s <= length ? s : kNone;
}

struct Axis {
    Real start;        // in texels from the first texel's centre
    Real velocity;     // texels per way
    Real way_a_texel;  // 1 / velocity

    Axis(double texture, double texture_velocity, int texels)
        : start(texture * static_cast<Real>(texels) - Real{0.5}),
          velocity(texture_velocity * static_cast<Real>(texels)),
          way_a_texel(1 / velocity) {}

    std::int64_t CellAt(Real t) const {
        return static_cast<std::int64_t>(std::floor(start + velocity * t));
    }
    // The way at which the ray leaves the cell.
    Real Exit(std::int64_t cell) const {
        if (velocity == 0) {
            return kInfinity;
        }
        return (static_cast<Real>(velocity > 0 ? cell + 1 : cell) - start) * way_a_texel;
    }
    std::int64_t Next(std::int64_t cell) const { return velocity > 0 ? cell + 1 : cell - 1; }
};

class Walk {
  public:
    Walk(const HeightField& field, const double* const* in, std::size_t row)
        : field_(field),
          x_(in[0][row], in[3][row], field.size()),
          y_(in[1][row], in[4][row], field.size()),
          z_(in[2][row]),
          velocity_z_(in[5][row]),
          end_(in[6][row]) {}

    Real Hit() {
        const Real cells = (std::fabs(x_.velocity) + std::fabs(y_.velocity)) * end_;
        const Real farthest = std::fabs(x_.start) + std::fabs(y_.start) + cells;
        const bool is_ray = end_ >= 0 && cells <= kMostCells && farthest <= 0x1p62L &&
                            std::isfinite(z_) && std::isfinite(velocity_z_ * end_);
        if (!is_ray) {
            return kNan;
        }
        // Raised heights are met first, lowered ones last: one walk meets all three.
        const Real raised = First(0, kMargin);
        if (raised < 0) {
            return kNone;
        }
        const Real hit = First(raised, 0);
        const Real lowered = hit < 0 ? kNone : First(hit, -kMargin);
        return lowered < 0 || lowered - raised > kReach ? kNan : hit;
    }

  private:
    // The first way, not before `from`, at which heights raised by `raised` are not below the ray.
    Real First(Real from, Real raised) const {
        std::int64_t i = x_.CellAt(from);
        std::int64_t j = y_.CellAt(from);
        Real exit_x = x_.Exit(i);
        Real exit_y = y_.Exit(j);
        Real t = from;
        while (true) {
            // Not before t, where rounding has put a border behind the ray.
            const Real out = std::max(t, std::min(std::min(exit_x, exit_y), end_));
            const Real met = FirstInCell(i, j, t, out, raised);
            if (met >= 0) {
                return met;
            }
            if (out >= end_) {
                return kNone;
            }
            if (exit_x <= exit_y) {
                i = x_.Next(i);
                exit_x = x_.Exit(i);
            } else {
                j = y_.Next(j);
                exit_y = y_.Exit(j);
            }
            t = out;
        }
    }

    // The same within [in, out], a way through the cell (i, j).
    Real FirstInCell(std::int64_t i, std::int64_t j, Real in, Real out, Real raised) const {
        const Patch patch(field_, i, j);
        const Real z_in = z_ + velocity_z_ * in - raised;
        const Real z_out = z_ + velocity_z_ * out - raised;
        if (std::min(z_in, z_out) > patch.top) {
            return kNone;
        }
        // From the cell's own corner and entry, so that nothing large cancels.
        const Real x = x_.start + x_.velocity * in - static_cast<Real>(i);
        const Real y = y_.start + y_.velocity * in - static_cast<Real>(j);
        const Real gap = z_in - patch.Height(x, y);
        if (gap <= 0) {
            return in;
        }
        const Real slope = velocity_z_ - patch.slope_x * x_.velocity - patch.slope_y * y_.velocity -
                           patch.twist * (x * y_.velocity + y * x_.velocity);
        const Real bend = -patch.twist * x_.velocity * y_.velocity;
        const Real way = FirstRoot(gap, slope, bend, out - in);
        return way < 0 ? kNone : in + way;
    }

    const HeightField& field_;
    Axis x_;
    Axis y_;
    Real z_;
    Real velocity_z_;
    Real end_;
};

template <std::size_t kField>
void Hit(const double* const* in, double* const* out, std::size_t rows) {
    const HeightField& field = HeightFields()[kField];
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = static_cast<double>(Walk(field, in, row).Hit());
    }
}

template <std::size_t kField>
void Height(const double* const* in, double* const* out, std::size_t rows) {
    const HeightField& field = HeightFields()[kField];
    for (std::size_t row = 0; row < rows; ++row) {
        const Axis x(in[0][row], 0, field.size());
        const Axis y(in[1][row], 0, field.size());
        if (!(std::fabs(x.start) <= 0x1p62L && std::fabs(y.start) <= 0x1p62L)) {
            out[0][row] = std::numeric_limits<double>::quiet_NaN();
            continue;
        }
        const std::int64_t i = x.CellAt(0);
        const std::int64_t j = y.CellAt(0);
        out[0][row] = static_cast<double>(
            Patch(field, i, j)
                .Height(x.start - static_cast<Real>(i), y.start - static_cast<Real>(j)));
    }
}

std::array<std::string, kHeightFields> Named(const std::string& prefix) {
    std::array<std::string, kHeightFields> names;
    std::ranges::transform(HeightFields(), names.begin(), [&prefix](const HeightField& field) {
        return prefix + std::string(field.name());
    });
    return names;
}

}  // namespace

std::vector<Function> ReliefTexelFunctions() {
    static const auto hits = Named("relief.hit_");
    static const auto heights = Named("relief.height_");
    return []<std::size_t... kField>(std::index_sequence<kField...>) {
        return std::vector<Function>{
            {hits[kField],
             {{"start", 3}, {"velocity", 3}, {"end", 1}},
             1,
             Hit<kField>,
             0x1p-52,
             0x1p-41}...,
            {heights[kField], {{"uv", 2}}, 1, Height<kField>, 0x1p-53, 0x1p-62}...};
    }
    (std::make_index_sequence<kHeightFields>());
}

}  // namespace etalon::oracle
