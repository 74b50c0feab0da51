#include "oracle/relief.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <numbers>

namespace etalon::oracle {
namespace {

// 64 bits of mantissa: products of floats are exact, and what is left of their sums is enough.
using Real = long double;

constexpr Real kNone = -1;
constexpr Real kInfinity = std::numeric_limits<Real>::infinity();
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();
constexpr Real kTop = 0.5L;
constexpr Real kFloor = -0.5L;

constexpr Real kMargin = 0x1p-20L;  // how much a surface may be elsewhere
constexpr Real kReach = 0x1p-8L;    // and move the hit by
constexpr Real kMostPieces = 65536;

// a + b t
struct Linear {
    Real a;
    Real b;

    Real At(Real t) const { return a + b * t; }

    // The first t in [from, to] at which it is not positive; kNone where there is none.
    Real First(Real from, Real to) const {
        if (At(from) <= 0) {
            return from;
        }
        if (!(b < 0)) {
            return kNone;
        }
        const Real t = std::max(-a / b, from);
        return t <= to ? t : kNone;
    }
};

struct Ray {
    Linear u;
    Linear v;
    Linear z;
    Real end;
};

// The surface of a scene is something with
//   bool IsDefined() const;      its parameters make sense
//   Real First(const Ray& ray, Real from, Real to) const;
//                                the first t in [from, to] at which the unclamped height is not
//                                below the ray; or kNone
//   bool IsFlat(const Ray& ray, Real hit) const;
//                                the ray's height above it changes too slowly there for a root

struct Plane {
    Real slope_u;
    Real slope_v;
    Real level;

    bool IsDefined() const { return std::isfinite(slope_u + slope_v + level); }
    Real First(const Ray& ray, Real from, Real to) const {
        const Linear gap = {((ray.z.a - level) - slope_u * ray.u.a) - slope_v * ray.v.a,
                            (ray.z.b - slope_u * ray.u.b) - slope_v * ray.v.b};
        return gap.First(from, to);
    }
    bool IsFlat(const Ray& /*ray*/, Real /*hit*/) const { return false; }
};

class Sine {
  public:
    Sine(Real amplitude, Real wave_u, Real wave_v, Real phase, Real level)
        : amplitude_(amplitude), wave_u_(wave_u), wave_v_(wave_v), phase_(phase), level_(level) {}

    bool IsDefined() const {
        return std::isfinite(amplitude_ + wave_u_ + wave_v_ + phase_ + level_);
    }

    Real First(const Ray& ray, Real from, Real to) const {
        const Gap gap(*this, ray);
        // Between its extrema the gap is monotone: a piece holds a root where its ends differ in
        // sign. They lie where cos(2 pi turns) is the ratio of the two slopes.
        const Real steepest = kTwoPi * amplitude_ * gap.turns.b;
        const Real ratio = steepest == 0 ? kInfinity : gap.line.b / steepest;
        Real left = from;
        if (gap.At(left) <= 0) {
            return left;
        }
        if (std::fabs(ratio) < 1) {
            const Real angle = std::acos(ratio) / kTwoPi;  // in turns, 0 .. 0.5
            const Real direction = gap.turns.b < 0 ? -1 : 1;
            // Extrema at k +- angle; from the whole turn before the start on.
            Real whole = direction * std::floor(direction * gap.turns.At(from)) - direction;
            while (left < to) {
                for (const Real turn : {whole - direction * angle, whole + direction * angle}) {
                    const Real right = std::min((turn - gap.turns.a) / gap.turns.b, to);
                    if (right <= left) {
                        continue;
                    }
                    if (gap.At(right) <= 0) {
                        return gap.Root(left, right);
                    }
                    left = right;
                }
                whole += direction;
            }
            return kNone;
        }
        return gap.At(to) <= 0 ? gap.Root(left, to) : kNone;
    }

    // A slope of 2^-12 is that of the margin over the reach.
    bool IsFlat(const Ray& ray, Real hit) const {
        return hit > 0 && std::fabs(Gap(*this, ray).SlopeAt(hit)) < kMargin / kReach;
    }

    Real Waves(const Ray& ray) const {
        return std::fabs((wave_u_ * ray.u.b + wave_v_ * ray.v.b) * ray.end);
    }

  private:
    static constexpr Real kTwoPi = 2 * std::numbers::pi_v<Real>;

    // The ray's height above the wave.
    struct Gap {
        Linear line;
        Linear turns;
        Real amplitude;

        Gap(const Sine& sine, const Ray& ray)
            : line{ray.z.a - sine.level_, ray.z.b},
              // Whole turns are taken out of each term while it is exact.
              turns{Part(sine.wave_u_ * ray.u.a) + Part(sine.wave_v_ * ray.v.a) + Part(sine.phase_),
                    sine.wave_u_ * ray.u.b + sine.wave_v_ * ray.v.b},
              amplitude(sine.amplitude_) {}

