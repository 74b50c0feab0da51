#include "run/source_terms.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <string_view>
#include <unordered_map>

#include "numeric/number_text.h"
#include "spirv/watch.h"

namespace etalon {
namespace {

using Kind = spirv::Type::Kind;

// How an instruction is written: "+" between its operands, or a function's name.
struct Form {
    const char* text = "";
    bool is_infix = false;
};

Form FormOf(spv::Op op) {
    static const std::unordered_map<std::uint32_t, Form> forms = [] {
        std::unordered_map<std::uint32_t, Form> table;
        const auto add = [&](const char* text, bool is_infix, std::initializer_list<spv::Op> ops) {
            for (const spv::Op one : ops) {
                table[static_cast<std::uint32_t>(one)] = {text, is_infix};
            }
        };
        using spv::Op;
        add("+", true, {Op::OpFAdd});
        add("-", true, {Op::OpFSub});
        add("*", true,
            {Op::OpFMul, Op::OpVectorTimesScalar, Op::OpMatrixTimesScalar, Op::OpVectorTimesMatrix,
             Op::OpMatrixTimesVector, Op::OpMatrixTimesMatrix});
        add("/", true, {Op::OpFDiv});
        add("==", true, {Op::OpFOrdEqual, Op::OpFUnordEqual});
        add("!=", true, {Op::OpFOrdNotEqual, Op::OpFUnordNotEqual});
        add("<", true, {Op::OpFOrdLessThan, Op::OpFUnordLessThan});
        add(">", true, {Op::OpFOrdGreaterThan, Op::OpFUnordGreaterThan});
        add("<=", true, {Op::OpFOrdLessThanEqual, Op::OpFUnordLessThanEqual});
        add(">=", true, {Op::OpFOrdGreaterThanEqual, Op::OpFUnordGreaterThanEqual});
        add("-", false, {Op::OpFNegate});
        add("mod", false, {Op::OpFMod});
        add("rem", false, {Op::OpFRem});
        add("dot", false, {Op::OpDot});
        add("outerProduct", false, {Op::OpOuterProduct});
        add("int", false, {Op::OpConvertFToS});
        add("uint", false, {Op::OpConvertFToU});
        add("float", false, {Op::OpConvertSToF, Op::OpConvertUToF});
        add("isnan", false, {Op::OpIsNan});
        add("isinf", false, {Op::OpIsInf});
        add("textureLod", false, {Op::OpImageSampleExplicitLod});
        add("texelFetch", false, {Op::OpImageFetch});
        return table;
    }();
    const auto found = forms.find(static_cast<std::uint32_t>(op));
    return found == forms.end() ? Form{} : found->second;
}

std::string GlslFunction(std::uint32_t number) {
    static const std::unordered_map<std::string_view, const char*> names = {
        {"FAbs", "abs"},
        {"FSign", "sign"},
        {"FMin", "min"},
        {"FMax", "max"},
        {"FClamp", "clamp"},
        {"NMin", "min"},
        {"NMax", "max"},
        {"NClamp", "clamp"},
        {"FMix", "mix"},
        {"Atan2", "atan"},
        {"SmoothStep", "smoothstep"},
        {"InverseSqrt", "inversesqrt"},
        {"FaceForward", "faceforward"},
        {"MatrixInverse", "inverse"},
        {"ModfStruct", "modf"},
        {"FrexpStruct", "frexp"}};
    std::string name = spirv::GlslName(number);
    if (const auto found = names.find(name); found != names.end()) {
        return found->second;
    }
    if (!name.empty()) {
        name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    }
    return name;
}

bool IsUsersName(const std::string& name) {
    // Copies of arguments are called "param" by the compiler.
    return !name.empty() && name != "param" && !name.starts_with("etalon_");
}

std::string Joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : ", ") + word;
    }
    return text;
}

std::string Component(std::uint32_t index) {
    constexpr std::string_view kNames = "xyzw";
    return index < kNames.size() ? std::string(".") + kNames[index]
                                 : "[" + std::to_string(index) + "]";
}

}  // namespace

SourceTerms::SourceTerms(const spirv::Module& module)
    : module_(module), definitions_(module.values.size(), nullptr) {
    for (const spirv::Function& function : module.functions) {
        for (const spirv::Block& block : function.blocks) {
            for (const spirv::Instruction& instruction : block.instructions) {
                if (instruction.result != spirv::kNone) {
                    definitions_[instruction.result] = &instruction;
                }
            }
        }
    }
}

