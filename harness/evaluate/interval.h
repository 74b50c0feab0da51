// Interval: every value that a conforming implementation may have in a float's place.
//
// A sum of products may be computed in any order, contracted, and with factors multiplied in or
// taken out. So the operations + - * (and division's numerator) round nothing. They carry the
// exact value of the whole expression and what bounds the rounding of each arrangement of it: the
// same expression over absolute values, which no arrangement changes, and the number of its
// roundings (running error analysis: Higham, Accuracy and Stability of Numerical Algorithms, 3.3).
// Settle() turns that into the floats that may come out; it is taken where a value meets an
// operation that no arrangement passes (a function, a comparison, an output, NoContraction).
//
// All arithmetic here expects the processor to round upwards (FE_UPWARD), and files that include
// this header to be compiled with -frounding-math. Lower ends are kept negated, so that rounding
// upwards widens them too.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include "evaluate/number.h"
#include "evaluate/profile.h"

namespace etalon::evaluate {

struct Interval {
    static constexpr double kInfinity = std::numeric_limits<double>::infinity();
    static constexpr double kZeroQuantum = 0x1p500;

    double minus_low = 0;           // of the exact value
    double high = 0;                //
    double magnitude = 0;           // sum of the terms' absolute values
    double error = 0;               // bound on what the products' roundings add up to
    double quantum = kZeroQuantum;  // every term is a multiple of it
    double peak = 1;                // no part of any term is beyond it
    float sums = 0;                 // additions on a term's way into the sum, at most
    float factors = 0;              // roundings in the making of a term, at most
    float finest = 1;               // every product of some factors of a term is a multiple of it
    std::int16_t sign = 1;          // 1: no term is negative, -1: none is positive, 0: neither
    bool is_scaled = false;         // by powers of two, or a zero added, which is not counted
    bool is_quotient = false;       // of settled values, and nothing more

