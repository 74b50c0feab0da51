// The functions of GLSL.std.450 whose meaning over intervals is not that of their numbers, one by
// one. Included before run.h instantiates them.
#pragma once

#include <numbers>

#include "evaluate/glsl_integer.h"
#include "evaluate/glsl_scalar.h"
#include "evaluate/glsl_vector.h"
#include "evaluate/interval_operations.h"

namespace etalon::evaluate {

namespace glsl {

using operation::IntervalMachine;

template <>
inline Interval Sign(const Interval& a) {
    return interval::Sign(interval::Settle(a));
}
template <>
inline Interval Min(const Interval& a, const Interval& b) {
    return interval::Min(interval::Settle(a), interval::Settle(b));
}
template <>
inline Interval Max(const Interval& a, const Interval& b) {
    return interval::Max(interval::Settle(a), interval::Settle(b));
}
template <>
inline Interval NumberMin(const Interval& a, const Interval& b) {
    return Min(a, b);
}
template <>
inline Interval NumberMax(const Interval& a, const Interval& b) {
    return Max(a, b);
}
// Undefined where the greatest may be less than the least.
inline Interval Clamp(const Interval& a, const Interval& b, const Interval& c) {
    const Interval least = interval::Settle(b);
    const Interval greatest = interval::Settle(c);
    return least.high <= greatest.low() ? Min(Max(a, least), greatest) : interval::Anything();
}
template <>
inline void FClamp(IntervalMachine& m, const evaluate::Step& step) {
    m.FloatsToFloats3(step, Clamp);
}
template <>
inline void NClamp(IntervalMachine& m, const evaluate::Step& step) {
    m.FloatsToFloats3(step, Clamp);
}
template <>
inline Interval Smooth(const Interval& edge0, const Interval& edge1, const Interval& x) {
    return interval::Smoothstep(interval::Settle(edge0), interval::Settle(edge1),
                                interval::Settle(x));
}

template <>
inline void Round(IntervalMachine& m, const evaluate::Step& step) {
    m.FloatsToFloats1(step, [](const Interval& a) { return interval::Round(interval::Settle(a)); });
}
template <>
inline void Fract(IntervalMachine& m, const evaluate::Step& step) {
    m.FloatsToFloats1(step, [](const Interval& a) { return interval::Fract(interval::Settle(a)); });
}
template <>
inline void Step(IntervalMachine& m, const evaluate::Step& step) {
    m.FloatsToFloats2(step, [](const Interval& edge, const Interval& x) {
        return interval::Step(interval::Settle(edge), interval::Settle(x));
    });
}
// x times the rounded constant, which may be either neighbour.
inline Interval Constant(double x) {
    return interval::FromDouble(x);
}
template <>
inline void Radians(IntervalMachine& m, const evaluate::Step& step) {
    const Interval degree = Constant(std::numbers::pi / 180);
    m.FloatsToFloats1(step, [&](const Interval& a) { return interval::Mul(a, degree); });
}
template <>
inline void Degrees(IntervalMachine& m, const evaluate::Step& step) {
    const Interval radian = Constant(180 / std::numbers::pi);
    m.FloatsToFloats1(step, [&](const Interval& a) { return interval::Mul(a, radian); });
}

template <>
inline void ModfStruct(IntervalMachine& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const Interval* a = m.Floats(m.Operand(step, 0).floats + i);
        Interval* rest = m.Floats(step.result.floats + i);
        Interval* whole = m.Floats(step.result.floats + step.components + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const Interval x = interval::Settle(a[lane]);
            whole[lane] = interval::Trunc(x);
            const Interval without = interval::Settle(Ops<Interval>::Sub(x, whole[lane]));
            const Interval open = interval::Settled(x.low() < 0 ? 1 : 0, x.high > 0 ? 1 : 0);
            rest[lane] = whole[lane].IsPoint() || x.IsAnything() ? without : open;
        });
    }
}
// The exponent is chosen, and the significand is what has it.
template <>
inline void FrexpStruct(IntervalMachine& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const Interval* a = m.Floats(m.Operand(step, 0).floats + i);
        Interval* significand = m.Floats(step.result.floats + i);
        std::uint32_t* exponent = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const Interval x = interval::Settle(a[lane]);
            significand[lane] = interval::Anything();
            exponent[lane] = 0;
            if (x.magnitude == 0) {
                significand[lane] = x;
                return;
            }
            int first = 0;
            int last = 0;
            const double low = std::frexp(x.low(), &first);
            const double high = std::frexp(x.high, &last);
            if (x.IsAnything() || (x.low() <= 0 && x.high >= 0) || first != last) {
                m.context.Lose(lane);
                return;
            }
            significand[lane] = interval::Settled(-low, high);
            exponent[lane] = static_cast<std::uint32_t>(first);
        });
    }
}

