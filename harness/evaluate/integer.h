// Integers and their bits. Words are unsigned; where the sign matters they are read as two's
// complement.
#pragma once

#include <limits>

#include "evaluate/machine.h"

namespace etalon::evaluate::operation {

inline std::int32_t Signed(std::uint32_t word) {
    return static_cast<std::int32_t>(word);
}
inline std::uint32_t Word(std::int64_t value) {
    return static_cast<std::uint32_t>(value);
}

// ETALON_WORDS_n(name, expression of the words a, b, c)
#define ETALON_WORDS_1(name, expression)                                                    \
    template <typename N>                                                                   \
    void name(Machine<N>& m, const evaluate::Step& step) {                                  \
        m.WordsToWords1(step, [](std::uint32_t a) -> std::uint32_t { return expression; }); \
    }
#define ETALON_WORDS_2(name, expression)                                                         \
    template <typename N>                                                                        \
    void name(Machine<N>& m, const evaluate::Step& step) {                                       \
        m.WordsToWords2(                                                                         \
            step, [](std::uint32_t a, std::uint32_t b) -> std::uint32_t { return expression; }); \
    }
#define ETALON_WORDS_3(name, expression)                                                         \
    template <typename N>                                                                        \
    void name(Machine<N>& m, const evaluate::Step& step) {                                       \
        m.WordsToWords3(step,                                                                    \
                        [](std::uint32_t a, std::uint32_t b, std::uint32_t c) -> std::uint32_t { \
                            return expression;                                                   \
                        });                                                                      \
    }

// In 64 bits, where the lowest number divided by -1 has a quotient.
inline std::uint32_t Quotient(std::int64_t a, std::int64_t b) {
    return b == 0 ? 0 : Word(a / b);
}
inline std::uint32_t Remainder(std::int64_t a, std::int64_t b) {
    return Word(b == 0 ? a : a % b);
}
// With the sign of the divisor.
inline std::uint32_t Modulus(std::int64_t a, std::int64_t b) {
    const std::int64_t rest = b == 0 ? a : a % b;
    return Word(b != 0 && rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest);
}

ETALON_WORDS_1(SNegate, 0u - a)
ETALON_WORDS_2(IAdd, a + b)
ETALON_WORDS_2(ISub, a - b)
ETALON_WORDS_2(IMul, a* b)
ETALON_WORDS_2(UDiv, Quotient(a, b))
ETALON_WORDS_2(SDiv, Quotient(Signed(a), Signed(b)))
ETALON_WORDS_2(UMod, Remainder(a, b))
ETALON_WORDS_2(SRem, Remainder(Signed(a), Signed(b)))
ETALON_WORDS_2(SMod, Modulus(Signed(a), Signed(b)))
ETALON_WORDS_2(ShiftRightLogical, a >> (b & 31u))
ETALON_WORDS_2(ShiftRightArithmetic, Word(Signed(a) >> (b & 31u)))
ETALON_WORDS_2(ShiftLeftLogical, a << (b & 31u))
ETALON_WORDS_2(BitwiseOr, a | b)
ETALON_WORDS_2(BitwiseXor, a ^ b)
ETALON_WORDS_2(BitwiseAnd, a& b)
ETALON_WORDS_1(Not, ~a)
ETALON_WORDS_1(BitCount, static_cast<std::uint32_t>(std::popcount(a)))

inline std::uint32_t Reverse(std::uint32_t a) {
    std::uint32_t reversed = 0;
    for (int bit = 0; bit < 32; ++bit) {
        reversed = reversed << 1 | (a >> bit & 1u);
    }
    return reversed;
}
ETALON_WORDS_1(BitReverse, Reverse(a))

// A field that leaves the word ends with it.
inline std::uint32_t FieldBits(std::uint32_t offset, std::uint32_t count) {
    if (offset >= 32 || count == 0) {
        return 0;
    }
    const std::uint32_t ones = count >= 32 ? 0xffffffffu : (1u << count) - 1;
    return ones << offset;
}
inline std::uint32_t Extract(std::uint32_t word, std::uint32_t offset, std::uint32_t count) {
    return offset >= 32 ? 0 : (word & FieldBits(offset, count)) >> offset;
}
inline std::uint32_t ExtractSigned(std::uint32_t word, std::uint32_t offset, std::uint32_t count) {
    const std::uint32_t field = Extract(word, offset, count);
    if (count == 0 || count >= 32 || (field >> (count - 1) & 1u) == 0) {
        return field;
    }
    return field | ~((1u << count) - 1);
}
// Offset and count have one component for all.
template <typename N>
void BitFieldInsert(Machine<N>& m, const Step& step) {
    const std::uint32_t* offset = m.Words(m.Operand(step, 2).words);
    const std::uint32_t* count = m.Words(m.Operand(step, 3).words);
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const std::uint32_t* base = m.Words(m.Operand(step, 0).words + i);
        const std::uint32_t* insert = m.Words(m.Operand(step, 1).words + i);
        std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const std::uint32_t bits = FieldBits(offset[lane], count[lane]);
            result[lane] = (base[lane] & ~bits) | (insert[lane] << (offset[lane] & 31u) & bits);
        });
    }
}
template <typename N, typename F>
void ExtractField(Machine<N>& m, const Step& step, F f) {
    const std::uint32_t* offset = m.Words(m.Operand(step, 1).words);
    const std::uint32_t* count = m.Words(m.Operand(step, 2).words);
    for (std::uint32_t i = 0; i < step.components; ++i) {
        const std::uint32_t* base = m.Words(m.Operand(step, 0).words + i);
        std::uint32_t* result = m.Words(step.result.words + i);
        m.lanes.Each(
            [&](std::uint32_t lane) { result[lane] = f(base[lane], offset[lane], count[lane]); });
    }
}
template <typename N>
void BitFieldUExtract(Machine<N>& m, const Step& step) {
    ExtractField(m, step, Extract);
}
template <typename N>
void BitFieldSExtract(Machine<N>& m, const Step& step) {
    ExtractField(m, step, ExtractSigned);
}

