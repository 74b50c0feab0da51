// Big: binary floating-point numbers of 576 bits of significand and an exponent without practical
// end, by MPFR; each operation is rounded once, to nearest even. See Ops in number.h.
#pragma once

#include <array>
#include <cstdint>

#include "evaluate/number.h"

namespace etalon::evaluate {

// Sums and differences of products of any two floats are exact: their bits lie between 2^-298 and
// 2^256. Where 1 - x * x is rounded, a small x looks like a wrong method.
inline constexpr int kBigBits = 576;

// Holds its digits itself, so that columns of it can be copied.
struct Big {
    std::array<std::uint64_t, kBigBits / 64> digits;
    std::int64_t exponent;
    std::int32_t kind;  // MPFR's word for its sign and for zero, infinity and NaN

    Big();  // zero
    // Rounded to nearest even.
    double ToDouble() const;
    static Big FromDouble(double x);
};

template <>
struct Ops<Big> {
    static Big FromBits(std::uint32_t bits);
    static std::uint32_t ToBits(const Big& x);
    static Big FromInt(std::int32_t x);
    static Big FromUint(std::uint32_t x);
    static std::int32_t ToInt(const Big& x);
    static std::uint32_t ToUint(const Big& x);
    static Big Add(const Big& a, const Big& b);
    static Big Sub(const Big& a, const Big& b);
    static Big Mul(const Big& a, const Big& b);
    static Big Div(const Big& a, const Big& b);
    static Big Fma(const Big& a, const Big& b, const Big& c);
    static Big Sqrt(const Big& x);
    static Big Neg(const Big& x);
    static Big Abs(const Big& x);
    static Big Floor(const Big& x);
    static Big Ceil(const Big& x);
    static Big Trunc(const Big& x);
    static Big RoundEven(const Big& x);
    static Big Rem(const Big& a, const Big& b);
    static Big Ldexp(const Big& x, std::int32_t exponent);
    static Big Frexp(const Big& x, std::int32_t& exponent);
    static bool Less(const Big& a, const Big& b);
    static bool LessEqual(const Big& a, const Big& b);
    static bool Equal(const Big& a, const Big& b);
    static bool IsNan(const Big& x);
    static bool IsInf(const Big& x);
    static bool IsNegative(const Big& x);
    static Big InverseSqrt(const Big& x);
    static Big Sin(const Big& x);
    static Big Cos(const Big& x);
    static Big Tan(const Big& x);
    static Big Asin(const Big& x);
    static Big Acos(const Big& x);
    static Big Atan(const Big& x);
    static Big Atan2(const Big& y, const Big& x);
    static Big Sinh(const Big& x);
    static Big Cosh(const Big& x);
    static Big Tanh(const Big& x);
    static Big Asinh(const Big& x);
    static Big Acosh(const Big& x);
    static Big Atanh(const Big& x);
    static Big Exp(const Big& x);
    static Big Log(const Big& x);
    static Big Exp2(const Big& x);
    static Big Log2(const Big& x);
    static Big Pow(const Big& x, const Big& y);
};

}  // namespace etalon::evaluate