template <>
inline void Normalize(IntervalMachine& m, const evaluate::Step& step) {
    using O = Ops<Interval>;
    EachLane(m, step, step.components,
             [&](const Lane<Interval>& a, const Lane<Interval>&, const Lane<Interval>&) {
                 Interval square = interval::Square(a[0]);
                 for (std::uint32_t i = 1; i < step.components; ++i) {
                     square = O::Add(square, interval::Square(a[i]));
                 }
                 const Interval inverse = O::InverseSqrt(square);
                 Lane<Interval> result{};
                 for (std::uint32_t i = 0; i < step.components; ++i) {
                     result[i] = O::Mul(a[i], inverse);
                 }
                 return result;
             });
}
template <>
inline Interval LengthOf(const Lane<Interval>& a, std::uint32_t count) {
    Interval square = interval::Square(a[0]);
    for (std::uint32_t i = 1; i < count; ++i) {
        square = interval::Add(square, interval::Square(a[i]));
    }
    const Interval root = Ops<Interval>::Sqrt(square);
    return count == 1 ? interval::Hull(root, Ops<Interval>::Abs(a[0])) : root;
}
template <>
inline void FaceForward(IntervalMachine& m, const evaluate::Step& step) {
    EachLane(m, step, step.components,
             [&](const Lane<Interval>& n, const Lane<Interval>& i, const Lane<Interval>& to) {
                 const Interval cosine = interval::Settle(DotOf(to, i, step.components));
                 Lane<Interval> result{};
                 for (std::uint32_t k = 0; k < step.components; ++k) {
                     const Interval turned = interval::Neg(n[k]);
                     if (cosine.IsAnything()) {
                         result[k] = interval::Anything();
                     } else if (cosine.high < 0) {
                         result[k] = n[k];
                     } else if (cosine.low() >= 0) {
                         result[k] = turned;
                     } else {
                         result[k] =
                             interval::Hull(interval::Settle(n[k]), interval::Settle(turned));
                     }
                 }
                 return result;
             });
}
// Nothing is said of the precision of these.
template <>
inline void Determinant(IntervalMachine& m, const evaluate::Step& step) {
    m.lanes.Each(
        [&](std::uint32_t lane) { m.Floats(step.result.floats)[lane] = interval::Anything(); });
}
template <>
inline void MatrixInverse(IntervalMachine& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        Interval* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] = interval::Anything(); });
    }
}
template <>
inline void Refract(IntervalMachine& m, const evaluate::Step& step) {
    using O = Ops<Interval>;
    EachLane(m, step, step.components,
             [&](const Lane<Interval>& i, const Lane<Interval>& n, const Lane<Interval>& ratio) {
                 const Interval eta = ratio[0];
                 const Interval cosine = DotOf(n, i, step.components);
                 const Interval one = One<Interval>();
                 const Interval k = interval::Settle(O::Sub(
                     one, O::Mul(interval::Square(eta), O::Sub(one, interval::Square(cosine)))));
                 Lane<Interval> result;
                 result.fill(Zero<Interval>());
                 if (k.IsAnything()) {
                     result.fill(interval::Anything());
                     return result;
                 }
                 if (k.high < 0) {
                     return result;
                 }
                 const Interval root =
                     interval::Sqrt(interval::Settled(std::min(0.0, k.minus_low), k.high));
                 const Interval along = O::Add(O::Mul(eta, cosine), root);
                 for (std::uint32_t c = 0; c < step.components; ++c) {
                     const Interval bent = O::Sub(O::Mul(eta, i[c]), O::Mul(along, n[c]));
                     result[c] =
                         k.low() < 0 ? interval::Hull(interval::Settle(bent), result[c]) : bent;
                 }
                 return result;
             });
}