        static Real Part(Real turns) { return turns - std::round(turns); }

        Real At(Real t) const {
            return line.At(t) - amplitude * std::sin(kTwoPi * Part(turns.At(t)));
        }
        Real SlopeAt(Real t) const {
            return line.b - kTwoPi * amplitude * turns.b * std::cos(kTwoPi * Part(turns.At(t)));
        }
        // Where it falls through zero, given that it is positive at `above` and not at `below`.
        Real Root(Real above, Real below) const {
            while (true) {
                const Real middle = above + (below - above) / 2;
                if (middle <= above || middle >= below) {
                    return below;
                }
                (At(middle) <= 0 ? below : above) = middle;
            }
        }
    };

    Real amplitude_;
    Real wave_u_;
    Real wave_v_;
    Real phase_;
    Real level_;
};

struct SphereCap {
    Real centre_u;
    Real centre_v;
    Real radius;
    Real level;
    Real texture_per_height;

    bool IsDefined() const {
        return std::isfinite(centre_u + centre_v + radius + level) && radius >= 0 &&
               texture_per_height > 0 && std::isfinite(texture_per_height);
    }
    Real First(const Ray& ray, Real from, Real to) const {
        const Real on_level = Plane{0, 0, level}.First(ray, from, to);
        const Real on_sphere = FirstOnSphere(ray, from, on_level < 0 ? to : on_level);
        return on_sphere < 0 ? on_level : on_sphere;
    }
    bool IsFlat(const Ray& /*ray*/, Real /*hit*/) const { return false; }

  private:
    // Nothing is below the box's floor here, so that the sphere's lower half need not be told
    // apart.
    Real FirstOnSphere(const Ray& ray, Real from, Real to) const {
        const Linear way[] = {
            {(ray.u.a - centre_u) / texture_per_height, ray.u.b / texture_per_height},
            {(ray.v.a - centre_v) / texture_per_height, ray.v.b / texture_per_height},
            {ray.z.a - kFloor, ray.z.b}};
        Real speed2 = 0;
        Real along = 0;
        Real distance2 = 0;
        for (const Linear& part : way) {
            speed2 += part.b * part.b;
            along += part.a * part.b;
            distance2 += part.At(from) * part.At(from);
        }
        if (distance2 <= radius * radius) {
            return from;
        }
        if (speed2 == 0) {
            return kNone;
        }
        // From the place nearest to the centre back to the surface.
        const Real nearest = -along / speed2;
        Real nearest2 = 0;
        for (const Linear& part : way) {
            nearest2 += part.At(nearest) * part.At(nearest);
        }
        const Real half2 = (radius * radius - nearest2) / speed2;
        if (nearest < from || half2 < 0) {
            return kNone;
        }
        const Real t = std::max(nearest - std::sqrt(half2), from);
        return t <= to ? t : kNone;
    }
};

struct Steps {
    Real width;
    Real rise;
    Real level;
    Real shift;  // of the walls

    bool IsDefined() const {
        return width > 0 && std::isfinite(width) && std::isfinite(rise + level);
    }
    Real First(const Ray& ray, Real from, Real to) const {
        const Linear u = {ray.u.a - shift, ray.u.b};
        Real step = std::floor(u.At(from) / width);
        Real left = from;
        while (true) {
            const Real wall = (u.b > 0 ? step + 1 : step) * width;
            const Real right = u.b == 0 ? to : std::min(std::max((wall - u.a) / u.b, left), to);
            const bool is_raised = std::fmod(step, Real{2}) != 0;
            const Linear gap = {(ray.z.a - level) - (is_raised ? rise : 0), ray.z.b};
            const Real hit = gap.First(left, right);
            if (hit >= 0 || right >= to) {
                return hit;
            }
            step += u.b > 0 ? 1 : -1;
            left = right;
        }
    }
    bool IsFlat(const Ray& /*ray*/, Real /*hit*/) const { return false; }
};

bool IsRay(const Ray& ray) {
    return ray.end >= 0 && std::isfinite(ray.u.At(ray.end)) && std::isfinite(ray.v.At(ray.end)) &&
           std::isfinite(ray.z.At(ray.end));
}

Ray RayAt(const double* const* in, std::size_t row) {
    return {
        {in[0][row], in[3][row]}, {in[1][row], in[4][row]}, {in[2][row], in[5][row]}, in[6][row]};
}

// The first hit of the surface raised by `raised`, its height clamped to the box.
template <typename Surface>
Real FirstHit(const Surface& surface, const Ray& ray, Real raised) {
    const Ray lowered = {ray.u, ray.v, {ray.z.a - raised, ray.z.b}, ray.end};
    // At the floor everything is met, above the top nothing.
    const Real floor = Linear{lowered.z.a - kFloor, lowered.z.b}.First(0, ray.end);
    const Linear& z = lowered.z;
    Real from = 0;
    Real to = floor < 0 ? ray.end : floor;
    if (z.At(from) > kTop) {
        from = Linear{z.a - kTop, z.b}.First(0, to);
        if (from < 0) {
            return kNone;
        }
    } else if (z.At(to) > kTop) {
        to = (kTop - z.a) / z.b;
    }
    const Real hit = surface.First(lowered, from, to);
    return hit < 0 ? floor : hit;
}

// The hit, NaN where surfaces that are nearly the same (`others`, and the same raised or lowered)
// are not met nearly there.
template <typename Surface>
Real DecidedHit(const Surface& surface, std::initializer_list<Surface> others, const Ray& ray) {
    if (!IsRay(ray) || !surface.IsDefined()) {
        return kNan;
    }
    const Real hit = FirstHit(surface, ray, 0);
    Real least = hit;
    Real most = hit;
    for (const Surface& other : others) {
        for (const Real raised : {kMargin, -kMargin}) {
            const Real near = FirstHit(other, ray, raised);
            if ((near < 0) != (hit < 0)) {
                return kNan;
            }
            least = std::min(least, near);
            most = std::max(most, near);
        }
    }
    return most - least > kReach || surface.IsFlat(ray, hit) ? kNan : hit;
}

template <typename RowHit>
void ForRows(double* const* out, std::size_t rows, RowHit hit) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = static_cast<double>(hit(row));
    }
}

