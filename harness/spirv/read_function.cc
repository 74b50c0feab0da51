#include <algorithm>

#include "spirv/check.h"
#include "spirv/reader.h"

namespace etalon::spirv {
namespace {

bool LeavesBlock(spv::Op op) {
    switch (op) {
        case spv::Op::OpBranch:
        case spv::Op::OpBranchConditional:
        case spv::Op::OpSwitch:
        case spv::Op::OpKill:
        case spv::Op::OpTerminateInvocation:
        case spv::Op::OpReturn:
        case spv::Op::OpReturnValue:
        case spv::Op::OpUnreachable:
            return true;
        default:
            return false;
    }
}

void AddSuccessors(const Module& module, const Instruction& instruction, Block& block) {
    const std::span<const std::uint32_t> operands = module.Operands(instruction);
    std::vector<std::uint32_t>& to = block.successors;
    switch (instruction.op) {
        case spv::Op::OpBranch:
            to = {operands[0]};
            break;
        case spv::Op::OpBranchConditional:
            to = {operands[1], operands[2]};
            break;
        case spv::Op::OpSwitch:
            to = {operands[1]};
            for (std::size_t i = 3; i < operands.size(); i += 2) {
                to.push_back(operands[i]);
            }
            break;
        default:
            break;
    }
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
}

}  // namespace

Status<> Reader::ReadFunctions() {
    for (std::size_t i = first_function_; i < raw_.instructions.size(); ++i) {
        const RawInstruction& raw = raw_.instructions[i];
        switch (raw.op) {
            case spv::Op::OpNop:
                break;
            case spv::Op::OpLine: {
                const Id& file = ids_[Word(raw, 0)];
                if (file.kind != Id::Kind::kString) {
                    return Wrong(raw, "its file is no string");
                }
                line_ = static_cast<std::uint32_t>(module_.lines.size());
                module_.lines.push_back({StringAt(words_, file.index), Word(raw, 1), Word(raw, 2)});
                break;
            }
            case spv::Op::OpNoLine:
                line_ = kNone;
                break;
            case spv::Op::OpFunction:
                ETALON_TRY_STEP(BeginFunction(raw));
                break;
            default:
                if (function_ == kNone) {
                    return Wrong(raw, "stands between functions");
                }
                if (raw.op == spv::Op::OpFunctionParameter) {
                    ETALON_TRY_STEP(ReadParameter(raw));
                } else if (raw.op == spv::Op::OpFunctionEnd) {
                    ETALON_TRY_STEP(EndFunction(raw));
                } else {
                    ETALON_TRY_STEP(ReadInBlock(raw));
                }
                break;
        }
    }
    if (function_ != kNone) {
        return Error{"SPIR-V: the last function has no end"};
    }
    for (const Function& function : module_.functions) {
        for (const Block& block : function.blocks) {
            for (const Instruction& instruction : block.instructions) {
                ETALON_TRY_STEP(CheckCall(instruction));
            }
        }
    }
    return Ok();
}

// Comes last because a function may be called before it is read.
Status<> Reader::CheckCall(const Instruction& instruction) const {
    if (instruction.op != spv::Op::OpFunctionCall) {
        return Ok();
    }
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    const Function& called = module_.functions[operands[0]];
    const Type& type = module_.types[called.type];
    bool fits = type.element == instruction.type && operands.size() == type.members.size() + 1;
    for (std::size_t i = 0; fits && i < type.members.size(); ++i) {
        fits = module_.values[operands[i + 1]].type == type.members[i];
    }
    if (!fits) {
        return At(instruction.word, instruction.op, "does not fit the function's type");
    }
    return Ok();
}

Status<> Reader::BeginFunction(const RawInstruction& raw) {
    if (function_ != kNone) {
        return Wrong(raw, "stands within a function");
    }
    function_ = ids_[raw.result].index;
    block_ = kNone;
    phi_sources_.clear();
    Function& function = module_.functions[function_];
    ETALON_TRY(type, TypeAt(raw, Word(raw, 1)));
    ETALON_TRY(result, ResultType(raw));
    if (module_.types[type].kind != Type::Kind::kFunction ||
        module_.types[type].element != result) {
        return Wrong(raw, "its type is no function of its result");
    }
    function.type = type;
    if (const auto name = names_.find(raw.result); name != names_.end()) {
        function.name = name->second;
    }
    return Ok();
}

Status<> Reader::ReadParameter(const RawInstruction& raw) {
    Function& function = module_.functions[function_];
    const std::vector<std::uint32_t>& types = module_.types[function.type].members;
    const std::size_t place = function.parameters.size();
    ETALON_TRY(type, ResultType(raw));
    if (!function.blocks.empty() || place >= types.size() || types[place] != type) {
        return Wrong(raw, "is no parameter of the function's type");
    }
    function.parameters.push_back(
        AddValue(raw, type, Value::Kind::kParameter, static_cast<std::uint32_t>(place)));
    return Ok();
}

Status<> Reader::EndFunction(const RawInstruction& raw) {
    const Function& function = module_.functions[function_];
    if (block_ != kNone) {
        return Wrong(raw, "the last block has no end");
    }
    if (function.blocks.empty()) {
        return Wrong(raw, "the function has no body");
    }
    if (function.parameters.size() != module_.types[function.type].members.size()) {
        return Wrong(raw, "the function lacks parameters");
    }
    for (const PhiSource& source : phi_sources_) {
        ETALON_TRY(value, ValueAt(*source.raw, source.id));
        if (module_.values[value].type != ids_[source.raw->type].index) {
            return Wrong(*source.raw, "a source is not of its type");
        }
        module_.operands[source.operand] = value;
    }
    ETALON_TRY_STEP(CheckPhis(function));
    function_ = kNone;
    line_ = kNone;
    return Ok();
}

Status<> Reader::CheckPhis(const Function& function) const {
    for (std::uint32_t from = 0; from < function.blocks.size(); ++from) {
        for (const std::uint32_t to : function.blocks[from].successors) {
            if (to == 0) {
                return Error{"SPIR-V: a branch leads to the first block of a function"};
            }
            for (const Instruction& phi : function.blocks[to].instructions) {
                if (phi.op != spv::Op::OpPhi) {
                    break;
                }
                const std::span<const std::uint32_t> operands = module_.Operands(phi);
                bool found = false;
                for (std::size_t i = 1; i < operands.size(); i += 2) {
                    found |= operands[i] == from;
                }
                if (!found) {
                    return At(phi.word, phi.op, "has no source for a block that leads to it");
                }
            }
        }
    }
    return Ok();
}

Status<> Reader::ReadInBlock(const RawInstruction& raw) {
    Function& function = module_.functions[function_];
    if (raw.op == spv::Op::OpLabel) {
        if (block_ != kNone) {
            return Wrong(raw, "stands within a block");
        }
        block_ = static_cast<std::uint32_t>(function.blocks.size());
        merged_ = false;
        function.blocks.emplace_back();
        return Ok();
    }
    if (block_ == kNone) {
        return Wrong(raw, "stands outside a block");
    }
    if (merged_ && !LeavesBlock(raw.op)) {
        return Wrong(raw, "stands between a merge instruction and the block's end");
    }
    switch (raw.op) {
        case spv::Op::OpVariable:
            return ReadVariable(raw);
        case spv::Op::OpUndef:
            return AddNull(raw);
        case spv::Op::OpSelectionMerge:
        case spv::Op::OpLoopMerge:
            return ReadMerge(raw);
        default:
            break;
    }
    if (raw.rule == Rule::kAny && !LeavesBlock(raw.op) && raw.type == 0) {
        return Wrong(raw, "stands within a function");
    }
    Block& block = function.blocks[block_];
    if (raw.op == spv::Op::OpPhi && !block.instructions.empty() &&
        block.instructions.back().op != spv::Op::OpPhi) {
        return Wrong(raw, "stands after other instructions");
    }
    Instruction instruction;
    instruction.op = raw.op;
    instruction.line = line_;
    instruction.word = raw.word;
    ETALON_TRY_STEP(ResolveOperands(raw, instruction));
    if (raw.type != 0) {
        ETALON_TRY(type, ResultType(raw));
        instruction.type = type;
    }
    if (const auto reason = CheckTypes(module_, function_, instruction, raw.rule)) {
        return Wrong(raw, *reason);
    }
    if (raw.result != 0) {
        instruction.result = AddValue(raw, instruction.type, Value::Kind::kResult, kNone);
    }
    block.instructions.push_back(instruction);
    if (LeavesBlock(raw.op)) {
        AddSuccessors(module_, instruction, block);
        block_ = kNone;
    }
    return Ok();
}

Status<> Reader::ReadMerge(const RawInstruction& raw) {
    Instruction instruction;
    ETALON_TRY_STEP(ResolveOperands(raw, instruction));
    Block& block = module_.functions[function_].blocks[block_];
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    block.merge = operands[0];
    if (raw.op == spv::Op::OpLoopMerge) {
        block.continue_block = operands[1];
    }
    merged_ = true;
    return Ok();
}

Status<> Reader::ResolveOperands(const RawInstruction& raw, Instruction& instruction) {
    instruction.first_operand = static_cast<std::uint32_t>(module_.operands.size());
    for (const RawOperand& operand : Operands(raw)) {
        std::uint32_t resolved = operand.value;
        const bool is_id = operand.kind != '#' && operand.kind != '$';
        const Id id = is_id ? ids_[operand.value] : Id{};
        switch (operand.kind) {
            case 'v': {
                ETALON_TRY(value, ValueAt(raw, operand.value));
                resolved = value;
                break;
            }
            case 'V':
                phi_sources_.push_back(
                    {static_cast<std::uint32_t>(module_.operands.size()), operand.value, &raw});
                break;
            case 'b':
                if (id.kind != Id::Kind::kLabel || id.function != function_) {
                    return Wrong(raw, "the id " + std::to_string(operand.value) +
                                          " is no block of the function");
                }
                resolved = id.index;
                break;
            case 'f':
                if (id.kind != Id::Kind::kFunction) {
                    return Wrong(raw, "calls no function");
                }
                resolved = id.index;
                break;
            case 'e':
                if (id.kind != Id::Kind::kImport) {
                    return Wrong(raw, "names no import");
                }
                continue;
            case '#':
                break;
            default:
                return Wrong(raw, "stands within a function");
        }
        module_.operands.push_back(resolved);
    }
    instruction.operands =
        static_cast<std::uint32_t>(module_.operands.size()) - instruction.first_operand;
    return Ok();
}

}  // namespace etalon::spirv