// round(clamp(x) scale), a product that may be rounded either way.
template <std::uint32_t Parts, bool IsSigned>
void PackIntervals(IntervalMachine& m, const evaluate::Step& step) {
    constexpr std::uint32_t kBits = 32 / Parts;
    const Interval scale = Ops<Interval>::FromInt((1 << (kBits - (IsSigned ? 1 : 0))) - 1);
    const Interval low = IsSigned ? interval::Neg(One<Interval>()) : Zero<Interval>();
    std::uint32_t* result = m.Words(step.result.words);
    m.lanes.Each([&](std::uint32_t lane) {
        std::uint32_t word = 0;
        for (std::uint32_t i = 0; i < Parts; ++i) {
            const Interval x = m.Floats(m.Operand(step, 0).floats + i)[lane];
            const Interval scaled =
                interval::Settle(interval::Mul(Min(Max(x, low), One<Interval>()), scale));
            const Interval part = interval::Round(scaled);
            const auto chosen = static_cast<std::uint32_t>(
                m.context.DecideInteger(lane, part.low(), part.high, -0x1p31, 0x1p31 - 1));
            word |= (chosen & ((1u << kBits) - 1)) << (i * kBits);
        }
        result[lane] = word;
    });
}
#define ETALON_PACK_INTERVALS(name, parts, is_signed)                  \
    template <>                                                        \
    inline void name(IntervalMachine& m, const evaluate::Step& step) { \
        PackIntervals<parts, is_signed>(m, step);                      \
    }
ETALON_PACK_INTERVALS(PackSnorm4x8, 4, true)
ETALON_PACK_INTERVALS(PackUnorm4x8, 4, false)
ETALON_PACK_INTERVALS(PackSnorm2x16, 2, true)
ETALON_PACK_INTERVALS(PackUnorm2x16, 2, false)
#undef ETALON_PACK_INTERVALS

// The half towards zero from x, which is not negative.
inline std::uint32_t HalfBelow(double x) {
    constexpr double kLeastNormalHalf = 0x1p-14;
    constexpr double kLargestHalf = 65504;
    if (x < kLeastNormalHalf) {
        return static_cast<std::uint32_t>(x * 0x1p24);
    }
    const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(std::min(x, kLargestHalf)));
    return HalfBits(bits & ~0x1fffu);
}

// A subnormal half may be flushed.
template <>
inline void UnpackHalf2x16(IntervalMachine& m, const evaluate::Step& step) {
    const std::uint32_t* word = m.Words(m.Operand(step, 0).words);
    for (std::uint32_t i = 0; i < 2; ++i) {
        Interval* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const Interval x = interval::FromBits(FloatBits(word[lane] >> (16 * i) & 0xffffu));
            result[lane] = x.magnitude < 0x1p-14 ? interval::Hull(x, Zero<Interval>()) : x;
        });
    }
}

// Either neighbour, of which the infinity is one beyond the largest half; a subnormal half may be
// flushed.
template <>
inline void PackHalf2x16(IntervalMachine& m, const evaluate::Step& step) {
    std::uint32_t* result = m.Words(step.result.words);
    m.lanes.Each([&](std::uint32_t lane) {
        std::uint32_t word = 0;
        for (std::uint32_t i = 0; i < 2; ++i) {
            const Interval x = interval::Settle(m.Floats(m.Operand(step, 0).floats + i)[lane]);
            if (!(x.magnitude <= interval::kLargest) || (x.low() < 0 && x.high > 0)) {
                m.context.Lose(lane);
                continue;
            }
            bool is_negative = x.low() < 0;
            const double inner = is_negative ? -x.high : x.low();
            const double outer = is_negative ? -x.low() : x.high;
            const std::uint32_t first = HalfBelow(inner);
            std::uint32_t last = HalfBelow(outer);
            last += static_cast<double>(std::bit_cast<float>(FloatBits(last))) < outer;
            const std::uint32_t flushed = first != 0 && first < 0x400u;
            std::uint32_t chosen = m.context.Decide(lane, last - first + 1 + flushed);
            chosen = first + chosen > last ? 0 : first + chosen;
            if (chosen == 0) {
                is_negative = m.context.Decide(lane, 2) != 0;
            }
            word |= (chosen | (is_negative ? 0x8000u : 0u)) << (16 * i);
        }
        result[lane] = word;
    });
}

}  // namespace glsl
}  // namespace etalon::evaluate
