// What a number type must offer: Ops<Number>, all static. float and double stand here, Big in
// number_big.h.
//
//   FromBits, ToBits             binary32; ToBits rounds to nearest even
//   FromInt, FromUint            rounded to nearest even
//   ToInt, ToUint                towards zero, saturated, 0 of a NaN
//   Add Sub Mul Div Fma Sqrt     rounded once
//   Neg Abs Floor Ceil Trunc RoundEven Ldexp Frexp Rem (sign of the dividend)    exact
//   Less LessEqual Equal IsNan IsInf IsNegative
//   InverseSqrt Sin Cos Tan Asin Acos Atan Atan2 Sinh Cosh Tanh Asinh Acosh Atanh Exp Log Exp2 Log2
//   Pow
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace etalon::evaluate {

template <typename Number>
struct Ops;

// The host's own formats. Elementary functions are taken in binary64: for float that leaves a
// second rounding to matter once in some 2^28 arguments.
template <typename T>
struct HostOps {
    static T FromBits(std::uint32_t bits) { return static_cast<T>(std::bit_cast<float>(bits)); }
    static std::uint32_t ToBits(T x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); }
    static T FromInt(std::int32_t x) { return static_cast<T>(x); }
    static T FromUint(std::uint32_t x) { return static_cast<T>(x); }
    static std::int32_t ToInt(T x) {
        if (!(x > T(-2147483648.0))) {
            return std::isnan(x) ? 0 : std::numeric_limits<std::int32_t>::min();
        }
        return x >= T(2147483648.0) ? std::numeric_limits<std::int32_t>::max()
                                    : static_cast<std::int32_t>(x);
    }
    static std::uint32_t ToUint(T x) {
        if (!(x > T(0))) {
            return 0;
        }
        return x >= T(4294967296.0) ? std::numeric_limits<std::uint32_t>::max()
                                    : static_cast<std::uint32_t>(x);
    }

    static T Add(T a, T b) { return a + b; }
    static T Sub(T a, T b) { return a - b; }
    static T Mul(T a, T b) { return a * b; }
    static T Div(T a, T b) { return a / b; }
    static T Fma(T a, T b, T c) { return std::fma(a, b, c); }
    static T Sqrt(T x) { return std::sqrt(x); }
    static T Neg(T x) { return -x; }
    static T Abs(T x) { return std::abs(x); }
    static T Floor(T x) { return std::floor(x); }
    static T Ceil(T x) { return std::ceil(x); }
    static T Trunc(T x) { return std::trunc(x); }
    static T RoundEven(T x) { return std::nearbyint(x); }
    static T Rem(T a, T b) { return std::fmod(a, b); }
    static T Ldexp(T x, std::int32_t exponent) { return std::ldexp(x, exponent); }
    static T Frexp(T x, std::int32_t& exponent) {
        exponent = 0;
        return std::isfinite(x) ? std::frexp(x, &exponent) : x;
    }

    static bool Less(T a, T b) { return a < b; }
    static bool LessEqual(T a, T b) { return a <= b; }
    static bool Equal(T a, T b) { return a == b; }
    static bool IsNan(T x) { return x != x; }
    static bool IsInf(T x) { return std::abs(x) == std::numeric_limits<T>::infinity(); }
    static bool IsNegative(T x) { return std::signbit(x); }

    static T InverseSqrt(T x) { return T(1.0 / std::sqrt(static_cast<double>(x))); }
    static T Sin(T x) { return T(std::sin(static_cast<double>(x))); }
    static T Cos(T x) { return T(std::cos(static_cast<double>(x))); }
    static T Tan(T x) { return T(std::tan(static_cast<double>(x))); }
    static T Asin(T x) { return T(std::asin(static_cast<double>(x))); }
    static T Acos(T x) { return T(std::acos(static_cast<double>(x))); }
    static T Atan(T x) { return T(std::atan(static_cast<double>(x))); }
    static T Atan2(T y, T x) {
        return T(std::atan2(static_cast<double>(y), static_cast<double>(x)));
    }
    static T Sinh(T x) { return T(std::sinh(static_cast<double>(x))); }
    static T Cosh(T x) { return T(std::cosh(static_cast<double>(x))); }
    static T Tanh(T x) { return T(std::tanh(static_cast<double>(x))); }
    static T Asinh(T x) { return T(std::asinh(static_cast<double>(x))); }
    static T Acosh(T x) { return T(std::acosh(static_cast<double>(x))); }
    static T Atanh(T x) { return T(std::atanh(static_cast<double>(x))); }
    static T Exp(T x) { return T(std::exp(static_cast<double>(x))); }
    static T Log(T x) { return T(std::log(static_cast<double>(x))); }
    static T Exp2(T x) { return T(std::exp2(static_cast<double>(x))); }
    static T Log2(T x) { return T(std::log2(static_cast<double>(x))); }
    static T Pow(T x, T y) { return T(std::pow(static_cast<double>(x), static_cast<double>(y))); }
};

template <>
struct Ops<float> : HostOps<float> {};
template <>
struct Ops<double> : HostOps<double> {};

}  // namespace etalon::evaluate
