// The instructions whose meaning over intervals is not that of their numbers, one by one. Included
// before run.h instantiates them.
#pragma once

#include "evaluate/arithmetic.h"
#include "evaluate/interval.h"
#include "evaluate/interval_context.h"
#include "evaluate/memory.h"
#include "evaluate/relation.h"

namespace etalon::evaluate {
namespace operation {

using IntervalMachine = Machine<Interval>;

template <>
inline void AddProduct(IntervalMachine& m, std::uint32_t a, std::uint32_t b, std::uint32_t result,
                       bool is_first) {
    const Interval* left = m.Floats(a);
    const Interval* right = m.Floats(b);
    Interval* sum = m.Floats(result);
    if (is_first && a == b) {
        m.lanes.Each([&](std::uint32_t lane) {
            std::construct_at(&sum[lane], interval::Square(left[lane]));
        });
    } else if (is_first) {
        m.lanes.Each([&](std::uint32_t lane) {
            std::construct_at(&sum[lane], interval::Mul(left[lane], right[lane]));
        });
    } else {
        m.lanes.Each([&](std::uint32_t lane) {
            sum[lane] = interval::Add(sum[lane], a == b ? interval::Square(left[lane])
                                                        : interval::Mul(left[lane], right[lane]));
        });
    }
}
template <>
inline void FMul(IntervalMachine& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        AddProduct(m, m.Operand(step, 0).floats + i, m.Operand(step, 1).floats + i,
                   step.result.floats + i, true);
    }
}
template <>
inline void FMod(IntervalMachine& m, const Step& step) {
    m.FloatsToFloats2(step, [](const Interval& a, const Interval& b) {
        return interval::Mod(interval::Settle(a), interval::Settle(b));
    });
}
template <>
inline void FRem(IntervalMachine& m, const Step& step) {
    m.FloatsToFloats2(step, [](const Interval& a, const Interval& b) {
        return interval::Rem(interval::Settle(a), interval::Settle(b));
    });
}

template <typename F>
void Decided(IntervalMachine& m, const Step& step, F f) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const Interval* a = m.Floats(m.Operand(step, 0).floats + i);
        std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.Each(
            [&](std::uint32_t lane) { result[lane] = f(lane, interval::Settle(a[lane])); });
    }
}

template <>
inline void ConvertFToU(IntervalMachine& m, const Step& step) {
    Decided(m, step, [&](std::uint32_t lane, const Interval& a) {
        return static_cast<std::uint32_t>(
            m.context.DecideInteger(lane, a.low(), a.high, 0, 0x1p32 - 1));
    });
}
template <>
inline void ConvertFToS(IntervalMachine& m, const Step& step) {
    Decided(m, step, [&](std::uint32_t lane, const Interval& a) {
        return static_cast<std::uint32_t>(
            m.context.DecideInteger(lane, a.low(), a.high, -0x1p31, 0x1p31 - 1));
    });
}

// Calls certainly(a, b) and certainly_not(a, b) of settled intervals; where neither is, both ways
// are taken.
template <typename F, typename G>
void Compared(IntervalMachine& m, const Step& step, F certainly, G certainly_not) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const Interval* left = m.Floats(m.Operand(step, 0).floats + i);
        const Interval* right = m.Floats(m.Operand(step, 1).floats + i);
        std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const Interval a = interval::Settle(left[lane]);
            const Interval b = interval::Settle(right[lane]);
            const bool is_open = a.IsAnything() || b.IsAnything();
            if (!is_open && certainly(a, b)) {
                result[lane] = 1;
            } else if (!is_open && certainly_not(a, b)) {
                result[lane] = 0;
            } else {
                result[lane] = m.context.Decide(lane, 2);
            }
        });
    }
}

inline bool AllLess(const Interval& a, const Interval& b) {
    return a.high < b.low();
}
inline bool NoneGreater(const Interval& a, const Interval& b) {
    return a.high <= b.low();
}
inline bool AllEqual(const Interval& a, const Interval& b) {
    return a.IsPoint() && b.IsPoint() && a.high == b.high;
}
inline bool Apart(const Interval& a, const Interval& b) {
    return AllLess(a, b) || AllLess(b, a);
}

