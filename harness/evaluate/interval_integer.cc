#include "evaluate/interval_integer.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <spirv/unified1/spirv.hpp11>

#include "evaluate/integer.h"

namespace etalon::evaluate::operation {
namespace {

bool IsQuotientUndefined(std::uint32_t a, std::uint32_t b) {
    return b == 0 || (Signed(b) == -1 && Signed(a) == std::numeric_limits<std::int32_t>::min());
}

// GLSL leaves the remainder of a negative integer open; SPIR-V's has the sign of the divisor.
bool IsModulusUndefined(std::uint32_t a, std::uint32_t b) {
    const bool is_negative = Signed(a) < 0 || Signed(b) < 0;
    return IsQuotientUndefined(a, b) || (is_negative && !Held::profile().defines_negative_modulus);
}

bool IsOutsideOfWord(std::uint32_t offset, std::uint32_t count) {
    return std::uint64_t{offset} + count > 32;
}

// Of the words of operands `first` and `first` + 1, component by component.
template <typename F>
void LoseWhere(Machine<Interval>& m, const Step& step, std::size_t first, std::uint32_t components,
               F is_undefined) {
    for (std::uint32_t i = 0; i < components; ++i) {
        const std::uint32_t* a = m.Words(m.Operand(step, first).words + i);
        const std::uint32_t* b = m.Words(m.Operand(step, first + 1).words + i);
        m.lanes.mask.Each([&](std::uint32_t lane) {
            if (is_undefined(a[lane], b[lane])) {
                m.context.Lose(lane);
            }
        });
    }
}

// Where the greatest may be less than the least. These are no words yet, but ranges.
template <typename T>
void LoseEmptyClamps(Machine<Interval>& m, const Step& step) {
    for (std::uint32_t i = 0; i < step.components; ++i) {
        m.lanes.mask.Each([&](std::uint32_t lane) {
            const auto range = [&](std::uint32_t operand) {
                return m.context.RangeAt(m, m.Operand(step, operand).words + i, lane);
            };
            if (static_cast<T>(range(1).last) > static_cast<T>(range(2).first)) {
                m.context.Lose(lane);
            }
        });
    }
}

}  // namespace

void LoseUndefined(Machine<Interval>& m, const Step& step) {
    if (step.code >= kGlslCode) {
        switch (step.code - kGlslCode) {
            case GLSLstd450UClamp:
                return LoseEmptyClamps<std::uint32_t>(m, step);
            case GLSLstd450SClamp:
                return LoseEmptyClamps<std::int32_t>(m, step);
            default:
                return;
        }
    }
    switch (static_cast<spv::Op>(step.code)) {
        case spv::Op::OpUDiv:
        case spv::Op::OpUMod:
            return LoseWhere(m, step, 0, step.components,
                             [](std::uint32_t, std::uint32_t b) { return b == 0; });
        case spv::Op::OpSDiv:
        case spv::Op::OpSRem:
            return LoseWhere(m, step, 0, step.components, IsQuotientUndefined);
        case spv::Op::OpSMod:
            return LoseWhere(m, step, 0, step.components, IsModulusUndefined);
        case spv::Op::OpShiftLeftLogical:
        case spv::Op::OpShiftRightLogical:
        case spv::Op::OpShiftRightArithmetic:
            return LoseWhere(m, step, 0, step.components,
                             [](std::uint32_t, std::uint32_t count) { return count >= 32; });
        case spv::Op::OpBitFieldInsert:
            return LoseWhere(m, step, 2, 1, IsOutsideOfWord);
        case spv::Op::OpBitFieldSExtract:
        case spv::Op::OpBitFieldUExtract:
            return LoseWhere(m, step, 1, 1, IsOutsideOfWord);
        default:
            return;
    }
}

}  // namespace etalon::evaluate::operation
