// Relations, logic and choice. A bool is 0 or 1.
#pragma once

#include "evaluate/integer.h"
#include "evaluate/machine.h"
#include "evaluate/number.h"

namespace etalon::evaluate::operation {

template <typename N>
void Any(Machine<N>& m, const Step& step) {
    m.Copy(m.Operand(step, 0), step.result, {0, 1});
    std::uint32_t* result = m.Words(step.result.words);
    for (std::uint32_t i = 1; i < step.extra; ++i) {
        const std::uint32_t* a = m.Words(m.Operand(step, 0).words + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] |= a[lane]; });
    }
}
template <typename N>
void All(Machine<N>& m, const Step& step) {
    m.Copy(m.Operand(step, 0), step.result, {0, 1});
    std::uint32_t* result = m.Words(step.result.words);
    for (std::uint32_t i = 1; i < step.extra; ++i) {
        const std::uint32_t* a = m.Words(m.Operand(step, 0).words + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] &= a[lane]; });
    }
}

ETALON_WORDS_2(LogicalEqual, a == b)
ETALON_WORDS_2(LogicalNotEqual, a != b)
ETALON_WORDS_2(LogicalOr, a | b)
ETALON_WORDS_2(LogicalAnd, a& b)
ETALON_WORDS_1(LogicalNot, a ^ 1u)
ETALON_WORDS_2(IEqual, a == b)
ETALON_WORDS_2(INotEqual, a != b)
ETALON_WORDS_2(UGreaterThan, a > b)
ETALON_WORDS_2(SGreaterThan, Signed(a) > Signed(b))
ETALON_WORDS_2(UGreaterThanEqual, a >= b)
ETALON_WORDS_2(SGreaterThanEqual, Signed(a) >= Signed(b))
ETALON_WORDS_2(ULessThan, a < b)
ETALON_WORDS_2(SLessThan, Signed(a) < Signed(b))
ETALON_WORDS_2(ULessThanEqual, a <= b)
ETALON_WORDS_2(SLessThanEqual, Signed(a) <= Signed(b))

// ETALON_COMPARE(name, expression of the numbers a and b)
#define ETALON_COMPARE(name, expression)                                                      \
    template <typename N>                                                                     \
    void name(Machine<N>& m, const evaluate::Step& step) {                                    \
        using O [[maybe_unused]] = Ops<N>;                                                    \
        m.FloatsToWords2(step,                                                                \
                         [](const N& a, const N& b) -> std::uint32_t { return expression; }); \
    }

ETALON_COMPARE(FOrdEqual, O::Equal(a, b))
ETALON_COMPARE(FUnordEqual, !(O::Less(a, b) || O::Less(b, a)))
ETALON_COMPARE(FOrdNotEqual, O::Less(a, b) || O::Less(b, a))
ETALON_COMPARE(FUnordNotEqual, !O::Equal(a, b))
ETALON_COMPARE(FOrdLessThan, O::Less(a, b))
ETALON_COMPARE(FUnordLessThan, !O::LessEqual(b, a))
ETALON_COMPARE(FOrdGreaterThan, O::Less(b, a))
ETALON_COMPARE(FUnordGreaterThan, !O::LessEqual(a, b))
ETALON_COMPARE(FOrdLessThanEqual, O::LessEqual(a, b))
ETALON_COMPARE(FUnordLessThanEqual, !O::Less(b, a))
ETALON_COMPARE(FOrdGreaterThanEqual, O::LessEqual(b, a))
ETALON_COMPARE(FUnordGreaterThanEqual, !O::Less(a, b))

template <typename N>
void IsNan(Machine<N>& m, const Step& step) {
    m.FloatsToWords1(step, [](const N& a) -> std::uint32_t { return Ops<N>::IsNan(a); });
}
template <typename N>
void IsInf(Machine<N>& m, const Step& step) {
    m.FloatsToWords1(step, [](const N& a) -> std::uint32_t { return Ops<N>::IsInf(a); });
}

// One condition for all components, or one for each.
template <typename N>
void Select(Machine<N>& m, const Step& step) {
    const bool is_common = step.extra == 1;
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        const std::uint32_t* condition = m.Words(m.Operand(step, 0).words + (is_common ? 0 : i));
        const N* a = m.Floats(m.Operand(step, 1).floats + i);
        const N* b = m.Floats(m.Operand(step, 2).floats + i);
        N* result = m.Floats(step.result.floats + i);
        m.lanes.Each(
            [&](std::uint32_t lane) { result[lane] = condition[lane] != 0 ? a[lane] : b[lane]; });
    }
    for (std::uint32_t i = 0; i < step.size.words; ++i) {
        const std::uint32_t* condition = m.Words(m.Operand(step, 0).words + (is_common ? 0 : i));
        const std::uint32_t* a = m.Words(m.Operand(step, 1).words + i);
        const std::uint32_t* b = m.Words(m.Operand(step, 2).words + i);
        std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.Each(
            [&](std::uint32_t lane) { result[lane] = condition[lane] != 0 ? a[lane] : b[lane]; });
    }
}

}  // namespace etalon::evaluate::operation