// Ordered and unordered comparisons are of numbers, and then the same.
#define ETALON_COMPARE_INTERVALS(name, yes, no)                                \
    template <>                                                                \
    inline void FOrd##name(IntervalMachine& m, const Step& step) {             \
        Compared(                                                              \
            m, step, [](const Interval& a, const Interval& b) { return yes; }, \
            [](const Interval& a, const Interval& b) { return no; });          \
    }                                                                          \
    template <>                                                                \
    inline void FUnord##name(IntervalMachine& m, const Step& step) {           \
        FOrd##name(m, step);                                                   \
    }
ETALON_COMPARE_INTERVALS(Equal, AllEqual(a, b), Apart(a, b))
ETALON_COMPARE_INTERVALS(NotEqual, Apart(a, b), AllEqual(a, b))
ETALON_COMPARE_INTERVALS(LessThan, AllLess(a, b), NoneGreater(b, a))
ETALON_COMPARE_INTERVALS(GreaterThan, AllLess(b, a), NoneGreater(a, b))
ETALON_COMPARE_INTERVALS(LessThanEqual, NoneGreater(a, b), AllLess(b, a))
ETALON_COMPARE_INTERVALS(GreaterThanEqual, NoneGreater(b, a), AllLess(a, b))
#undef ETALON_COMPARE_INTERVALS

template <>
inline void IsNan(IntervalMachine& m, const Step& step) {
    Decided(m, step, [&](std::uint32_t lane, const Interval& a) {
        return a.IsAnything() ? m.context.Decide(lane, 2) : 0;
    });
}
template <>
inline void IsInf(IntervalMachine& m, const Step& step) {
    Decided(m, step, [&](std::uint32_t lane, const Interval& a) {
        return a.magnitude <= interval::kLargest ? 0 : m.context.Decide(lane, 2);
    });
}

// What a variable holds before anything is stored in it is undefined.
template <>
inline void Variable(IntervalMachine& m, const Step& step) {
    if (step.operands != 0) {
        m.Copy(m.Operand(step, 0), step.result, step.size);
        return;
    }
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        Interval* target = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { target[lane] = interval::Anything(); });
    }
    for (std::uint32_t i = 0; i < step.size.words; ++i) {
        std::uint32_t* target = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) { target[lane] = 0; });
    }
}

template <>
inline void LoadOutput(IntervalMachine& m, const Step& step) {
    m.lanes.Each([&](std::uint32_t lane) { m.context.Lose(lane); });
    for (std::uint32_t i = 0; i < step.size.floats; ++i) {
        Interval* result = m.Floats(step.result.floats + i);
        m.lanes.Each([&](std::uint32_t lane) { result[lane] = interval::Anything(); });
    }
}
template <>
inline void StoreOutput(IntervalMachine& m, const Step& step) {
    const Columns from = m.Operand(step, 0);
    // Of a float whose bits are stored, the float.
    const std::uint32_t column = step.size.floats != 0 ? from.floats : step.extra;
    EachPlace(m, step, m.context.bounds.size(), [&](std::uint32_t lane, std::uint32_t place) {
        Bound bound;
        if (column == kNone) {
            bound.kind = Bound::Kind::kWord;
            bound.word = m.Words(from.words)[lane];
        } else if (const Interval x = interval::Settle(m.Floats(column)[lane]); !x.IsAnything()) {
            bound.kind = Bound::Kind::kNumber;
            bound.low = static_cast<float>(x.low());
            bound.high = static_cast<float>(x.high);
            // Rounded upwards: what is below all floats becomes the least of them.
            bound.quantum = static_cast<float>(std::min(x.quantum, 0x1p100));
        }
        m.context.Store(place, bound);
    });
}

}  // namespace operation

}  // namespace etalon::evaluate
