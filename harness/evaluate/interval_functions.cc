// Functions of settled intervals: the range of the real function, widened as the profile says. All
// but compositions of interval arithmetic rounds to nearest here, as the C library expects.

#include <cmath>
#include <numbers>

#include "evaluate/interval_range.h"

namespace etalon::evaluate::interval {
namespace {

constexpr double kPi = std::numbers::pi;

bool IsSilent() {
    return !Held::profile().bounds_trigonometry;
}

Interval Exponential(const Interval& x, double (*function)(double)) {
    if (!(x.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    const Nearest nearest;
    const Profile& profile = Held::profile();
    const double ulps = profile.exp_ulp + profile.exp_ulp_slope * x.magnitude;
    // Far beyond the floats, and not yet beyond binary64.
    const auto value = [&](double at) { return function(std::clamp(at, -700.0, 700.0)); };
    return FloatsIn(WidenedByUlps(Slack(value(x.low()), value(x.high)), ulps));
}

Real LogarithmRange(const Interval& x, double (*function)(double)) {
    const Profile& profile = Held::profile();
    const Real truth = Slack(function(x.low()), function(x.high));
    Real result = truth;
    if (x.low() < 0.5 || x.high > 2) {
        result = WidenedByUlps(truth, profile.log_ulp);
    }
    if (x.low() <= 2 && x.high >= 0.5) {
        const Real absolute = Widened(truth, profile.log_absolute);
        result = {std::min(result.low, absolute.low), std::max(result.high, absolute.high)};
    }
    return result;
}

Interval Logarithm(const Interval& x, double (*function)(double)) {
    if (!(x.low() > 0 && x.high < Interval::kInfinity)) {
        return Anything();
    }
    const Nearest nearest;
    return FloatsIn(LogarithmRange(x, function));
}

bool IsInPeriod(const Interval& x) {
    return x.magnitude <= kPi;
}

// Of an interval within [-pi, pi].
Real SineRange(const Interval& x) {
    const double a = std::sin(x.low());
    const double b = std::sin(x.high);
    Real range = Slack(std::min(a, b), std::max(a, b));
    if (x.low() <= kPi / 2 && x.high >= kPi / 2) {
        range.high = 1;
    }
    if (x.low() <= -kPi / 2 && x.high >= -kPi / 2) {
        range.low = -1;
    }
    return range;
}
Real CosineRange(const Interval& x) {
    const double a = std::cos(x.low());
    const double b = std::cos(x.high);
    Real range = Slack(std::min(a, b), std::max(a, b));
    if (x.low() <= 0 && x.high >= 0) {
        range.high = 1;
    }
    return range;
}

// 1 - x x with the product rounded by itself, or not at all, but never beyond [0, 1] for |x| <= 1.
Interval OneWithoutSquare(const Interval& x) {
    return Settle(Sub(One(), Settle(Square(x))));
}

// x + sqrt(x x + sign), and its logarithm.
Interval LogarithmOfSum(const Interval& x, double sign) {
    const Interval root = Sqrt(Settle(Add(Square(x), Number(sign))));
    return Log(Settle(Add(x, root)));
}

Real Monotonic(const Interval& x, double (*function)(double)) {
    return Slack(function(x.low()), function(x.high));
}

Interval HyperbolicFormula(const Interval& x, bool is_sine) {
    const Interval up = Exp(x);
    const Interval down = Exp(Neg(x));
    return Settle(Mul(is_sine ? Sub(up, down) : Add(up, down), Number(0.5)));
}

}  // namespace

// 1 / inversesqrt(x), of 0 its limit.
Interval Sqrt(const Interval& x) {
    if (!(x.low() >= 0 && x.high < Interval::kInfinity)) {
        return Anything();
    }
    if (x.magnitude == 0) {
        return x;
    }
    const Nearest nearest;
    const Profile& profile = Held::profile();
    const Real truth = Slack(std::sqrt(x.low()), std::sqrt(x.high));
    // The relative error of the reciprocal; an ulp is at most kEpsilon of its value.
    double relative = profile.inverse_sqrt_ulp * kEpsilon;
    if (truth.low > 0) {
        relative =
            std::min(relative, profile.inverse_sqrt_ulp * RoundingOf(1 / truth.low) * truth.high);
    }
    relative *= 1 + 0x1p-20;
    const Real inverted = {truth.low * (1 - relative), truth.high * (1 + relative)};
    return FloatsIn(WidenedByUlps(inverted, profile.division_ulp));
}

Interval InverseSqrt(const Interval& x) {
    if (!(x.low() >= kLeastNormal && x.high < Interval::kInfinity)) {
        return Anything();
    }
    const Nearest nearest;
    return FloatsIn(WidenedByUlps(Slack(1 / std::sqrt(x.high), 1 / std::sqrt(x.low())),
                                  Held::profile().inverse_sqrt_ulp));
}

Interval Exp(const Interval& x) {
    return Exponential(x, std::exp);
}
Interval Exp2(const Interval& x) {
    return Exponential(x, std::exp2);
}
Interval Log(const Interval& x) {
    return Logarithm(x, std::log);
}
Interval Log2(const Interval& x) {
    return Logarithm(x, std::log2);
}

// exp2(y log2(x)).
Interval Pow(const Interval& x, const Interval& y) {
    if (!(x.low() > 0 && x.high < Interval::kInfinity && y.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    const Profile& profile = Held::profile();
    Real truth;
    Real logarithm;
    {
        const Nearest nearest;
        truth = Slack(std::log2(x.low()), std::log2(x.high));
        logarithm = LogarithmRange(x, std::log2);
    }
    const Interval exact = Mul(y, Settled(-truth.low, truth.high));
    const Interval scaled =
        Settle(Mul(y, Settled(FloatAbove(-logarithm.low), FloatAbove(logarithm.high))));
    if (scaled.IsAnything()) {
        return Anything();
    }
    const Nearest nearest;
    const double off = std::max({0.0, exact.low() - scaled.low(), scaled.high - exact.high});
    const double ulps = profile.exp_ulp + profile.exp_ulp_slope * scaled.magnitude;
    const Real power = Slack(std::exp2(exact.low()), std::exp2(exact.high));
    const double growth = std::exp2(off);
    const Real low = WidenedByUlps({power.low / growth, power.low * growth}, ulps);
    const Real high = WidenedByUlps({power.high / growth, power.high * growth}, ulps);
    // Symmetric about the true value.
    return FloatsIn({power.low - std::max(power.low - low.low, low.high - power.low),
                     power.high + std::max(high.high - power.high, power.high - high.low)});
}

Interval Sin(const Interval& x) {
    if (IsSilent() || !IsInPeriod(x)) {
        return Anything();
    }
    const Nearest nearest;
    return FloatsIn(Widened(SineRange(x), Held::profile().sine_absolute));
}
Interval Cos(const Interval& x) {
    if (IsSilent() || !IsInPeriod(x)) {
        return Anything();
    }
    const Nearest nearest;
    return FloatsIn(Widened(CosineRange(x), Held::profile().sine_absolute));
}
// sin(x) / cos(x).
Interval Tan(const Interval& x) {
    if (IsSilent() || !IsInPeriod(x)) {
        return Anything();
    }
    const Interval formula = Settle(Div(Sin(x), Cos(x)));
    const Nearest nearest;
    return Inherited(Monotonic(x, std::tan), formula);
}

Interval Atan(const Interval& x) {
    if (IsSilent() || !(x.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    const Nearest nearest;
    return FloatsIn(WidenedByUlps(Monotonic(x, std::atan), Held::profile().arc_tangent_ulp));
}

Interval Atan2(const Interval& y, const Interval& x) {
    const bool may_be_origin = y.low() <= 0 && y.high >= 0 && x.low() <= 0 && x.high >= 0;
    if (IsSilent() || may_be_origin || !(y.magnitude + x.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    const Nearest nearest;
    Real range = {-kPi, kPi};
    const bool crosses = x.low() < 0 && y.low() <= 0 && y.high >= 0;
    if (!crosses) {
        const double corners[] = {std::atan2(y.low(), x.low()), std::atan2(y.low(), x.high),
                                  std::atan2(y.high, x.low()), std::atan2(y.high, x.high)};
        range = {*std::min_element(std::begin(corners), std::end(corners)),
                 *std::max_element(std::begin(corners), std::end(corners))};
    }
    return FloatsIn(WidenedByUlps(Slack(range.low, range.high), Held::profile().arc_tangent_ulp));
}

// atan2(x, sqrt(1 - x x)).
Interval Asin(const Interval& x) {
    if (IsSilent() || !(x.magnitude <= 1)) {
        return Anything();
    }
    const Interval formula = Atan2(x, Sqrt(OneWithoutSquare(x)));
    const Nearest nearest;
    return Inherited(Monotonic(x, std::asin), formula);
}
// atan2(sqrt(1 - x x), x).
Interval Acos(const Interval& x) {
    if (IsSilent() || !(x.magnitude <= 1)) {
        return Anything();
    }
    const Interval formula = Atan2(Sqrt(OneWithoutSquare(x)), x);
    const Nearest nearest;
    return Inherited(Slack(std::acos(x.high), std::acos(x.low())), formula);
}

Interval Sinh(const Interval& x) {
    if (IsSilent()) {
        return Anything();
    }
    const Interval formula = HyperbolicFormula(x, true);
    const Nearest nearest;
    return Inherited(Monotonic(x, std::sinh), formula);
}
Interval Cosh(const Interval& x) {
    if (IsSilent()) {
        return Anything();
    }
    const Interval formula = HyperbolicFormula(x, false);
    const Nearest nearest;
    const double least = std::max({x.low(), -x.high, 0.0});
    return Inherited(Slack(std::cosh(least), std::cosh(x.magnitude)), formula);
}
Interval Tanh(const Interval& x) {
    if (IsSilent()) {
        return Anything();
    }
    const Interval formula = Settle(Div(Sinh(x), Cosh(x)));
    const Nearest nearest;
    return Inherited(Monotonic(x, std::tanh), formula);
}
Interval Asinh(const Interval& x) {
    if (IsSilent()) {
        return Anything();
    }
    const Interval formula = LogarithmOfSum(x, 1);
    const Nearest nearest;
    return Inherited(Monotonic(x, std::asinh), formula);
}
Interval Acosh(const Interval& x) {
    if (IsSilent() || !(x.low() >= 1)) {
        return Anything();
    }
    const Interval formula = LogarithmOfSum(x, -1);
    const Nearest nearest;
    return Inherited(Monotonic(x, std::acosh), formula);
}
Interval Atanh(const Interval& x) {
    if (IsSilent() || !(x.magnitude < 1)) {
        return Anything();
    }
    const Interval quotient = Settle(Div(Add(One(), x), Sub(One(), x)));
    const Interval formula = Settle(Mul(Log(quotient), Number(0.5)));
    const Nearest nearest;
    return Inherited(Monotonic(x, std::atanh), formula);
}

}  // namespace etalon::evaluate::interval
