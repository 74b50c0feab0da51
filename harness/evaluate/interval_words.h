// Bit casts between intervals and words, and what keeps the range of words that they make.
#pragma once

#include "evaluate/interval_glsl.h"

namespace etalon::evaluate {
namespace operation {

// Words of one sign; which sign that is has been decided.
inline WordRange BitsOf(IntervalMachine& m, std::uint32_t lane, const Interval& a) {
    constexpr std::uint32_t kMagnitude = ~kSignBit;
    const auto bits = [](double x) { return std::bit_cast<std::uint32_t>(static_cast<float>(x)); };
    const bool is_anything = a.IsAnything();
    const bool may_be_negative = is_anything || std::signbit(a.low());
    const bool may_be_positive = is_anything || !std::signbit(a.high);
    const bool is_negative =
        may_be_negative && (!may_be_positive || m.context.Decide(lane, 2) != 0);
    if (is_anything) {
        return is_negative ? WordRange{kSignBit, kSignBit | kMagnitude} : WordRange{0, kMagnitude};
    }
    if (is_negative) {
        return {may_be_positive ? kSignBit : bits(a.high), bits(a.low())};
    }
    return {may_be_negative ? 0 : bits(a.low()), bits(a.high)};
}

inline Interval FloatOf(WordRange range) {
    if (range.IsPoint()) {
        return interval::FromBits(range.first);
    }
    constexpr std::uint32_t kInfinityBits = 0x7f800000;
    const bool is_negative = (range.first & kSignBit) != 0;
    if ((range.last & ~kSignBit) > kInfinityBits) {
        return interval::Anything();
    }
    const auto first = static_cast<double>(std::bit_cast<float>(range.first));
    const auto last = static_cast<double>(std::bit_cast<float>(range.last));
    return is_negative ? interval::Settled(-last, first) : interval::Settled(-first, last);
}

template <>
inline void Bitcast(IntervalMachine& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const Columns from = m.Operand(step, 0) + Columns{i, i};
        const Columns to = step.result + Columns{i, i};
        m.lanes.Each([&](std::uint32_t lane) {
            const bool is_float = step.extra != 0;
            if (step.size.floats != 0) {
                m.Floats(to.floats)[lane] = is_float
                                                ? m.Floats(from.floats)[lane]
                                                : FloatOf(m.context.RangeAt(m, from.words, lane));
            } else if (is_float && step.is_output_only) {
                // StoreOutput looks at the float.
                m.RawWords(to.words)[lane] = 0;
            } else {
                m.context.SetRange(
                    m, to.words, lane,
                    is_float ? BitsOf(m, lane, interval::Settle(m.Floats(from.floats)[lane]))
                             : m.context.RangeAt(m, from.words, lane));
            }
        });
    }
}

// f(range, range) for each component.
template <typename F>
void RangesToRanges2(IntervalMachine& m, const Step& step, F f) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const std::uint32_t a = m.Operand(step, 0).words + i;
        const std::uint32_t b = m.Operand(step, 1).words + i;
        m.lanes.Each([&](std::uint32_t lane) {
            m.context.SetRange(m, step.result.words + i, lane,
                               f(m.context.RangeAt(m, a, lane), m.context.RangeAt(m, b, lane)));
        });
    }
}

// Where an operand is a range, and keeps(range, range) is not true of it, its word is decided.
template <typename Keeps, typename F>
void RangesOrWords2(IntervalMachine& m, const Step& step, Keeps keeps, F f) {
    for (std::uint32_t i = 0; m.context.has_ranges && i < step.components; ++i) {
        const std::uint32_t a = m.Operand(step, 0).words + i;
        const std::uint32_t b = m.Operand(step, 1).words + i;
        bool keeps_all = true;
        m.lanes.mask.Each([&](std::uint32_t lane) {
            const WordRange left = m.context.RangeAt(m, a, lane);
            const WordRange right = m.context.RangeAt(m, b, lane);
            keeps_all = keeps_all && ((left.IsPoint() && right.IsPoint()) || keeps(left, right));
        });
        if (!keeps_all) {
            m.context.Close(m, a);
            m.context.Close(m, b);
        }
    }
    RangesToRanges2(m, step, f);
}

inline bool IsSignMask(WordRange mask) {
    return mask.IsPoint() && (mask.first == kSignBit || mask.first == ~kSignBit);
}
template <>
inline void BitwiseAnd(IntervalMachine& m, const Step& step) {
    RangesOrWords2(
        m, step, [](WordRange a, WordRange b) { return IsSignMask(a) || IsSignMask(b); },
        [](WordRange a, WordRange b) {
            return WordRange{a.first & b.first, a.last & b.last};
        });
}
inline bool IsSign(WordRange sign) {
    return sign.IsPoint() && (sign.first == kSignBit || sign.first == 0);
}
template <>
inline void BitwiseOr(IntervalMachine& m, const Step& step) {
    RangesOrWords2(
        m, step, [](WordRange a, WordRange b) { return IsSign(a) || IsSign(b); },
        [](WordRange a, WordRange b) {
            return WordRange{a.first | b.first, a.last | b.last};
        });
}