std::string SourceTerms::Glsl(const spirv::Instruction& instruction,
                              const std::vector<std::string>& operands) const {
    if (instruction.op == spv::Op::OpExtInst) {
        return GlslFunction(module_.Operands(instruction)[0]) + "(" + Joined(operands) + ")";
    }
    const Form form = FormOf(instruction.op);
    if (form.is_infix && operands.size() == 2) {
        // Of vectors GLSL has functions for comparisons; the sign is as clear.
        return operands[0] + " " + form.text + " " + operands[1];
    }
    if (instruction.op == spv::Op::OpFNegate) {
        return form.text + operands[0];
    }
    std::string name = form.text;
    if (name.empty()) {
        name = spirv::OpName(instruction.op);
    }
    return name + "(" + Joined(operands) + ")";
}

std::string SourceTerms::TypeName(std::uint32_t type) const {
    const spirv::Type& outer = module_.types[type];
    switch (outer.kind) {
        case Kind::kFloat:
            return "float";
        case Kind::kBool:
            return "bool";
        case Kind::kInt:
            return outer.is_signed ? "int" : "uint";
        case Kind::kVector: {
            const spirv::Type& element = module_.types[outer.element];
            const char* prefix = element.kind == Kind::kFloat  ? ""
                                 : element.kind == Kind::kBool ? "b"
                                 : element.is_signed           ? "i"
                                                               : "u";
            return prefix + ("vec" + std::to_string(outer.count));
        }
        case Kind::kMatrix:
            return "mat" + std::to_string(outer.count) + "x" +
                   std::to_string(module_.types[outer.element].count);
        default:
            return "";
    }
}

// The name of a part; `type` becomes the part's.
std::string SourceTerms::Part(std::uint32_t& type, std::uint32_t index) const {
    const spirv::Type& outer = module_.types[type];
    if (outer.kind == Kind::kStruct) {
        type = outer.members[index];
        return "." + (index < outer.member_names.size() && !outer.member_names[index].empty()
                          ? outer.member_names[index]
                          : std::to_string(index));
    }
    type = outer.element;
    return outer.kind == Kind::kVector ? Component(index) : "[" + std::to_string(index) + "]";
}

std::string SourceTerms::LeafName(std::uint32_t type, std::uint32_t leaf) const {
    const std::vector<spirv::Leaf> leaves = spirv::Leaves(module_, type);
    std::string name;
    for (const std::uint32_t index : leaves[leaf].path) {
        name += Part(type, index);
    }
    return name;
}

std::string SourceTerms::Constant(std::uint32_t value) const {
    const spirv::Value& source = module_.values[value];
    const spirv::Type& type = module_.types[source.type];
    const spirv::Constant& constant = module_.constants[source.index];
    if (constant.members.empty()) {
        const std::uint32_t word = constant.is_null ? 0 : constant.words[0];
        switch (type.kind) {
            case Kind::kFloat: {
                std::string text = WordText(Scalar::kFloat, word);
                const bool is_whole = text.find_first_not_of("-0123456789") == std::string::npos;
                return is_whole ? text + ".0" : text;
            }
            case Kind::kInt:
                return WordText(type.is_signed ? Scalar::kInt : Scalar::kUint, word);
            case Kind::kBool:
                return WordText(Scalar::kBool, word);
            default:
                return TypeName(source.type).empty() ? "" : TypeName(source.type) + "(0.0)";
        }
    }
    if (TypeName(source.type).empty()) {
        return "";
    }
    std::vector<std::string> members;
    for (const std::uint32_t member : constant.members) {
        members.push_back(Constant(member));
    }
    const bool is_one = type.kind == Kind::kVector &&
                        std::all_of(members.begin(), members.end(),
                                    [&](const std::string& one) { return one == members.front(); });
    return TypeName(source.type) + "(" + (is_one ? members.front() : Joined(members)) + ")";
}

std::string SourceTerms::Pointer(std::uint32_t value) const {
    const spirv::Instruction* definition = definitions_[value];
    if (definition == nullptr) {
        const std::string& name = module_.values[value].name;
        return IsUsersName(name) ? name : "";
    }
    if (definition->op != spv::Op::OpAccessChain &&
        definition->op != spv::Op::OpInBoundsAccessChain) {
        return "";
    }
    const std::span<const std::uint32_t> operands = module_.Operands(*definition);
    std::string name = Pointer(operands[0]);
    if (name.empty()) {
        return "";
    }
    std::uint32_t type = module_.TypeOf(operands[0]).element;
    for (const std::uint32_t index : operands.subspan(1)) {
        const spirv::Value& source = module_.values[index];
        if (source.kind == spirv::Value::Kind::kConstant) {
            const spirv::Constant& constant = module_.constants[source.index];
            name += Part(type, constant.is_null ? 0 : constant.words[0]);
        } else {
            const std::string text = Text(index);
            name += "[" + (text.empty() ? "..." : text) + "]";
            type = module_.types[type].element;
        }
    }
    return name;
}

