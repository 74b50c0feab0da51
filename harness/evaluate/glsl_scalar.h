// GLSL.std.450 of numbers, component by component.
#pragma once

#include "evaluate/machine.h"
#include "evaluate/number.h"

namespace etalon::evaluate::glsl {

// ETALON_FLOATS_n(name, expression of the numbers a, b, c; O are their operations)
#define ETALON_FLOATS_1(name, expression)                                    \
    template <typename N>                                                    \
    void name(Machine<N>& m, const evaluate::Step& step) {                   \
        using O [[maybe_unused]] = Ops<N>;                                   \
        m.FloatsToFloats1(step, [](const N& a) -> N { return expression; }); \
    }
#define ETALON_FLOATS_2(name, expression)                                                \
    template <typename N>                                                                \
    void name(Machine<N>& m, const evaluate::Step& step) {                               \
        using O [[maybe_unused]] = Ops<N>;                                               \
        m.FloatsToFloats2(step, [](const N& a, const N& b) -> N { return expression; }); \
    }
#define ETALON_FLOATS_3(name, expression)                                                      \
    template <typename N>                                                                      \
    void name(Machine<N>& m, const evaluate::Step& step) {                                     \
        using O [[maybe_unused]] = Ops<N>;                                                     \
        m.FloatsToFloats3(step,                                                                \
                          [](const N& a, const N& b, const N& c) -> N { return expression; }); \
    }

inline constexpr std::uint32_t kZeroBits = 0;
inline constexpr std::uint32_t kOneBits = 0x3f800000;
inline constexpr std::uint32_t kTwoBits = 0x40000000;
inline constexpr std::uint32_t kThreeBits = 0x40400000;

template <typename N>
N Zero() {
    return Ops<N>::FromBits(kZeroBits);
}
template <typename N>
N One() {
    return Ops<N>::FromBits(kOneBits);
}
// The number itself where it is a zero or a NaN.
template <typename N>
N Sign(const N& a) {
    using O = Ops<N>;
    if (O::Less(Zero<N>(), a)) {
        return One<N>();
    }
    return O::Less(a, Zero<N>()) ? O::Neg(One<N>()) : a;
}
template <typename N>
N Min(const N& a, const N& b) {
    return Ops<N>::Less(b, a) ? b : a;
}
template <typename N>
N Max(const N& a, const N& b) {
    return Ops<N>::Less(a, b) ? b : a;
}
// What is no NaN, if one of them is none.
template <typename N>
N NumberMin(const N& a, const N& b) {
    return Ops<N>::IsNan(a) ? b : Min(a, b);
}
template <typename N>
N NumberMax(const N& a, const N& b) {
    return Ops<N>::IsNan(a) ? b : Max(a, b);
}
template <typename N>
N Smooth(const N& edge0, const N& edge1, const N& x) {
    using O = Ops<N>;
    const N t = Min(Max(O::Div(O::Sub(x, edge0), O::Sub(edge1, edge0)), Zero<N>()), One<N>());
    return O::Mul(O::Mul(t, t), O::Sub(O::FromBits(kThreeBits), O::Mul(O::FromBits(kTwoBits), t)));
}
template <typename N>
N Degree() {  // in radians, rounded once
    return Ops<N>::Div(Ops<N>::Atan2(Zero<N>(), Ops<N>::Neg(One<N>())), Ops<N>::FromInt(180));
}

ETALON_FLOATS_1(Round, O::RoundEven(a))
ETALON_FLOATS_1(RoundEven, O::RoundEven(a))
ETALON_FLOATS_1(Trunc, O::Trunc(a))
ETALON_FLOATS_1(FAbs, O::Abs(a))
ETALON_FLOATS_1(FSign, Sign(a))
ETALON_FLOATS_1(Floor, O::Floor(a))
ETALON_FLOATS_1(Ceil, O::Ceil(a))
ETALON_FLOATS_1(Fract, O::Sub(a, O::Floor(a)))
ETALON_FLOATS_1(Sin, O::Sin(a))
ETALON_FLOATS_1(Cos, O::Cos(a))
ETALON_FLOATS_1(Tan, O::Tan(a))
ETALON_FLOATS_1(Asin, O::Asin(a))
ETALON_FLOATS_1(Acos, O::Acos(a))
ETALON_FLOATS_1(Atan, O::Atan(a))
ETALON_FLOATS_1(Sinh, O::Sinh(a))
ETALON_FLOATS_1(Cosh, O::Cosh(a))
ETALON_FLOATS_1(Tanh, O::Tanh(a))
ETALON_FLOATS_1(Asinh, O::Asinh(a))
ETALON_FLOATS_1(Acosh, O::Acosh(a))
ETALON_FLOATS_1(Atanh, O::Atanh(a))
ETALON_FLOATS_2(Atan2, O::Atan2(a, b))
ETALON_FLOATS_2(Pow, O::Pow(a, b))
ETALON_FLOATS_1(Exp, O::Exp(a))
ETALON_FLOATS_1(Log, O::Log(a))
ETALON_FLOATS_1(Exp2, O::Exp2(a))
ETALON_FLOATS_1(Log2, O::Log2(a))
ETALON_FLOATS_1(Sqrt, O::Sqrt(a))
ETALON_FLOATS_1(InverseSqrt, O::InverseSqrt(a))
ETALON_FLOATS_2(FMin, NumberMin(a, b))
ETALON_FLOATS_2(FMax, NumberMax(a, b))
ETALON_FLOATS_3(FClamp, NumberMin(NumberMax(a, b), c))
ETALON_FLOATS_3(FMix, O::Add(O::Mul(a, O::Sub(One<N>(), c)), O::Mul(b, c)))
ETALON_FLOATS_2(Step, O::Less(b, a) ? Zero<N>() : One<N>())
ETALON_FLOATS_3(SmoothStep, Smooth(a, b, c))
ETALON_FLOATS_3(Fma, O::Fma(a, b, c))
ETALON_FLOATS_2(NMin, NumberMin(a, b))
ETALON_FLOATS_2(NMax, NumberMax(a, b))
ETALON_FLOATS_3(NClamp, NumberMin(NumberMax(a, b), c))

template <typename N>
void Radians(Machine<N>& m, const evaluate::Step& step) {
    const N degree = Degree<N>();
    m.FloatsToFloats1(step, [&](const N& a) { return Ops<N>::Mul(a, degree); });
}
template <typename N>
void Degrees(Machine<N>& m, const evaluate::Step& step) {
    const N degree = Degree<N>();
    m.FloatsToFloats1(step, [&](const N& a) { return Ops<N>::Div(a, degree); });
}

template <typename N>
void Ldexp(Machine<N>& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const N* a = m.Floats(m.Operand(step, 0).floats + i);
        const std::uint32_t* exponent = m.Words(m.Operand(step, 1).words + i);
        N* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) {
            result[lane] = Ops<N>::Ldexp(a[lane], static_cast<std::int32_t>(exponent[lane]));
        });
    }
}
// The part without the whole number, then the whole number; both have the sign of the number.
template <typename N>
void ModfStruct(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const N* a = m.Floats(m.Operand(step, 0).floats + i);
        N* rest = m.Floats(step.result.floats + i);
        N* whole = m.Floats(step.result.floats + step.components + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const N x = a[lane];
            whole[lane] = O::Trunc(x);
            const N without = O::IsInf(x) ? Zero<N>() : O::Abs(O::Sub(x, whole[lane]));
            rest[lane] = O::IsNegative(x) ? O::Neg(without) : without;
        });
    }
}
template <typename N>
void FrexpStruct(Machine<N>& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const N* a = m.Floats(m.Operand(step, 0).floats + i);
        N* significand = m.Floats(step.result.floats + i);
        std::uint32_t* exponent = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) {
            std::int32_t power = 0;
            significand[lane] = Ops<N>::Frexp(a[lane], power);
            exponent[lane] = static_cast<std::uint32_t>(power);
        });
    }
}

}  // namespace etalon::evaluate::glsl