// The result is a structure of two values; f yields the second one above the first one's 32 bits.
template <typename N, typename F>
void Pair(Machine<N>& m, const Step& step, F f) {
    const std::uint32_t count = step.components / 2;
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t* a = m.Words(m.Operand(step, 0).words + i);
        const std::uint32_t* b = m.Words(m.Operand(step, 1).words + i);
        std::uint32_t* low = m.Words(step.result.words + i);
        std::uint32_t* high = m.Words(step.result.words + count + i);
        m.lanes.Each([&](std::uint32_t lane) {
            const std::uint64_t both = f(a[lane], b[lane]);
            low[lane] = static_cast<std::uint32_t>(both);
            high[lane] = static_cast<std::uint32_t>(both >> 32);
        });
    }
}
template <typename N>
void IAddCarry(Machine<N>& m, const Step& step) {
    Pair(m, step, [](std::uint64_t a, std::uint64_t b) { return a + b; });
}
template <typename N>
void ISubBorrow(Machine<N>& m, const Step& step) {
    Pair(m, step, [](std::uint64_t a, std::uint64_t b) {
        return ((a - b) & 0xffffffffu) | (a < b ? std::uint64_t{1} << 32 : 0);
    });
}
template <typename N>
void UMulExtended(Machine<N>& m, const Step& step) {
    Pair(m, step, [](std::uint64_t a, std::uint64_t b) { return a * b; });
}
template <typename N>
void SMulExtended(Machine<N>& m, const Step& step) {
    Pair(m, step, [](std::uint32_t a, std::uint32_t b) {
        return static_cast<std::uint64_t>(std::int64_t{Signed(a)} * Signed(b));
    });
}

}  // namespace etalon::evaluate::operation