    // A zero whose sign is not known goes from -0 to +0.
    double low() const { return -minus_low; }
    // Not an expression any more, but the floats in [low, high].
    bool IsSettled() const { return sums == 0 && factors == 0; }
    // Of a settled one: any float, and NaN.
    bool IsAnything() const { return minus_low == kInfinity && high == kInfinity; }
    bool IsPoint() const { return minus_low == -high; }
};

namespace interval {

inline constexpr double kEpsilon = 0x1p-23;
inline constexpr double kLeastNormal = 0x1p-126;
inline constexpr double kLargest = std::numeric_limits<float>::max();

// A bound on the ulp of values up to x, and so on their rounding: the greatest power of two below
// x / 2^23. At a power of two the ulp is that of the floats below it.
inline double RoundingOf(double x) {
    const double least = std::max(x, 2 * kLeastNormal);
    const std::uint64_t below = std::bit_cast<std::uint64_t>(least) - 1;
    const std::uint64_t power = below & 0x7ff0000000000000u;
    return std::bit_cast<double>(power) * kEpsilon;
}

// The greatest power of two that divides x, which is not zero.
inline double LowestBit(double x) {
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t fraction = bits & 0x000fffffffffffffu;
    const std::uint64_t power = bits & 0x7ff0000000000000u;
    if (fraction == 0) {
        return std::bit_cast<double>(power);
    }
    const auto below = static_cast<std::uint64_t>(52 - std::countr_zero(fraction));
    return std::bit_cast<double>(power - (below << 52));
}

// Of a settled value. What is finer than all floats need not be told apart.
inline float FinestOf(double quantum) {
    return quantum < 1 ? static_cast<float>(quantum) : 1.0f;
}

inline double FloatAbove(double x) {
    return static_cast<double>(static_cast<float>(x));
}
inline double FloatBelow(double x) {
    return -static_cast<double>(static_cast<float>(-x));
}

inline Interval Anything() {
    Interval x;
    x.minus_low = x.high = x.magnitude = x.peak = Interval::kInfinity;
    x.sign = 0;
    return x;
}

// The floats in [-minus_low, high], both of them floats or infinite; subnormal ones may have been
// flushed.
inline Interval Settled(double minus_low, double high) {
    if (!(-minus_low <= high)) {
        return Anything();
    }
    Interval x;
    x.minus_low = minus_low <= 0 && minus_low > -kLeastNormal ? 0 : minus_low;
    x.high = high <= 0 && high > -kLeastNormal ? 0 : high;
    x.magnitude = std::max(x.minus_low, x.high);
    x.peak = std::max(1.0, x.magnitude);
    const int negative_or_neither = x.high <= 0 ? -1 : 0;
    x.sign = static_cast<std::int16_t>(x.minus_low <= 0 ? 1 : negative_or_neither);
    if (x.IsPoint()) {
        x.quantum = x.high == 0 ? Interval::kZeroQuantum : LowestBit(x.high);
    } else {
        const double least = std::max({-x.minus_low, -x.high, 0.0});
        x.quantum = RoundingOf(least);
    }
    x.finest = FinestOf(x.quantum);
    return x;
}

// The floats that an implementation may have in the expression's place.
Interval SettleExpression(const Interval& x);
inline Interval Settle(const Interval& x) {
    return x.IsSettled() && !x.is_scaled ? x : SettleExpression(x);
}

// No operation need keep the sign of a zero.
inline Interval Unsigned(Interval zero) {
    zero.minus_low = zero.high = 0;
    return zero;
}

inline Interval Neg(const Interval& x) {
    Interval result = x;
    std::swap(result.minus_low, result.high);
    result.sign = static_cast<std::int16_t>(-x.sign);
    return x.magnitude == 0 ? Unsigned(result) : result;
}

// True for a settled power of two: taken out of a sum it changes no rounding.
inline bool IsPowerOfTwo(const Interval& x) {
    return x.magnitude == x.quantum && x.IsSettled() && x.IsPoint();
}

inline Interval Add(const Interval& a, const Interval& b) {
    // Adding zero rounds nothing; but a zero times what may overflow may be a NaN.
    if (a.magnitude == 0 || b.magnitude == 0) {
        const Interval& zero = a.magnitude == 0 ? a : b;
        if (zero.peak > kLargest) {
            return Anything();
        }
        Interval x = a.magnitude == 0 ? b : a;
        x.is_scaled = x.is_scaled || zero.is_scaled || !zero.IsSettled();
        x.peak = std::max(a.peak, b.peak);
        x.finest = std::min(a.finest, b.finest);
        return x.magnitude == 0 ? Unsigned(x) : x;
    }
    Interval x;
    x.minus_low = a.minus_low + b.minus_low;
    x.high = a.high + b.high;
    x.magnitude = a.magnitude + b.magnitude;
    x.error = a.error + b.error;
    x.quantum = std::min(a.quantum, b.quantum);
    x.peak = a.peak + b.peak;
    x.sums = a.sums + b.sums + 1;
    x.factors = std::max(a.factors, b.factors);
    x.finest = std::min(a.finest, b.finest);
    x.sign = a.sign == b.sign ? a.sign : std::int16_t{0};
    x.is_scaled = a.is_scaled || b.is_scaled;
    // Where a common factor may be taken out, a sum is rounded in the products' place.
    if (x.factors > 0 && !IsPowerOfTwo(a) && !IsPowerOfTwo(b)) {
        x.error = std::max(x.error, static_cast<double>(x.factors) * kEpsilon * x.magnitude);
    }
    return x;
}

Interval Mul(const Interval& a, const Interval& b);
Interval Square(const Interval& a);
Interval Div(const Interval& a, const Interval& b);

// Functions of settled intervals; the result is settled.
Interval Sqrt(const Interval& x);
Interval InverseSqrt(const Interval& x);
Interval Exp(const Interval& x);
Interval Exp2(const Interval& x);
Interval Log(const Interval& x);
Interval Log2(const Interval& x);
Interval Pow(const Interval& x, const Interval& y);
Interval Sin(const Interval& x);
Interval Cos(const Interval& x);
Interval Tan(const Interval& x);
Interval Asin(const Interval& x);
Interval Acos(const Interval& x);
Interval Atan(const Interval& x);
Interval Atan2(const Interval& y, const Interval& x);
Interval Sinh(const Interval& x);
Interval Cosh(const Interval& x);
Interval Tanh(const Interval& x);
Interval Asinh(const Interval& x);
Interval Acosh(const Interval& x);
Interval Atanh(const Interval& x);
Interval Floor(const Interval& x);
Interval Ceil(const Interval& x);
Interval Trunc(const Interval& x);
Interval Round(const Interval& x);  // halves either way
Interval RoundEven(const Interval& x);
Interval Fract(const Interval& x);
Interval Mod(const Interval& x, const Interval& y);  // of the sign of y
Interval Rem(const Interval& x, const Interval& y);  // of the sign of x
Interval Abs(const Interval& x);
Interval Sign(const Interval& x);
Interval Min(const Interval& a, const Interval& b);
Interval Max(const Interval& a, const Interval& b);
Interval Step(const Interval& edge, const Interval& x);
Interval Smoothstep(const Interval& edge0, const Interval& edge1, const Interval& x);
Interval Ldexp(const Interval& x, std::int32_t exponent);
Interval Hull(const Interval& a, const Interval& b);

Interval FromBits(std::uint32_t bits);
// Of 2^24 and beyond, either neighbour.
Interval FromDouble(double x);

}  // namespace interval

template <>
struct Ops<Interval> {
    static Interval FromBits(std::uint32_t bits) { return interval::FromBits(bits); }
    static Interval FromInt(std::int32_t x) { return interval::FromDouble(x); }
    static Interval FromUint(std::uint32_t x) { return interval::FromDouble(x); }
    static Interval Add(const Interval& a, const Interval& b) { return interval::Add(a, b); }
    static Interval Sub(const Interval& a, const Interval& b) {
        return interval::Add(a, interval::Neg(b));
    }
    static Interval Mul(const Interval& a, const Interval& b) { return interval::Mul(a, b); }
    static Interval Div(const Interval& a, const Interval& b) { return interval::Div(a, b); }
    static Interval Fma(const Interval& a, const Interval& b, const Interval& c) {
        return interval::Add(interval::Mul(a, b), c);
    }
    static Interval Neg(const Interval& x) { return interval::Neg(x); }

#define ETALON_SETTLED(name)                        \
    static Interval name(const Interval& x) {       \
        return interval::name(interval::Settle(x)); \
    }
    ETALON_SETTLED(Abs)
    ETALON_SETTLED(Floor)
    ETALON_SETTLED(Ceil)
    ETALON_SETTLED(Trunc)
    ETALON_SETTLED(RoundEven)
    ETALON_SETTLED(Sqrt)
    ETALON_SETTLED(InverseSqrt)
    ETALON_SETTLED(Sin)
    ETALON_SETTLED(Cos)
    ETALON_SETTLED(Tan)
    ETALON_SETTLED(Asin)
    ETALON_SETTLED(Acos)
    ETALON_SETTLED(Atan)
    ETALON_SETTLED(Sinh)
    ETALON_SETTLED(Cosh)
    ETALON_SETTLED(Tanh)
    ETALON_SETTLED(Asinh)
    ETALON_SETTLED(Acosh)
    ETALON_SETTLED(Atanh)
    ETALON_SETTLED(Exp)
    ETALON_SETTLED(Log)
    ETALON_SETTLED(Exp2)
    ETALON_SETTLED(Log2)
#undef ETALON_SETTLED
#define ETALON_SETTLED(name)                                             \
    static Interval name(const Interval& a, const Interval& b) {         \
        return interval::name(interval::Settle(a), interval::Settle(b)); \
    }
    ETALON_SETTLED(Atan2)
    ETALON_SETTLED(Pow)
    ETALON_SETTLED(Rem)
#undef ETALON_SETTLED
    static Interval Ldexp(const Interval& x, std::int32_t exponent) {
        return interval::Ldexp(interval::Settle(x), exponent);
    }
};

// What arithmetic on this thread is held to. Exists while the thread rounds upwards.
class Held {
  public:
    explicit Held(const Profile& profile);
    ~Held();
    Held(const Held&) = delete;
    Held& operator=(const Held&) = delete;
    static const Profile& profile();

  private:
    int rounding_;
};

}  // namespace etalon::evaluate