// Calls certainly(a, b) and certainly_not(a, b) of ranges; where neither is, both ways are taken.
template <typename F, typename G>
void ComparedWords(IntervalMachine& m, const Step& step, F certainly, G certainly_not) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const std::uint32_t a = m.Operand(step, 0).words + i;
        const std::uint32_t b = m.Operand(step, 1).words + i;
        std::uint32_t* result = m.RawWords(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const WordRange left = m.context.RangeAt(m, a, lane);
            const WordRange right = m.context.RangeAt(m, b, lane);
            const bool is_certain = certainly(left, right);
            result[lane] =
                is_certain || certainly_not(left, right) ? is_certain : m.context.Decide(lane, 2);
        });
    }
}
template <typename T>
T As(std::uint32_t word) {
    return static_cast<T>(word);
}
template <typename T>
bool AllBelow(WordRange a, WordRange b) {
    return As<T>(a.last) < As<T>(b.first);
}
template <typename T>
bool NoneAbove(WordRange a, WordRange b) {
    return As<T>(a.last) <= As<T>(b.first);
}
#define ETALON_COMPARE_WORDS(name, yes, no)                        \
    template <>                                                    \
    inline void name(IntervalMachine& m, const Step& step) {       \
        ComparedWords(                                             \
            m, step, [](WordRange a, WordRange b) { return yes; }, \
            [](WordRange a, WordRange b) { return no; });          \
    }
#define ETALON_COMPARE_WORDS_AS(letter, type)                                                \
    ETALON_COMPARE_WORDS(letter##LessThan, AllBelow<type>(a, b), NoneAbove<type>(b, a))      \
    ETALON_COMPARE_WORDS(letter##GreaterThan, AllBelow<type>(b, a), NoneAbove<type>(a, b))   \
    ETALON_COMPARE_WORDS(letter##LessThanEqual, NoneAbove<type>(a, b), AllBelow<type>(b, a)) \
    ETALON_COMPARE_WORDS(letter##GreaterThanEqual, NoneAbove<type>(b, a), AllBelow<type>(a, b))
ETALON_COMPARE_WORDS_AS(S, std::int32_t)
ETALON_COMPARE_WORDS_AS(U, std::uint32_t)
#undef ETALON_COMPARE_WORDS_AS
#undef ETALON_COMPARE_WORDS

template <>
inline void Select(IntervalMachine& m, const Step& step) {
    const bool is_common = step.extra == 1;
    const Columns if_true = m.Operand(step, 1);
    const Columns if_false = m.Operand(step, 2);
    for (std::uint32_t i = 0; i < step.size.floats + step.size.words; ++i) {
        const std::uint32_t* condition = m.Words(m.Operand(step, 0).words + (is_common ? 0 : i));
        m.lanes.Each([&](std::uint32_t lane) {
            const Columns from = condition[lane] != 0 ? if_true : if_false;
            if (i < step.size.floats) {
                m.Floats(step.result.floats + i)[lane] = m.Floats(from.floats + i)[lane];
            } else {
                const std::uint32_t word = i - step.size.floats;
                m.context.SetRange(m, step.result.words + word, lane,
                                   m.context.RangeAt(m, from.words + word, lane));
            }
        });
    }
}

}  // namespace operation

namespace glsl {

using operation::As;
using operation::RangesToRanges2;

template <typename T>
WordRange MinOf(WordRange a, WordRange b) {
    return {static_cast<std::uint32_t>(std::min(As<T>(a.first), As<T>(b.first))),
            static_cast<std::uint32_t>(std::min(As<T>(a.last), As<T>(b.last)))};
}
template <typename T>
WordRange MaxOf(WordRange a, WordRange b) {
    return {static_cast<std::uint32_t>(std::max(As<T>(a.first), As<T>(b.first))),
            static_cast<std::uint32_t>(std::max(As<T>(a.last), As<T>(b.last)))};
}
template <typename T>
void ClampRanges(IntervalMachine& m, const evaluate::Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        m.lanes.Each([&](std::uint32_t lane) {
            const auto range = [&](std::uint32_t operand) {
                return m.context.RangeAt(m, m.Operand(step, operand).words + i, lane);
            };
            m.context.SetRange(m, step.result.words + i, lane,
                               MinOf<T>(MaxOf<T>(range(0), range(1)), range(2)));
        });
    }
}
#define ETALON_RANGES(letter, type)                                             \
    template <>                                                                 \
    inline void letter##Min(IntervalMachine& m, const evaluate::Step& step) {   \
        RangesToRanges2(m, step, MinOf<type>);                                  \
    }                                                                           \
    template <>                                                                 \
    inline void letter##Max(IntervalMachine& m, const evaluate::Step& step) {   \
        RangesToRanges2(m, step, MaxOf<type>);                                  \
    }                                                                           \
    template <>                                                                 \
    inline void letter##Clamp(IntervalMachine& m, const evaluate::Step& step) { \
        ClampRanges<type>(m, step);                                             \
    }
ETALON_RANGES(S, std::int32_t)
ETALON_RANGES(U, std::uint32_t)
#undef ETALON_RANGES

}  // namespace glsl
}  // namespace etalon::evaluate
