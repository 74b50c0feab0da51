#include "case/bounded.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace etalon {
namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();
// Half a unit in the last place, relative to a value that may lie anywhere in its binade.
constexpr long double kHalfUnit = std::numeric_limits<long double>::epsilon() / 2;
// The C library states at most 4 units for these functions of long double; twice that.
constexpr long double kLibrary = 16 * kHalfUnit;

long double Magnitude(const Bounded& a) {
    return std::fabs(a.value);
}

// |x| error, where an exact operand contributes nothing even beside an infinity.
long double Term(long double x, long double error) {
    return error == 0 ? 0 : std::fabs(x) * error;
}

Bounded Settled(long double value, long double error) {
    if (!std::isfinite(value) || std::isnan(error)) {
        error = error == 0 ? 0 : kInfinity;
    }
    return {value, error};
}

Bounded FromLibrary(long double value, long double error) {
    const long double own = std::isfinite(value) ? std::max(kLibrary * std::fabs(value),
                                                            std::numeric_limits<long double>::min())
                                                 : 0;
    return Settled(value, error + own);
}

bool IsFloat(long double x) {
    return static_cast<long double>(static_cast<float>(x)) == x;
}

bool IsInteger(const Bounded& a) {
    return a.error == 0 && std::floor(a.value) == a.value && std::isfinite(a.value);
}

Bounded Condition(bool holds, bool decided) {
    return {holds ? 1.0L : 0.0L, decided ? 0.0L : 1.0L};
}

// Whether a < b, a == b and so on cannot change within the bounds.
bool Decided(const Bounded& a, const Bounded& b) {
    const long double reach = a.error + b.error;
    return reach == 0 || std::fabs(a.value - b.value) > reach * (1 + 4 * kHalfUnit);
}

bool IsTrue(const Bounded& a) {
    return a.value != 0;
}

bool IsDecided(const Bounded& a) {
    return a.error == 0 || Magnitude(a) > a.error;
}

}  // namespace

Bounded operator+(const Bounded& a, const Bounded& b) {
    const long double sum = a.value + b.value;
    const long double second = sum - a.value;
    const long double rounding = (a.value - (sum - second)) + (b.value - second);  // exact (Knuth)
    const long double own = std::isfinite(sum) ? std::fabs(rounding) : 0;
    return Settled(sum, a.error + b.error + own);
}

Bounded operator-(const Bounded& a) {
    return {-a.value, a.error};
}

Bounded operator-(const Bounded& a, const Bounded& b) {
    return a + -b;
}

Bounded operator*(const Bounded& a, const Bounded& b) {
    const long double product = a.value * b.value;
    const bool exact = IsFloat(a.value) && IsFloat(b.value);
    const long double own = exact ? 0 : kHalfUnit * std::fabs(product);
    return Settled(product, Term(a.value, b.error) + Term(b.value, a.error) +
                                Term(a.error, b.error) + (std::isfinite(product) ? own : 0));
}

Bounded operator/(const Bounded& a, const Bounded& b) {
    const long double quotient = a.value / b.value;
    if (b.error > 0 && Magnitude(b) <= b.error) {
        return {quotient, kInfinity};
    }
    const long double apart = a.error + Term(quotient, b.error);
    const long double propagated = apart == 0 ? 0 : apart / (Magnitude(b) - b.error);
    const bool finite = std::isfinite(quotient);
    return Settled(quotient, propagated + (finite ? kHalfUnit * std::fabs(quotient) : 0));
}

Bounded Sqrt(const Bounded& a) {
    return Monotone([](long double x) { return std::sqrt(x); }, a, 0, kInfinity);
}

Bounded Power(const Bounded& base, const Bounded& exponent) {
    const long double value =
        base.value == 2 ? std::exp2(exponent.value) : std::pow(base.value, exponent.value);
    if (base.error == 0 && exponent.error == 0) {
        return FromLibrary(value, 0);
    }
    const long double low = base.value - base.error;
    const long double high = base.value + base.error;
    if (low > 0) {
        // x^y changes by the factor exp(t) at most, and exp(t) - 1 <= t + t^2 where t <= 1.
        const long double shift = base.error / low;
        const auto logarithm = std::fabs(std::log(static_cast<double>(base.value))) * (1 + 1e-12);
        const long double t = (Magnitude(exponent) + exponent.error) * shift +
                              (logarithm + 1e-12L + shift) * exponent.error;
        if (t <= 1) {
            return FromLibrary(value, std::fabs(value) * (t + t * t) * (1 + kLibrary));
        }
        // Monotone in either operand while the other stays: the extremes lie at the corners.
        long double error = 0;
        for (const long double x : {low, high}) {
            for (const long double y :
                 {exponent.value - exponent.error, exponent.value + exponent.error}) {
                const long double corner = std::pow(x, y);
                error = std::max(error, std::fabs(corner - value) + kLibrary * corner);
            }
        }
        return FromLibrary(value, error);
    }
    const long double widest = Magnitude(base) + base.error;
    if (IsInteger(exponent) && exponent.value >= 1) {
        // |d(x^y)| <= y widest^(y - 1) |dx|
        const long double slope = exponent.value * std::pow(widest, exponent.value - 1);
        return FromLibrary(value, Term(slope, base.error) * (1 + kLibrary));
    }
    if (IsInteger(exponent) && Magnitude(base) > base.error) {
        const long double nearest = Magnitude(base) - base.error;
        const long double slope = exponent.value * std::pow(nearest, exponent.value - 1);
        return FromLibrary(value, Term(slope, base.error) * (1 + kLibrary));
    }
    if (exponent.error == 0 && exponent.value > 0 && high >= 0) {
        const long double from_zero = std::pow(std::max(base.value, 0.0L), exponent.value);
        return FromLibrary(from_zero, std::pow(high, exponent.value) * (1 + kLibrary));
    }
    return {value, kInfinity};
}

