#include "spirv/read.h"

#include "spirv/reader.h"

namespace etalon::spirv {
namespace {

constexpr std::string_view kGlsl = "GLSL.std.450";

}  // namespace

Result<Module> ReadModule(std::span<const std::uint32_t> words) {
    ETALON_TRY(raw, CutWords(words));
    return Reader(words, raw).Read();
}

Result<Module> Reader::Read() {
    ETALON_TRY_STEP(Announce());
    for (std::size_t i = 0; i < first_function_; ++i) {
        ETALON_TRY_STEP(ReadDebug(raw_.instructions[i]));
    }
    for (std::size_t i = 0; i < first_function_; ++i) {
        ETALON_TRY_STEP(ReadGlobal(raw_.instructions[i]));
    }
    ETALON_TRY_STEP(ReadFunctions());
    ETALON_TRY_STEP(ReadEntry());
    return std::move(module_);
}

// Names what may be used before it is defined: functions and labels. No id may have two meanings.
Status<> Reader::Announce() {
    std::vector<bool> taken(raw_.bound);
    std::uint32_t functions = 0;
    std::uint32_t labels = 0;
    bool in_function = false;
    first_function_ = raw_.instructions.size();
    for (std::size_t i = 0; i < raw_.instructions.size(); ++i) {
        const RawInstruction& raw = raw_.instructions[i];
        in_function =
            raw.op == spv::Op::OpFunction || (in_function && raw.op != spv::Op::OpFunctionEnd);
        if (raw.result == 0) {
            continue;
        }
        if (taken[raw.result]) {
            return Wrong(raw, "defines the id " + std::to_string(raw.result) + " once more");
        }
        taken[raw.result] = true;
        if (raw.op == spv::Op::OpFunction) {
            first_function_ = std::min(first_function_, i);
            ids_[raw.result] = {Id::Kind::kFunction, functions++, 0};
            labels = 0;
        } else if (raw.op == spv::Op::OpLabel) {
            if (!in_function) {
                return Wrong(raw, "stands outside a function");
            }
            ids_[raw.result] = {Id::Kind::kLabel, labels++, functions - 1};
        } else if (raw.op == spv::Op::OpString) {
            ids_[raw.result] = {Id::Kind::kString, Word(raw, 0), 0};
        } else if (raw.op == spv::Op::OpExtInstImport) {
            if (const std::string name = StringAt(words_, Word(raw, 0)); name != kGlsl) {
                return Wrong(raw, "'" + name + "' is not known");
            }
            ids_[raw.result] = {Id::Kind::kImport, 0, 0};
        }
    }
    module_.functions.resize(functions);
    return Ok();
}

// Names and decorations come before what they speak of.
Status<> Reader::ReadDebug(const RawInstruction& raw) {
    const std::span<const RawOperand> operands = Operands(raw);
    switch (raw.op) {
        case spv::Op::OpName:
            names_[operands[0].value] = StringAt(words_, operands[1].value);
            break;
        case spv::Op::OpMemberName:
            member_names_[operands[0].value].emplace_back(operands[1].value,
                                                          StringAt(words_, operands[2].value));
            break;
        case spv::Op::OpDecorate:
            decorations_[operands[0].value].push_back(
                {kNone, operands[1].value, operands.size() > 2 ? operands[2].value : kNone});
            break;
        case spv::Op::OpMemberDecorate:
            decorations_[operands[0].value].push_back(
                {operands[1].value, operands[2].value,
                 operands.size() > 3 ? operands[3].value : kNone});
            break;
        default:
            break;
    }
    return Ok();
}

Status<> Reader::ReadEntry() {
    for (std::size_t i = 0; i < first_function_; ++i) {
        const RawInstruction& raw = raw_.instructions[i];
        if (raw.op != spv::Op::OpEntryPoint) {
            continue;
        }
        if (module_.entry != kNone) {
            return Wrong(raw, "is the second entry point");
        }
        const Id& id = ids_[Word(raw, 1)];
        if (id.kind != Id::Kind::kFunction) {
            return Wrong(raw, "its id is no function");
        }
        const Function& function = module_.functions[id.index];
        if (!function.parameters.empty() ||
            module_.types[module_.types[function.type].element].kind != Type::Kind::kVoid) {
            return Wrong(raw, "its function takes or returns a value");
        }
        module_.entry = id.index;
        module_.model = static_cast<spv::ExecutionModel>(Word(raw, 0));
    }
    if (module_.entry == kNone) {
        return Error{"SPIR-V: the module has no entry point"};
    }
    return Ok();
}

Result<std::uint32_t> Reader::TypeAt(const RawInstruction& raw, std::uint32_t id) const {
    if (ids_[id].kind != Id::Kind::kType) {
        return Wrong(raw, "the id " + std::to_string(id) + " is no type that stands before it");
    }
    return std::uint32_t{ids_[id].index};
}

Result<std::uint32_t> Reader::ValueAt(const RawInstruction& raw, std::uint32_t id) const {
    if (ids_[id].kind != Id::Kind::kValue) {
        return Wrong(raw, "the id " + std::to_string(id) + " is no value that stands before it");
    }
    const std::uint32_t value = ids_[id].index;
    const std::uint32_t home = module_.values[value].function;
    if (home != kNone && home != function_) {
        return Wrong(raw, "the id " + std::to_string(id) + " belongs to another function");
    }
    return std::uint32_t{value};
}

Result<std::uint32_t> Reader::ResultType(const RawInstruction& raw) const {
    return TypeAt(raw, raw.type);
}

std::uint32_t Reader::AddValue(const RawInstruction& raw, std::uint32_t type, Value::Kind kind,
                               std::uint32_t index) {
    Value value;
    value.kind = kind;
    value.type = type;
    value.function = function_;
    value.index = index;
    if (const auto name = names_.find(raw.result); name != names_.end()) {
        value.name = name->second;
    }
    if (const auto found = decorations_.find(raw.result); found != decorations_.end()) {
        for (const Decoration& decoration : found->second) {
            value.no_contraction |=
                decoration.kind == static_cast<std::uint32_t>(spv::Decoration::NoContraction);
            value.relaxed_precision |=
                decoration.kind == static_cast<std::uint32_t>(spv::Decoration::RelaxedPrecision);
        }
    }
    const auto place = static_cast<std::uint32_t>(module_.values.size());
    module_.values.push_back(std::move(value));
    ids_[raw.result] = {Id::Kind::kValue, place, 0};
    return place;
}

}  // namespace etalon::spirv
