// Whole numbers, remainders, choices and scalings of settled intervals.

#include <cmath>

#include "evaluate/interval_range.h"

namespace etalon::evaluate::interval {
namespace {

Interval WholeNumbers(double low, double high) {
    Interval x = Settled(-low, high);
    x.quantum = std::max(x.quantum, 1.0);
    x.finest = 1;
    return x;
}

}  // namespace

Interval Floor(const Interval& x) {
    return WholeNumbers(std::floor(x.low()), std::floor(x.high));
}
Interval Ceil(const Interval& x) {
    return WholeNumbers(std::ceil(x.low()), std::ceil(x.high));
}
Interval Trunc(const Interval& x) {
    return WholeNumbers(std::trunc(x.low()), std::trunc(x.high));
}
Interval Round(const Interval& x) {
    const Nearest nearest;
    return WholeNumbers(std::ceil(x.low() - 0.5), std::floor(x.high + 0.5));
}
Interval RoundEven(const Interval& x) {
    const Nearest nearest;
    return WholeNumbers(std::nearbyint(x.low()), std::nearbyint(x.high));
}
Interval Fract(const Interval& x) {
    const double whole = std::floor(x.low());
    if (!(x.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    if (whole != std::floor(x.high)) {
        return Settled(0, 1);
    }
    return Settled(FloatAbove(x.minus_low + whole), FloatAbove(x.high - whole));
}

namespace {

// x - y round(x / y): symmetric about the true remainder where there is a single one.
Interval Remainder(const Interval& x, const Interval& y, Interval (*round)(const Interval&),
                   bool is_of_divisor) {
    const Interval whole = round(Settle(Div(x, y)));
    const Interval formula = Settle(Sub(x, Mul(y, whole)));
    if (!x.IsPoint() || !y.IsPoint() || formula.IsAnything()) {
        return formula;
    }
    const Nearest nearest;
    double truth = std::fmod(x.high, y.high);
    if (is_of_divisor && truth != 0 && (truth < 0) != (y.high < 0)) {
        truth += y.high;
    }
    return Inherited(Slack(truth, truth), formula);
}

}  // namespace

Interval Mod(const Interval& x, const Interval& y) {
    return Remainder(x, y, Floor, true);
}
Interval Rem(const Interval& x, const Interval& y) {
    return Remainder(x, y, Trunc, false);
}

Interval Abs(const Interval& x) {
    if (x.IsAnything()) {
        return x;
    }
    return Settled(-std::max({x.low(), -x.high, 0.0}), x.magnitude);
}
Interval Sign(const Interval& x) {
    if (x.IsAnything()) {
        return x;
    }
    const auto sign = [](double end) { return end > 0 ? 1.0 : end < 0 ? -1.0 : 0.0; };
    return Settled(-sign(x.low()), sign(x.high));
}
Interval Min(const Interval& a, const Interval& b) {
    if (a.IsAnything() || b.IsAnything()) {
        return Anything();
    }
    return Settled(std::max(a.minus_low, b.minus_low), std::min(a.high, b.high));
}
Interval Max(const Interval& a, const Interval& b) {
    if (a.IsAnything() || b.IsAnything()) {
        return Anything();
    }
    return Settled(std::min(a.minus_low, b.minus_low), std::max(a.high, b.high));
}
Interval Hull(const Interval& a, const Interval& b) {
    if (a.IsAnything() || b.IsAnything()) {
        return Anything();
    }
    return Settled(std::max(a.minus_low, b.minus_low), std::max(a.high, b.high));
}
Interval Step(const Interval& edge, const Interval& x) {
    if (edge.IsAnything() || x.IsAnything()) {
        return Anything();
    }
    return Settled(x.low() >= edge.high ? -1 : 0, x.high < edge.low() ? 0 : 1);
}
Interval Smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x) {
    if (!(edge0.high < edge1.low())) {
        return Anything();
    }
    const Interval way = Settle(Div(Sub(x, edge0), Sub(edge1, edge0)));
    const Interval t = Min(Max(way, Number(0)), One());
    return Mul(Mul(t, t), Sub(Number(3), Mul(Number(2), t)));
}

Interval Ldexp(const Interval& x, std::int32_t exponent) {
    if (exponent > 128) {
        return Anything();
    }
    const int power = std::max(exponent, -400);
    const double minus_low = std::ldexp(x.minus_low, power);
    const double high = std::ldexp(x.high, power);
    if (!(std::max(minus_low, high) <= kLargest)) {
        return Anything();
    }
    const Interval scaled = Settled(FloatAbove(minus_low), FloatAbove(high));
    // The text lets such a result be flushed, however great.
    return exponent < -126 ? Hull(scaled, Number(0)) : scaled;
}

}  // namespace etalon::evaluate::interval
