// Ranges of real functions, and what the functions of intervals share.
#pragma once

#include <cfenv>
#include <cmath>

#include "evaluate/interval.h"

namespace etalon::evaluate::interval {

// All but compositions of interval arithmetic rounds to nearest, as the C library expects.
class Nearest {
  public:
    Nearest() { std::fesetround(FE_TONEAREST); }
    ~Nearest() { std::fesetround(FE_UPWARD); }
    Nearest(const Nearest&) = delete;
    Nearest& operator=(const Nearest&) = delete;
};

struct Real {
    double low = 0;
    double high = 0;
};

// Widened by more than the error of the C library's functions.
inline Real Slack(double low, double high) {
    return {low - std::abs(low) * 0x1p-50, high + std::abs(high) * 0x1p-50};
}

// The floats in the range, whatever the rounding mode; none below -kLargest but the infinity.
inline Interval FloatsIn(const Real& range) {
    if (!(range.low <= range.high)) {
        return Anything();
    }
    auto low = static_cast<float>(range.low);
    if (static_cast<double>(low) < range.low) {
        low = std::nextafter(low, std::numeric_limits<float>::infinity());
    }
    auto high = static_cast<float>(range.high);
    if (static_cast<double>(high) > range.high) {
        high = std::nextafter(high, -std::numeric_limits<float>::infinity());
    }
    // Beyond the largest float come both that and the infinity.
    const double last = Interval::kInfinity;
    return Settled(range.low < -kLargest ? last : -std::min(kLargest, static_cast<double>(low)),
                   range.high > kLargest ? last : std::max(-kLargest, static_cast<double>(high)));
}

// The most that `ulps` ulp are for values of which the one nearer to zero is `end`, up to `other`:
// beyond the next power of two no value reaches back to `end`.
inline double UlpsAt(double end, double other, double ulps) {
    return ulps * RoundingOf(std::min(std::abs(other), 2 * std::abs(end)));
}

inline Real WidenedByUlps(const Real& x, double ulps) {
    if (x.low > 0) {
        return {std::max(0.0, x.low - UlpsAt(x.low, x.high, ulps)),
                x.high + ulps * RoundingOf(x.high)};
    }
    if (x.high < 0) {
        return {x.low - ulps * RoundingOf(-x.low),
                std::min(0.0, x.high + UlpsAt(x.high, x.low, ulps))};
    }
    return {x.low - ulps * RoundingOf(-x.low), x.high + ulps * RoundingOf(x.high)};
}

inline Real Widened(const Real& x, double absolute) {
    return {x.low - absolute, x.high + absolute};
}

// As far from the true range to either side as the formula's goes beyond it.
inline Interval Inherited(const Real& truth, const Interval& formula) {
    if (formula.IsAnything()) {
        return Anything();
    }
    const double beyond = std::max({0.0, truth.low - formula.low(), formula.high - truth.high});
    return FloatsIn(Widened(truth, beyond));
}

inline Interval Number(double x) {
    return Settled(-x, x);
}
inline Interval One() {
    return Number(1);
}
inline Interval Sub(const Interval& a, const Interval& b) {
    return Add(a, Neg(b));
}

}  // namespace etalon::evaluate::interval
