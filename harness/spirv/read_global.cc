#include <algorithm>

#include "spirv/read.h"
#include "spirv/reader.h"

namespace etalon::spirv {
namespace {

constexpr std::uint32_t kDeepest = 16;  // types within types
constexpr std::uint32_t kMostMembers = 1u << 12;

bool IsScalar(const Type& type) {
    return type.kind == Type::Kind::kBool || type.kind == Type::Kind::kInt ||
           type.kind == Type::Kind::kFloat;
}

// A type of which memory and values can be made.
bool IsData(const Type& type) {
    return type.kind != Type::Kind::kVoid && type.kind != Type::Kind::kFunction &&
           type.kind != Type::Kind::kPointer;
}

}  // namespace

Status<> Reader::ReadGlobal(const RawInstruction& raw) {
    switch (raw.op) {
        case spv::Op::OpTypeVoid:
        case spv::Op::OpTypeBool:
        case spv::Op::OpTypeInt:
        case spv::Op::OpTypeFloat:
        case spv::Op::OpTypeVector:
        case spv::Op::OpTypeMatrix:
        case spv::Op::OpTypeImage:
        case spv::Op::OpTypeSampler:
        case spv::Op::OpTypeSampledImage:
        case spv::Op::OpTypeArray:
        case spv::Op::OpTypeRuntimeArray:
        case spv::Op::OpTypeStruct:
        case spv::Op::OpTypePointer:
        case spv::Op::OpTypeFunction:
            return ReadType(raw);
        case spv::Op::OpConstantTrue:
        case spv::Op::OpConstantFalse:
        case spv::Op::OpConstant:
        case spv::Op::OpConstantComposite:
        case spv::Op::OpSpecConstantTrue:
        case spv::Op::OpSpecConstantFalse:
        case spv::Op::OpSpecConstant:
        case spv::Op::OpSpecConstantComposite:
            return ReadConstant(raw);
        case spv::Op::OpConstantNull:
        case spv::Op::OpUndef:
            return AddNull(raw);
        case spv::Op::OpVariable:
            return ReadVariable(raw);
        case spv::Op::OpMemoryModel:
            if (Word(raw, 0) != static_cast<std::uint32_t>(spv::AddressingModel::Logical)) {
                return Wrong(raw, "the addressing is not logical");
            }
            return Ok();
        case spv::Op::OpNop:
        case spv::Op::OpSourceContinued:
        case spv::Op::OpSource:
        case spv::Op::OpSourceExtension:
        case spv::Op::OpName:
        case spv::Op::OpMemberName:
        case spv::Op::OpString:
        case spv::Op::OpLine:
        case spv::Op::OpNoLine:
        case spv::Op::OpModuleProcessed:
        case spv::Op::OpExtension:
        case spv::Op::OpExtInstImport:
        case spv::Op::OpEntryPoint:
        case spv::Op::OpExecutionMode:
        case spv::Op::OpCapability:
        case spv::Op::OpDecorate:
        case spv::Op::OpMemberDecorate:
            return Ok();
        default:
            return Wrong(raw, "stands outside a function");
    }
}

Status<> Reader::ReadType(const RawInstruction& raw) {
    using Kind = Type::Kind;
    Type type;
    if (const auto name = names_.find(raw.result); name != names_.end()) {
        type.name = name->second;
    }
    const std::span<const RawOperand> operands = Operands(raw);
    std::vector<std::uint32_t> inner;
    for (const RawOperand& operand : operands) {
        if (operand.kind == 'y') {
            ETALON_TRY(index, TypeAt(raw, operand.value));
            inner.push_back(index);
        }
    }
    if (!inner.empty()) {
        type.element = inner[0];
    }
    const Type* element = inner.empty() ? nullptr : &module_.types[inner[0]];
    switch (raw.op) {
        case spv::Op::OpTypeVoid:
            break;
        case spv::Op::OpTypeBool:
            type.kind = Kind::kBool;
            break;
        case spv::Op::OpTypeInt:
        case spv::Op::OpTypeFloat:
            type.kind = raw.op == spv::Op::OpTypeInt ? Kind::kInt : Kind::kFloat;
            type.width = operands[0].value;
            type.is_signed = type.kind == Kind::kInt && operands[1].value == 1;
            if (type.width != 8 && type.width != 16 && type.width != 32 && type.width != 64) {
                return Wrong(raw, "has a width of " + std::to_string(type.width));
            }
            break;
        case spv::Op::OpTypeVector:
        case spv::Op::OpTypeMatrix: {
            const bool is_vector = raw.op == spv::Op::OpTypeVector;
            type.kind = is_vector ? Kind::kVector : Kind::kMatrix;
            type.count = operands[1].value;
            if (type.count < 2 || type.count > 4) {
                return Wrong(raw, "has a size of " + std::to_string(type.count));
            }
            if (is_vector ? !IsScalar(*element)
                          : element->kind != Kind::kVector ||
                                module_.types[element->element].kind != Kind::kFloat) {
                return Wrong(raw, "its parts are of the wrong type");
            }
            break;
        }
        case spv::Op::OpTypeImage:
            ETALON_TRY_STEP(ReadImage(raw, type));
            break;
        case spv::Op::OpTypeSampler:
            type.kind = Kind::kSampler;
            break;
        case spv::Op::OpTypeSampledImage:
            type.kind = Kind::kSampledImage;
            if (element->kind != Kind::kImage) {
                return Wrong(raw, "is not made of an image");
            }
            break;
        case spv::Op::OpTypeArray:
        case spv::Op::OpTypeRuntimeArray:
            if (!IsData(*element) || element->kind == Kind::kRuntimeArray) {
                return Wrong(raw, "its elements are of the wrong type");
            }
            ETALON_TRY_STEP(ReadArray(raw, type));
            break;
        case spv::Op::OpTypeStruct:
            type.kind = Kind::kStruct;
            type.element = kNone;
            type.members = inner;
            ETALON_TRY_STEP(ReadStruct(raw, type));
            break;
        case spv::Op::OpTypePointer:
            type.kind = Kind::kPointer;
            type.storage = static_cast<spv::StorageClass>(operands[0].value);
            if (!IsData(*element)) {
                return Wrong(raw, "its target is of the wrong type");
            }
            break;
        default:
            type.kind = Kind::kFunction;
            type.members.assign(inner.begin() + 1, inner.end());
            for (const std::uint32_t member : type.members) {
                if (module_.types[member].kind == Kind::kVoid ||
                    module_.types[member].kind == Kind::kFunction) {
                    return Wrong(raw, "a parameter is of the wrong type");
                }
            }
            if (element->kind == Kind::kFunction || element->kind == Kind::kPointer) {
                return Wrong(raw, "its result is of the wrong type");
            }
            break;
    }
    std::uint32_t depth = 0;
    for (const std::uint32_t one : inner) {
        depth = std::max(depth, depths_[one] + 1);
    }
    if (depth > kDeepest) {
        return Wrong(raw, "is nested more than " + std::to_string(kDeepest) + " deep");
    }
    depths_.push_back(depth);
    ids_[raw.result] = {Id::Kind::kType, static_cast<std::uint32_t>(module_.types.size()), 0};
    module_.types.push_back(std::move(type));
    return Ok();
}

Status<> Reader::ReadStruct(const RawInstruction& raw, Type& type) {
    const std::size_t count = type.members.size();
    if (count > kMostMembers) {
        return Wrong(raw, "has more than " + std::to_string(kMostMembers) + " members");
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Type& member = module_.types[type.members[i]];
        if (!IsData(member) || (member.kind == Type::Kind::kRuntimeArray && i + 1 < count)) {
            return Wrong(raw, "the member " + std::to_string(i) + " is of the wrong type");
        }
    }
    type.offsets.assign(count, kNone);
    for (const Decoration& decoration : decorations_[raw.result]) {
        if (decoration.member < count &&
            decoration.kind == static_cast<std::uint32_t>(spv::Decoration::Offset)) {
            type.offsets[decoration.member] = decoration.value;
        }
    }
    if (const auto found = member_names_.find(raw.result); found != member_names_.end()) {
        type.member_names.resize(count);
        for (const auto& [member, name] : found->second) {
            if (member < count) {
                type.member_names[member] = name;
            }
        }
    }
    return Ok();
}

Status<> Reader::ReadArray(const RawInstruction& raw, Type& type) {
    type.kind = raw.op == spv::Op::OpTypeArray ? Type::Kind::kArray : Type::Kind::kRuntimeArray;
    for (const Decoration& decoration : decorations_[raw.result]) {
        if (decoration.kind == static_cast<std::uint32_t>(spv::Decoration::ArrayStride)) {
            type.array_stride = decoration.value;
        }
    }
    if (type.kind == Type::Kind::kRuntimeArray) {
        return Ok();
    }
    ETALON_TRY(length, ValueAt(raw, Word(raw, 1)));
    const Value& value = module_.values[length];
    if (value.kind != Value::Kind::kConstant ||
        module_.types[value.type].kind != Type::Kind::kInt ||
        module_.types[value.type].width != 32) {
        return Wrong(raw, "its length is no 32-bit integer constant");
    }
    const Constant& constant = module_.constants[value.index];
    type.count = constant.is_null ? 0 : constant.words[0];
    if (type.count == 0 || type.count > kMostElements) {
        return Wrong(raw, "has a length of " + std::to_string(type.count));
    }
    return Ok();
}

Status<> Reader::ReadImage(const RawInstruction& raw, Type& type) {
    type.kind = Type::Kind::kImage;
    const Type& texel = module_.types[type.element];
    if (!IsScalar(texel) || texel.kind == Type::Kind::kBool) {
        return Wrong(raw, "its texels are no numbers");
    }
    type.dimension = static_cast<spv::Dim>(Word(raw, 1));
    type.is_depth = Word(raw, 2) == 1;
    type.is_arrayed = Word(raw, 3) != 0;
    type.is_multisampled = Word(raw, 4) != 0;
    return Ok();
}

Status<> Reader::ReadConstant(const RawInstruction& raw) {
    ETALON_TRY(index, ResultType(raw));
    const Type& type = module_.types[index];
    Constant constant;
    switch (raw.op) {
        case spv::Op::OpConstantTrue:
        case spv::Op::OpConstantFalse:
        case spv::Op::OpSpecConstantTrue:
        case spv::Op::OpSpecConstantFalse:
            if (type.kind != Type::Kind::kBool) {
                return Wrong(raw, "its type is not bool");
            }
            constant.words = {raw.op == spv::Op::OpConstantTrue ||
                              raw.op == spv::Op::OpSpecConstantTrue};
            break;
        case spv::Op::OpConstant:
        case spv::Op::OpSpecConstant:
            ETALON_TRY_STEP(ReadNumber(raw, type, constant));
            break;
        default:
            ETALON_TRY_STEP(ReadComposite(raw, type, constant));
            break;
    }
    constant.is_spec =
        raw.op == spv::Op::OpSpecConstantTrue || raw.op == spv::Op::OpSpecConstantFalse ||
        raw.op == spv::Op::OpSpecConstant || raw.op == spv::Op::OpSpecConstantComposite;
    AddValue(raw, index, Value::Kind::kConstant,
             static_cast<std::uint32_t>(module_.constants.size()));
    module_.constants.push_back(std::move(constant));
    return Ok();
}

Status<> Reader::ReadNumber(const RawInstruction& raw, const Type& type, Constant& constant) {
    if (type.kind != Type::Kind::kInt && type.kind != Type::Kind::kFloat) {
        return Wrong(raw, "its type is no number");
    }
    if (raw.operands != (type.width == 64 ? 2u : 1u)) {
        return Wrong(raw, "has " + std::to_string(raw.operands) + " words for a width of " +
                              std::to_string(type.width));
    }
    for (const RawOperand& operand : Operands(raw)) {
        constant.words.push_back(operand.value);
    }
    return Ok();
}

Status<> Reader::ReadComposite(const RawInstruction& raw, const Type& type, Constant& constant) {
    const bool is_struct = type.kind == Type::Kind::kStruct;
    if (!is_struct && type.kind != Type::Kind::kVector && type.kind != Type::Kind::kMatrix &&
        type.kind != Type::Kind::kArray) {
        return Wrong(raw, "its type is no composite");
    }
    if (raw.operands != (is_struct ? type.members.size() : type.count)) {
        return Wrong(raw, "has " + std::to_string(raw.operands) + " members");
    }
    for (std::size_t i = 0; i < raw.operands; ++i) {
        ETALON_TRY(member, ValueAt(raw, Word(raw, i)));
        const Value& value = module_.values[member];
        if (value.kind != Value::Kind::kConstant ||
            value.type != (is_struct ? type.members[i] : type.element)) {
            return Wrong(raw, "the member " + std::to_string(i) + " is no constant of its type");
        }
        constant.members.push_back(member);
    }
    return Ok();
}

Status<> Reader::AddNull(const RawInstruction& raw) {
    ETALON_TRY(type, ResultType(raw));
    if (!IsData(module_.types[type])) {
        return Wrong(raw, "no value has its type");
    }
    Constant constant;
    constant.is_null = true;
    AddValue(raw, type, Value::Kind::kConstant,
             static_cast<std::uint32_t>(module_.constants.size()));
    module_.constants.push_back(std::move(constant));
    return Ok();
}

Status<> Reader::ReadVariable(const RawInstruction& raw) {
    ETALON_TRY(type, ResultType(raw));
    Variable variable;
    variable.storage = static_cast<spv::StorageClass>(Word(raw, 0));
    const Type& pointer = module_.types[type];
    if (pointer.kind != Type::Kind::kPointer || pointer.storage != variable.storage) {
        return Wrong(raw, "its type is no pointer into its storage class");
    }
    if ((variable.storage == spv::StorageClass::Function) != (function_ != kNone)) {
        return Wrong(raw, "its storage class does not belong where it stands");
    }
    if (raw.operands > 1) {
        ETALON_TRY(initializer, ValueAt(raw, Word(raw, 1)));
        const Value& value = module_.values[initializer];
        if (value.kind != Value::Kind::kConstant || value.type != pointer.element) {
            return Wrong(raw, "its initializer is no constant of its type");
        }
        variable.initializer = initializer;
    }
    for (const Decoration& decoration : decorations_[raw.result]) {
        switch (static_cast<spv::Decoration>(decoration.kind)) {
            case spv::Decoration::DescriptorSet:
                variable.set = decoration.value;
                break;
            case spv::Decoration::Binding:
                variable.binding = decoration.value;
                break;
            case spv::Decoration::BuiltIn:
                variable.built_in = decoration.value;
                break;
            default:
                break;
        }
    }
    variable.value = AddValue(raw, type, Value::Kind::kVariable,
                              static_cast<std::uint32_t>(module_.variables.size()));
    if (function_ != kNone) {
        module_.functions[function_].variables.push_back(variable.value);
    }
    module_.variables.push_back(variable);
    return Ok();
}

}  // namespace etalon::spirv