// A NaN stays one on either side: GLSL leaves open which operand it is, so there is no truth.
Bounded Minimum(const Bounded& a, const Bounded& b) {
    const long double value = std::min(a.value, b.value);
    return {std::isnan(b.value) ? b.value : value, std::max(a.error, b.error)};
}

Bounded Maximum(const Bounded& a, const Bounded& b) {
    const long double value = std::max(a.value, b.value);
    return {std::isnan(b.value) ? b.value : value, std::max(a.error, b.error)};
}

Bounded Absolute(const Bounded& a) {
    return {std::fabs(a.value), a.error};
}

Bounded Floor(const Bounded& a) {
    const long double value = std::floor(a.value);
    return Settled(value, std::max(value - std::floor(a.value - a.error),
                                   std::floor(a.value + a.error) - value));
}

Bounded Modulo(const Bounded& a, const Bounded& b) {
    const long double remainder = std::fmod(a.value, b.value);  // exact
    Bounded result{remainder, 0};
    if (remainder != 0 && std::signbit(remainder) != std::signbit(b.value)) {
        result = result + Bounded{b.value, 0};
    }
    if (a.error == 0 && b.error == 0) {
        return result;
    }
    const Bounded turns = Floor(a / b);
    if (turns.error != 0) {
        return Settled(result.value, Magnitude(b) + b.error);
    }
    return Settled(result.value, result.error + a.error + Term(turns.value, b.error));
}

Bounded Monotone(long double (*function)(long double), const Bounded& a, long double low,
                 long double high) {
    const long double value =
        function(a.error == 0 ? a.value
                              : std::clamp(a.value, std::min(low, a.value + a.error),
                                           std::max(high, a.value - a.error)));
    if (a.error == 0) {
        return FromLibrary(value, 0);
    }
    const bool outside = a.value + a.error < low || a.value - a.error > high;
    if (outside || std::isnan(a.value)) {
        return {function(a.value), 0};
    }
    const long double first = function(std::max(a.value - a.error, low));
    const long double last = function(std::min(a.value + a.error, high));
    const long double error = std::max(std::fabs(last - value), std::fabs(value - first));
    const long double largest = std::max(std::fabs(first), std::fabs(last));
    return FromLibrary(value, error + kLibrary * largest);
}

Bounded Sloped(long double value, const Bounded& a, long double slope, long double span) {
    return FromLibrary(value, std::min(Term(slope, a.error) * (1 + kLibrary), span));
}

Bounded Arctangent(const Bounded& y, const Bounded& x) {
    const long double value = std::atan2(y.value, x.value);
    if (y.error == 0 && x.error == 0) {
        return FromLibrary(value, 0);
    }
    constexpr long double kTurn = 2 * std::numbers::pi_v<long double>;
    const long double nearest =
        std::hypot(std::max(Magnitude(x) - x.error, 0.0L), std::max(Magnitude(y) - y.error, 0.0L));
    const bool crosses_cut = x.value - x.error < 0 && Magnitude(y) <= y.error;
    if (crosses_cut || !(nearest > 0)) {
        return FromLibrary(value, kTurn);
    }
    return FromLibrary(value, std::min((x.error + y.error) / nearest * (1 + kLibrary), kTurn));
}

Bounded Less(const Bounded& a, const Bounded& b) {
    return Condition(a.value < b.value, Decided(a, b));
}

Bounded LessEqual(const Bounded& a, const Bounded& b) {
    return Condition(a.value <= b.value, Decided(a, b));
}

Bounded Equal(const Bounded& a, const Bounded& b) {
    return Condition(a.value == b.value, Decided(a, b));
}

Bounded Not(const Bounded& a) {
    return Condition(!IsTrue(a), IsDecided(a));
}

Bounded And(const Bounded& a, const Bounded& b) {
    const bool decided_false = (IsDecided(a) && !IsTrue(a)) || (IsDecided(b) && !IsTrue(b));
    return Condition(IsTrue(a) && IsTrue(b), decided_false || (IsDecided(a) && IsDecided(b)));
}

Bounded Or(const Bounded& a, const Bounded& b) {
    return Not(And(Not(a), Not(b)));
}

}  // namespace etalon
