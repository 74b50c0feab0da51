#include "evaluate/interval.h"

#include <cfenv>

#include "base/check.h"

namespace etalon::evaluate {
namespace {

thread_local const Profile* held = nullptr;

}  // namespace

Held::Held(const Profile& profile) : rounding_(std::fegetround()) {
    ETALON_CHECK(held == nullptr);
    held = &profile;
    std::fesetround(FE_UPWARD);
}

Held::~Held() {
    std::fesetround(rounding_);
    held = nullptr;
}

const Profile& Held::profile() {
    ETALON_CHECK(held != nullptr);
    return *held;
}

namespace interval {
namespace {

// Beyond so many roundings their products count, and nothing useful is left of the bound.
constexpr float kMostRoundings = 0x1p15f;
constexpr float kLeastNormalFloat = 0x1p-126f;

// A factor that is a power of two changes no rounding, unless something is subnormal or overflows.
bool Scales(const Interval& by, const Interval& x) {
    return IsPowerOfTwo(by) && by.finest * x.finest >= kLeastNormalFloat &&
           by.peak * x.peak <= kLargest;
}

Interval Scaled(const Interval& x, const Interval& by) {
    const double factor = by.magnitude;
    Interval result = by.high < 0 ? Neg(x) : x;
    result.minus_low *= factor;
    result.high *= factor;
    result.magnitude *= factor;
    result.error *= factor;
    result.quantum *= factor;
    result.peak *= by.peak;
    result.finest *= by.finest;
    result.is_scaled = true;
    return x.magnitude == 0 ? Unsigned(result) : result;
}

// Rounding leaves multiples of a power of two what they are.
Interval OnGrid(Interval settled, double quantum) {
    settled.quantum = std::max(settled.quantum, quantum);
    settled.finest = FinestOf(settled.quantum);
    return settled;
}

// What the roundings of the products in x may add up to in whatever order they are made.
double ErrorInAnyOrder(const Interval& x) {
    return std::max(x.error, static_cast<double>(x.factors) * kEpsilon * x.magnitude);
}

// All but the ends of a product.
Interval ProductOf(const Interval& a, const Interval& b) {
    Interval x;
    x.magnitude = a.magnitude * b.magnitude;
    if (a.IsSettled() && b.IsSettled()) {
        x.error = RoundingOf(x.magnitude);
    } else {
        const double error_a = ErrorInAnyOrder(a);
        const double error_b = ErrorInAnyOrder(b);
        x.error = error_a * b.magnitude + a.magnitude * error_b + error_a * error_b +
                  kEpsilon * x.magnitude;
    }
    x.quantum = a.quantum * b.quantum;
    x.peak = a.peak * b.peak;
    x.sums = (a.sums + 1) * (b.sums + 1) - 1;
    x.factors = a.factors + b.factors + 1;
    x.finest = a.finest * b.finest;
    x.sign = static_cast<std::int16_t>(a.sign * b.sign);
    x.is_scaled = a.is_scaled || b.is_scaled;
    return x;
}

}  // namespace

Interval SettleExpression(const Interval& x) {
    if (!(x.magnitude < Interval::kInfinity)) {
        return Anything();
    }
    const float roundings = x.sums + x.factors;
    // In another order, what is scaled may be an intermediate that is subnormal or overflows.
    const bool is_safe = x.finest >= kLeastNormalFloat && x.peak <= kLargest;
    if (roundings == 1 && (is_safe || !x.is_scaled)) {
        return OnGrid(Settled(FloatAbove(x.minus_low), FloatAbove(x.high)), x.quantum);
    }
    if (!(x.peak <= kLargest) || roundings > kMostRoundings) {
        return Anything();
    }
    // Every part of the sum is a float, in every order.
    if (x.finest >= kLeastNormalFloat && x.quantum * 0x1p24 >= x.magnitude) {
        return OnGrid(Settled(x.minus_low, x.high), x.quantum);
    }
    double error = x.error;
    if (x.sums > 0) {
        error += static_cast<double>(x.sums - 1) * kEpsilon * x.magnitude;
        error += RoundingOf(std::max(x.minus_low, x.high) + error);
    }
    const auto count = static_cast<double>(roundings);
    error *= 1 + 2 * count * kEpsilon;
    // A product of some factors, or a numerator's sum, may be flushed.
    if (x.finest < kLeastNormalFloat && !x.is_quotient) {
        error += kLeastNormal * (count + 1) * x.peak;
    }
    // Roundings of what has one sign do not change it.
    const double minus_low = x.sign == 1 ? std::min(x.minus_low + error, 0.0) : x.minus_low + error;
    const double high = x.sign == -1 ? std::min(x.high + error, 0.0) : x.high + error;
    // What comes out is a float: the ends may go inwards to the next ones.
    return OnGrid(Settled(minus_low > kLargest ? Interval::kInfinity : FloatBelow(minus_low),
                          high > kLargest ? Interval::kInfinity : FloatBelow(high)),
                  x.quantum);
}

Interval Mul(const Interval& a, const Interval& b) {
    if (Scales(b, a)) {
        return Scaled(a, b);
    }
    if (Scales(a, b)) {
        return Scaled(b, a);
    }
    Interval x = ProductOf(a, b);
    const double low_a = a.low();
    const double low_b = b.low();
    x.high = std::max(std::max(low_a * low_b, low_a * b.high),
                      std::max(a.high * low_b, a.high * b.high));
    x.minus_low = std::max(std::max(a.minus_low * low_b, a.minus_low * b.high),
                           std::max(a.high * b.minus_low, -a.high * b.high));
    return x;
}

Interval Square(const Interval& a) {
    Interval x = ProductOf(a, a);
    x.sign = a.sums == 0 ? std::int16_t{1} : x.sign;
    x.high = std::max(a.minus_low * a.minus_low, a.high * a.high);
    // The end nearer to zero, negated where it counts as a factor so that it rounds upwards.
    const double near = std::max(-a.minus_low, -a.high);
    x.minus_low = near > 0 ? -near * near : 0;
    return x;
}

Interval Div(const Interval& a, const Interval& by) {
    const Interval b = Settle(by);
    const double least = std::max(-b.minus_low, -b.high);
    if (!(least >= kLeastNormal && b.magnitude <= 0x1p126)) {
        return Anything();
    }
    Interval x = a;
    x.peak = a.peak * std::max(1.0, 1 / least);
    if (a.magnitude == 0) {
        return Unsigned(x);
    }
    const double low_a = a.low();
    const double low_b = b.low();
    x.high = std::max(std::max(low_a / low_b, low_a / b.high),
                      std::max(a.high / low_b, a.high / b.high));
    x.minus_low = std::max(std::max(a.minus_low / low_b, a.minus_low / b.high),
                           std::max(-a.high / low_b, -a.high / b.high));
    x.magnitude = a.magnitude / least;
    const double ulps = Held::profile().division_ulp;
    // As one factor among others the quotient may be made of a reciprocal, rounded once more; so
    // may that of a factor that has cost nothing so far.
    x.factors = a.factors + static_cast<float>(ulps) + (a.is_scaled ? 2.0f : 1.0f);
    x.error =
        a.IsSettled() && !a.is_scaled
            ? ulps * RoundingOf(x.magnitude)
            : ErrorInAnyOrder(a) / least + (ulps + (a.is_scaled ? 1 : 0)) * kEpsilon * x.magnitude;
    x.quantum = 0;
    x.finest = 0;
    x.is_quotient = a.IsSettled() && !a.is_scaled;
    x.sign = static_cast<std::int16_t>(b.high > 0 ? a.sign : -a.sign);
    return x;
}

Interval FromBits(std::uint32_t bits) {
    const double x = static_cast<double>(std::bit_cast<float>(bits));
    if (x - x != 0) {
        return Anything();
    }
    Interval point = Settled(-x, x);
    if (x == 0) {
        point.minus_low = -x;
        point.high = x;
    }
    return point;
}

Interval FromDouble(double x) {
    return Settled(FloatAbove(-x), FloatAbove(x));
}

}  // namespace interval
}  // namespace etalon::evaluate