void PlaneHit(const double* const* in, double* const* out, std::size_t rows) {
    ForRows(out, rows, [in](std::size_t row) {
        const Plane plane = {0, 0, in[7][row]};
        return DecidedHit(plane, {plane}, RayAt(in, row));
    });
}

void RampHit(const double* const* in, double* const* out, std::size_t rows) {
    ForRows(out, rows, [in](std::size_t row) {
        const Plane ramp = {in[7][row], in[8][row], in[9][row]};
        return DecidedHit(ramp, {ramp}, RayAt(in, row));
    });
}

void SineHit(const double* const* in, double* const* out, std::size_t rows) {
    ForRows(out, rows, [in](std::size_t row) {
        const Sine sine(in[7][row], in[8][row], in[9][row], in[10][row], in[11][row]);
        const Ray ray = RayAt(in, row);
        return sine.Waves(ray) <= kMostPieces ? DecidedHit(sine, {sine}, ray) : kNan;
    });
}

void SphereCapHit(const double* const* in, double* const* out, std::size_t rows) {
    ForRows(out, rows, [in](std::size_t row) {
        const SphereCap cap = {in[7][row], in[8][row], in[9][row], in[10][row], in[11][row]};
        return DecidedHit(cap, {cap}, RayAt(in, row));
    });
}

void StepsHit(const double* const* in, double* const* out, std::size_t rows) {
    ForRows(out, rows, [in](std::size_t row) {
        const Real width = in[7][row];
        const Ray ray = RayAt(in, row);
        const Steps steps = {width, in[8][row], in[9][row], 0};
        if (!(std::fabs(ray.u.b * ray.end) <= kMostPieces * width)) {
            return kNan;
        }
        Steps after = steps;
        after.shift = kMargin * width;
        Steps before = steps;
        before.shift = -kMargin * width;
        return DecidedHit(steps, {after, before}, ray);
    });
}

// The ray's parameters, and those of a scene after them.
std::vector<Parameter> OnRay(std::initializer_list<Parameter> scene) {
    std::vector<Parameter> all = {{"start", 3}, {"velocity", 3}, {"end", 1}};
    all.insert(all.end(), scene);
    return all;
}

}  // namespace

std::vector<Function> ReliefFunctions() {
    constexpr double kRelative = 0x1p-53;
    return {
        {"relief.plane", OnRay({{"level", 1}}), 1, PlaneHit, kRelative, 0x1p-44},
        {"relief.ramp", OnRay({{"slope", 2}, {"level", 1}}), 1, RampHit, kRelative, 0x1p-44},
        {"relief.sine", OnRay({{"amplitude", 1}, {"wave", 2}, {"phase", 1}, {"level", 1}}), 1,
         SineHit, kRelative, 0x1p-41},
        {"relief.sphere_cap",
         OnRay({{"centre", 2}, {"radius", 1}, {"level", 1}, {"texture_per_height", 1}}), 1,
         SphereCapHit, kRelative, 0x1p-44},
        {"relief.steps", OnRay({{"width", 1}, {"rise", 1}, {"level", 1}}), 1, StepsHit, kRelative,
         0x1p-44},
    };
}

}  // namespace etalon::oracle
