#include <spirv/unified1/GLSL.std.450.h>

#include <unordered_map>

#include "spirv/check.h"

namespace etalon::spirv {
namespace {

using Kind = Type::Kind;

enum class GlslRule : std::uint8_t {
    kFloats,
    kInts,
    kDeterminant,
    kInverse,
    kModf,
    kModfStruct,
    kFrexp,
    kFrexpStruct,
    kLdexp,
    kPack2,
    kPack4,
    kUnpack2,
    kUnpack4,
    kLength,
    kCross,
    kRefract,
};

struct Row {
    const char* name;
    std::uint32_t operands;
    GlslRule rule;
};

const std::unordered_map<std::uint32_t, Row>& Rows() {
    static const std::unordered_map<std::uint32_t, Row> rows = {
#define ETALON_GLSL(name, operands, rule) {GLSLstd450##name, {#name, operands, GlslRule::rule}},
#include "spirv/glsl.def"
#undef ETALON_GLSL
    };
    return rows;
}

bool Fits(const Module& module, GlslRule rule, std::uint32_t result_type,
          std::span<const std::uint32_t> values) {
    const auto type = [&](std::size_t i) { return module.values[values[i]].type; };
    const auto numbers = [&](std::size_t i) { return NumbersOf(module, type(i)); };
    const Numbers result = NumbersOf(module, result_type);
    const Numbers word{Kind::kInt, 32, 1};
    const Type& first = module.types[type(0)];
    const Type& whole = module.types[result_type];
    const auto is_square = [&](const Type& matrix) {
        return matrix.kind == Kind::kMatrix && module.types[matrix.element].count == matrix.count;
    };
    const auto pair = [&](Kind second) {
        if (whole.kind != Kind::kStruct || whole.members.size() != 2) {
            return false;
        }
        const Numbers b = NumbersOf(module, whole.members[1]);
        return numbers(0).kind == Kind::kFloat && whole.members[0] == type(0) && b.kind == second &&
               b.width == numbers(0).width && b.count == numbers(0).count;
    };
    const auto pointer = [&](Kind target) {
        const Type& to = module.types[type(1)];
        if (to.kind != Kind::kPointer) {
            return false;
        }
        const Numbers second = NumbersOf(module, to.element);
        return result.kind == Kind::kFloat && numbers(0) == result && second.kind == target &&
               second.width == result.width && second.count == result.count;
    };
    switch (rule) {
        case GlslRule::kFloats:
        case GlslRule::kInts: {
            bool good = result.kind == (rule == GlslRule::kFloats ? Kind::kFloat : Kind::kInt);
            for (std::size_t i = 0; i < values.size(); ++i) {
                good = good && numbers(i) == result;
            }
            return good;
        }
        case GlslRule::kDeterminant:
            return is_square(first) && result_type == module.types[first.element].element;
        case GlslRule::kInverse:
            return is_square(first) && result_type == type(0);
        case GlslRule::kModf:
            return pointer(Kind::kFloat);
        case GlslRule::kFrexp:
            return pointer(Kind::kInt);
        case GlslRule::kModfStruct:
            return pair(Kind::kFloat);
        case GlslRule::kFrexpStruct:
            return pair(Kind::kInt);
        case GlslRule::kLdexp:
            return result.kind == Kind::kFloat && numbers(0) == result &&
                   numbers(1).kind == Kind::kInt && numbers(1).count == result.count &&
                   numbers(1).width == 32;
        case GlslRule::kPack2:
            return result == word && numbers(0) == Numbers{Kind::kFloat, 32, 2};
        case GlslRule::kPack4:
            return result == word && numbers(0) == Numbers{Kind::kFloat, 32, 4};
        case GlslRule::kUnpack2:
            return result == Numbers{Kind::kFloat, 32, 2} && numbers(0) == word;
        case GlslRule::kUnpack4:
            return result == Numbers{Kind::kFloat, 32, 4} && numbers(0) == word;
        case GlslRule::kLength:
            return result.kind == Kind::kFloat && result.count == 1 &&
                   numbers(0).kind == Kind::kFloat && numbers(0).width == result.width &&
                   (values.size() == 1 || numbers(1) == numbers(0));
        case GlslRule::kCross:
            return result.kind == Kind::kFloat && result.count == 3 && numbers(0) == result &&
                   numbers(1) == result;
        case GlslRule::kRefract:
            return result.kind == Kind::kFloat && numbers(0) == result && numbers(1) == result &&
                   numbers(2).kind == Kind::kFloat && numbers(2).count == 1 &&
                   numbers(2).width == result.width;
    }
    return false;
}

}  // namespace

std::string GlslName(std::uint32_t instruction) {
    const auto found = Rows().find(instruction);
    return found == Rows().end() ? "" : found->second.name;
}

std::optional<std::string> CheckGlsl(const Module& module, const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module.Operands(instruction);
    const auto found = Rows().find(operands[0]);
    if (found == Rows().end()) {
        return "instruction " + std::to_string(operands[0]) + " of GLSL.std.450 is not known";
    }
    const std::string name = found->second.name;
    const std::span<const std::uint32_t> values = operands.subspan(1);
    if (values.size() != found->second.operands) {
        return name + " has " + std::to_string(values.size()) + " operands";
    }
    if (!Fits(module, found->second.rule, instruction.type, values)) {
        return name + ": its operands are of the wrong types";
    }
    return {};
}

}  // namespace etalon::spirv