// Empty where the value has no words of the source.
std::string SourceTerms::Text(std::uint32_t value) const {
    const spirv::Value& source = module_.values[value];
    switch (source.kind) {
        case spirv::Value::Kind::kConstant:
            return Constant(value);
        case spirv::Value::Kind::kParameter:
        case spirv::Value::Kind::kVariable:
            return IsUsersName(source.name) ? source.name : "";
        case spirv::Value::Kind::kResult:
            break;
    }
    const spirv::Instruction* definition = definitions_[value];
    if (definition == nullptr) {
        return "";
    }
    const std::span<const std::uint32_t> operands = module_.Operands(*definition);
    switch (definition->op) {
        case spv::Op::OpLoad:
            return Pointer(operands[0]);
        case spv::Op::OpCompositeExtract: {
            std::string text = Text(operands[0]);
            std::uint32_t type = module_.values[operands[0]].type;
            for (const std::uint32_t index : operands.subspan(1)) {
                const std::string part = Part(type, index);
                text += text.empty() ? "" : part;
            }
            return text;
        }
        case spv::Op::OpVectorShuffle: {
            std::string text = Text(operands[0]);
            const std::uint32_t count = module_.TypeOf(operands[0]).count;
            std::string swizzle = ".";
            for (const std::uint32_t index : operands.subspan(2)) {
                if (index >= std::min(count, 4u)) {
                    return "";
                }
                swizzle += "xyzw"[index];
            }
            return text.empty() ? "" : text + swizzle;
        }
        case spv::Op::OpCompositeConstruct: {
            std::vector<std::string> parts;
            for (const std::uint32_t operand : operands) {
                parts.push_back(Text(operand));
                if (parts.back().empty()) {
                    return "";
                }
            }
            const std::string name = TypeName(definition->type);
            const bool is_one = std::all_of(parts.begin(), parts.end(), [&](const auto& part) {
                return part == parts.front();
            });
            const bool is_vector = module_.types[definition->type].kind == Kind::kVector;
            return name.empty()
                       ? ""
                       : name + "(" + (is_one && is_vector ? parts.front() : Joined(parts)) + ")";
        }
        default:
            return "";
    }
}

// "#3"; "#3.y" of a vector.
std::string SourceTerms::Label(const evaluate::Trace& trace, const evaluate::Origin& origin) const {
    const evaluate::TracedStep& step = trace.steps[origin.step];
    return "#" + std::to_string(origin.step + 1) +
           (step.numbers.size() > 1 ? LeafName(step.instruction->type, origin.number) : "");
}

std::string SourceTerms::Operand(const evaluate::Trace& trace, std::uint32_t value,
                                 const std::vector<evaluate::TracedOperand>& numbers,
                                 const std::vector<std::uint32_t>& words) const {
    if (std::string text = Text(value); !text.empty()) {
        return text;
    }
    std::vector<std::string> parts;
    bool is_whole = !numbers.empty() && numbers.front().origin.step != spirv::kNone;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const evaluate::Origin& origin = numbers[i].origin;
        is_whole = is_whole && origin == evaluate::Origin{numbers.front().origin.step,
                                                          static_cast<std::uint32_t>(i)};
        parts.push_back(
            origin.step == spirv::kNone
                ? WordText(Scalar::kFloat, std::bit_cast<std::uint32_t>(numbers[i].value))
                : Label(trace, origin));
    }
    if (is_whole && numbers.size() == trace.steps[numbers.front().origin.step].numbers.size()) {
        return "#" + std::to_string(numbers.front().origin.step + 1);
    }
    for (const std::uint32_t word : words) {
        parts.push_back(WordText(Scalar::kInt, word));
    }
    return parts.size() == 1 ? parts.front()
                             : TypeName(module_.values[value].type) + "(" + Joined(parts) + ")";
}

std::string SourceTerms::Operation(const evaluate::Trace& trace,
                                   const evaluate::TracedStep& step) const {
    std::vector<std::string> operands;
    const std::vector<std::uint32_t> values = evaluate::OperandValues(module_, *step.instruction);
    for (std::size_t i = 0; i < values.size(); ++i) {
        operands.push_back(Operand(trace, values[i], step.operands[i], step.operand_words[i]));
    }
    return Glsl(*step.instruction, operands);
}

std::string SourceTerms::Name(const evaluate::TracedStep& step) const {
    return step.stored == nullptr ? "" : Pointer(module_.Operands(*step.stored)[0]);
}

}  // namespace etalon
