// GLSL.std.450 of integers, and of numbers packed into them.
#pragma once

#include <algorithm>
#include <array>

#include "evaluate/glsl_scalar.h"
#include "evaluate/integer.h"

namespace etalon::evaluate::glsl {

using operation::Signed;
using operation::Word;

ETALON_WORDS_1(SAbs, Signed(a) < 0 ? 0u - a : a)
ETALON_WORDS_1(SSign, Word((Signed(a) > 0) - (Signed(a) < 0)))
ETALON_WORDS_2(UMin, std::min(a, b))
ETALON_WORDS_2(SMin, Word(std::min(Signed(a), Signed(b))))
ETALON_WORDS_2(UMax, std::max(a, b))
ETALON_WORDS_2(SMax, Word(std::max(Signed(a), Signed(b))))
ETALON_WORDS_3(UClamp, std::min(std::max(a, b), c))
ETALON_WORDS_3(SClamp, Word(std::min(std::max(Signed(a), Signed(b)), Signed(c))))

inline constexpr std::uint32_t kNoBit = 0xffffffff;
inline std::uint32_t LowestBit(std::uint32_t a) {
    return a == 0 ? kNoBit : static_cast<std::uint32_t>(std::countr_zero(a));
}
inline std::uint32_t HighestBit(std::uint32_t a) {
    return static_cast<std::uint32_t>(std::bit_width(a)) - 1u;  // -1 of 0
}
ETALON_WORDS_1(FindILsb, LowestBit(a))
ETALON_WORDS_1(FindUMsb, HighestBit(a))
// Of a negative number, the highest bit that is not set.
ETALON_WORDS_1(FindSMsb, HighestBit(Signed(a) < 0 ? ~a : a))

// `Parts` numbers of 32 / Parts bits each; the first has the lowest. `scale` is what 1 becomes.
template <std::uint32_t Parts, bool IsSigned, typename N>
void PackNorm(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    constexpr std::uint32_t kBits = 32 / Parts;
    const N scale = O::FromInt((1 << (kBits - (IsSigned ? 1 : 0))) - 1);
    const N low = IsSigned ? O::Neg(One<N>()) : Zero<N>();
    std::uint32_t* result = m.Words(step.result.words);
    m.lanes.Each([&](std::uint32_t lane) {
        std::uint32_t word = 0;
        for (std::uint32_t i = 0; i < Parts; ++i) {
            const N x = m.Floats(m.Operand(step, 0).floats + i)[lane];
            const N clamped = Min(Max(x, low), One<N>());
            const std::int32_t part = O::ToInt(O::RoundEven(O::Mul(clamped, scale)));
            word |= (static_cast<std::uint32_t>(part) & ((1u << kBits) - 1)) << (i * kBits);
        }
        result[lane] = word;
    });
}
template <std::uint32_t Parts, bool IsSigned, typename N>
void UnpackNorm(Machine<N>& m, const evaluate::Step& step) {
    using O = Ops<N>;
    constexpr std::uint32_t kBits = 32 / Parts;
    const N scale = O::FromInt((1 << (kBits - (IsSigned ? 1 : 0))) - 1);
    const std::uint32_t* word = m.Words(m.Operand(step, 0).words);
    m.lanes.Each([&](std::uint32_t lane) {
        for (std::uint32_t i = 0; i < Parts; ++i) {
            const std::uint32_t part = IsSigned
                                           ? operation::ExtractSigned(word[lane], i * kBits, kBits)
                                           : operation::Extract(word[lane], i * kBits, kBits);
            const N x = O::Div(O::FromInt(Signed(part)), scale);
            m.Floats(step.result.floats + i)[lane] =
                IsSigned ? Min(Max(x, O::Neg(One<N>())), One<N>()) : x;
        }
    });
}
#define ETALON_PACK(name, parts, is_signed)                        \
    template <typename N>                                          \
    void Pack##name(Machine<N>& m, const evaluate::Step& step) {   \
        PackNorm<(parts), (is_signed)>(m, step);                   \
    }                                                              \
    template <typename N>                                          \
    void Unpack##name(Machine<N>& m, const evaluate::Step& step) { \
        UnpackNorm<(parts), (is_signed)>(m, step);                 \
    }
ETALON_PACK(Snorm4x8, 4, true)
ETALON_PACK(Unorm4x8, 4, false)
ETALON_PACK(Snorm2x16, 2, true)
ETALON_PACK(Unorm2x16, 2, false)
#undef ETALON_PACK

// binary16, to nearest even, of the bits of a binary32.
inline std::uint32_t HalfBits(std::uint32_t bits) {
    const std::uint32_t sign = bits >> 16 & 0x8000u;
    const std::uint32_t magnitude = bits & 0x7fffffffu;
    if (magnitude > 0x7f800000u) {
        return sign | 0x7e00u;
    }
    if (magnitude >= 0x47800000u) {  // 2^16
        return sign | 0x7c00u;
    }
    const std::uint32_t exponent = magnitude >> 23;
    if (exponent < 102) {  // below half of the least subnormal number
        return sign;
    }
    // Significands with the one that is not stored; subnormal results have it shifted out.
    const std::uint32_t significand = (magnitude & 0x7fffffu) | 0x800000u;
    const std::uint32_t shift = exponent >= 113 ? 13 : 126 - exponent;
    const std::uint32_t base = exponent >= 113 ? (exponent - 113) << 10 : 0;
    const std::uint32_t kept = significand >> shift;
    const std::uint32_t rest = significand & ((1u << shift) - 1);
    const std::uint32_t half = 1u << (shift - 1);
    const std::uint32_t up = rest > half || (rest == half && (kept & 1u) != 0);
    return sign | (base + kept + up);
}
inline std::uint32_t FloatBits(std::uint32_t half) {
    const std::uint32_t sign = (half & 0x8000u) << 16;
    const std::uint32_t exponent = half >> 10 & 0x1fu;
    const std::uint32_t significand = half & 0x3ffu;
    if (exponent == 0x1f) {
        return sign | 0x7f800000u | significand << 13;
    }
    if (exponent != 0) {
        return sign | (exponent + 112) << 23 | significand << 13;
    }
    // significand / 2^24
    return sign | (significand == 0
                       ? 0
                       : std::bit_cast<std::uint32_t>(static_cast<float>(significand) * 0x1p-24f));
}
template <typename N>
void PackHalf2x16(Machine<N>& m, const evaluate::Step& step) {
    const N* low = m.Floats(m.Operand(step, 0).floats);
    const N* high = m.Floats(m.Operand(step, 0).floats + 1);
    std::uint32_t* result = m.Words(step.result.words);
    m.lanes.Each([&](std::uint32_t lane) {
        result[lane] = HalfBits(Ops<N>::ToBits(low[lane])) | HalfBits(Ops<N>::ToBits(high[lane]))
                                                                 << 16;
    });
}
template <typename N>
void UnpackHalf2x16(Machine<N>& m, const evaluate::Step& step) {
    const std::uint32_t* word = m.Words(m.Operand(step, 0).words);
    N* low = m.Floats(step.result.floats);
    N* high = m.Floats(step.result.floats + 1);
    m.lanes.Each([&](std::uint32_t lane) {
        low[lane] = Ops<N>::FromBits(FloatBits(word[lane] & 0xffffu));
        high[lane] = Ops<N>::FromBits(FloatBits(word[lane] >> 16));
    });
}

}  // namespace etalon::evaluate::glsl
