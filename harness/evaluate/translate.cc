#include "evaluate/translate.h"

#include <algorithm>

namespace etalon::evaluate {
Result<std::shared_ptr<const Plan>> MakePlan(spirv::Module module) {
    return Translator(std::move(module)).Translate();
}

Error Translator::Wrong(const Instruction& instruction, const std::string& reason) const {
    std::string where = "SPIR-V word " + std::to_string(instruction.word);
    if (instruction.line != kNone) {
        const spirv::Line& line = module_.lines[instruction.line];
        where = line.file + ":" + std::to_string(line.line);
    }
    for (const spirv::Function& function : module_.functions) {
        const auto stands = [&](const spirv::Block& block) {
            return block.instructions.front().word <= instruction.word &&
                   instruction.word <= block.instructions.back().word;
        };
        if (!function.name.empty() &&
            std::any_of(function.blocks.begin(), function.blocks.end(), stands)) {
            where += ", in " + PlainName(function.name);
        }
    }
    return Error{where + ": " + spirv::OpName(instruction.op) + ": " + reason};
}

Result<std::shared_ptr<const Plan>> Translator::Translate() {
    if (module_.model != spv::ExecutionModel::GLCompute) {
        return Error{"the module is no compute shader"};
    }
    places_.resize(module_.values.size());
    addresses_.assign(module_.values.size(), kNone);
    bits_.assign(module_.values.size(), kNone);
    plan_->entry = module_.entry;
    plan_->functions.resize(module_.functions.size());
    slots_.resize(module_.functions.size());
    LayOutTypes();
    ETALON_TRY_STEP(CheckRecursion());
    ETALON_TRY_STEP(TranslateConstants());
    for (std::uint32_t i = 0; i < module_.variables.size(); ++i) {
        if (module_.values[module_.variables[i].value].function == kNone) {
            if (auto placed = PlaceVariable(i, plan_->globals, false); !placed) {
                refused_[module_.variables[i].value] = placed.error().message;
            }
        }
    }
    // Parameters and results first: a call may stand before its function.
    for (std::uint32_t i = 0; i < module_.functions.size(); ++i) {
        const spirv::Function& function = module_.functions[i];
        const std::uint32_t result = module_.types[function.type].element;
        if (module_.types[result].kind != Kind::kVoid) {
            auto size = SizeOf(result);
            if (!size) {
                return Error{"function '" + PlainName(function.name) +
                             "': " + size.error().message};
            }
            ETALON_TRY(place, Allocate(result));
            plan_->functions[i].result = place;
            plan_->functions[i].result_size = *size;
        }
        for (const std::uint32_t parameter : function.parameters) {
            slots_[i].push_back(kNone);
            if (module_.TypeOf(parameter).kind == Kind::kPointer) {
                const spv::StorageClass storage = module_.TypeOf(parameter).storage;
                Address address;
                address.slot = slots_[i].back() = plan_->slots++;
                const Kind target = module_.types[module_.TypeOf(parameter).element].kind;
                if (storage == spv::StorageClass::UniformConstant &&
                    target == Kind::kSampledImage) {
                    address.space = Address::Space::kImage;
                } else if (storage != spv::StorageClass::Function &&
                           storage != spv::StorageClass::Private) {
                    return Error{
                        "function '" + function.name +
                        "': a pointer to what is no variable is not supported as its parameter"};
                }
                addresses_[parameter] = AddAddress(address);
            } else {
                ETALON_TRY(place, Allocate(module_.values[parameter].type));
                places_[parameter] = place;
            }
        }
    }
    for (std::uint32_t i = 0; i < module_.functions.size(); ++i) {
        ETALON_TRY_STEP(TranslateFunction(i));
    }
    return std::shared_ptr<const Plan>(plan_);
}

Status<> Translator::CheckRecursion() {
    // Functions that call only such as are already in order are put in order, until none is left.
    std::vector<std::vector<std::uint32_t>> calls(module_.functions.size());
    for (std::size_t i = 0; i < calls.size(); ++i) {
        for (const spirv::Block& block : module_.functions[i].blocks) {
            for (const Instruction& instruction : block.instructions) {
                if (instruction.op == spv::Op::OpFunctionCall) {
                    calls[i].push_back(module_.Operands(instruction)[0]);
                }
            }
        }
    }
    std::vector<bool> ordered(calls.size());
    for (bool changed = true; changed;) {
        changed = false;
        for (std::size_t i = 0; i < calls.size(); ++i) {
            if (!ordered[i] && std::all_of(calls[i].begin(), calls[i].end(),
                                           [&](std::uint32_t to) { return ordered[to]; })) {
                ordered[i] = true;
                changed = true;
            }
        }
    }
    const auto first = std::find(ordered.begin(), ordered.end(), false);
    if (first == ordered.end()) {
        return Ok();
    }
    // Each that is left calls another one that is; the way along these ends in a ring.
    std::vector<bool> seen(calls.size());
    auto at = static_cast<std::size_t>(first - ordered.begin());
    while (!seen[at]) {
        seen[at] = true;
        at = *std::find_if(calls[at].begin(), calls[at].end(),
                           [&](std::uint32_t to) { return !ordered[to]; });
    }
    return Error{"recursion: the function '" + PlainName(module_.functions[at].name) +
                 "' calls itself, by itself or by others"};
}

Status<> Translator::TranslateConstants() {
    std::vector<std::uint32_t> by_value(module_.values.size(), kNone);
    for (std::uint32_t i = 0; i < module_.values.size(); ++i) {
        const spirv::Value& value = module_.values[i];
        if (value.kind != spirv::Value::Kind::kConstant || !sizes_[value.type]) {
            continue;  // an unsupported one is refused where it is used
        }
        ETALON_TRY(place, Allocate(value.type));
        places_[i] = place;
        const Columns size = *sizes_[value.type];
        const spirv::Constant& constant = module_.constants[value.index];
        Constant out{place, std::vector<std::uint32_t>(size.floats),
                     std::vector<std::uint32_t>(size.words)};
        if (!constant.is_null && constant.members.empty()) {
            (size.floats != 0 ? out.floats : out.words)[0] = constant.words[0];
        }
        Columns at;
        for (const std::uint32_t member : constant.members) {
            const Constant& inner = plan_->constants[by_value[member]];
            std::copy(inner.floats.begin(), inner.floats.end(), out.floats.begin() + at.floats);
            std::copy(inner.words.begin(), inner.words.end(), out.words.begin() + at.words);
            at = at + *sizes_[module_.values[member].type];
        }
        by_value[i] = static_cast<std::uint32_t>(plan_->constants.size());
        plan_->constants.push_back(std::move(out));
    }
    return Ok();
}

Status<> Translator::TranslateFunction(std::uint32_t index) {
    const spirv::Function& function = module_.functions[index];
    const std::vector<std::uint32_t> order = OrderBlocks(function);
    std::vector<std::uint32_t> places(function.blocks.size(), kNone);
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        places[order[i]] = i;
    }
    Function& out = plan_->functions[index];
    out.blocks.resize(order.size());
    std::vector<Step> prologue;
    for (const std::uint32_t value : function.variables) {
        ETALON_TRY_STEP(
            PlaceVariable(module_.values[value].index, prologue, IsSetFirst(function, value)));
    }
    // The sources of phis may follow later, so all results have their places first.
    for (const spirv::Block& block : function.blocks) {
        for (const Instruction& instruction : block.instructions) {
            if (instruction.op == spv::Op::OpPhi) {
                ETALON_TRY(place, Allocate(instruction.type));
                places_[instruction.result] = place;
            }
        }
    }
    // In the module's order, in which what is used stands before its use.
    for (std::uint32_t block = 0; block < function.blocks.size(); ++block) {
        if (places[block] == kNone) {
            // Not run, but what stands in it may be named: a pointer needs its address.
            Block unused;
            ETALON_TRY_STEP(TranslateBlock(function, block, places, unused));
            continue;
        }
        Block& target = out.blocks[places[block]];
        if (block == 0) {
            target.is_counted = true;
            target.first_step = static_cast<std::uint32_t>(plan_->steps.size());
            plan_->steps.insert(plan_->steps.end(), prologue.begin(), prologue.end());
        } else {
            target.first_step = static_cast<std::uint32_t>(plan_->steps.size());
        }
        ETALON_TRY_STEP(TranslateBlock(function, block, places, target));
    }
    for (std::uint32_t block = 0; block < function.blocks.size(); ++block) {
        if (places[block] != kNone) {
            ETALON_TRY_STEP(TranslateEnd(function, block,
                                         function.blocks[block].instructions.back(), places,
                                         out.blocks[places[block]]));
        }
    }
    for (std::uint32_t from = 0; from < out.blocks.size(); ++from) {
        for (const Edge& edge : out.blocks[from].edges) {
            out.blocks[edge.block].is_counted |= edge.block <= from;
        }
    }
    return Ok();
}

Status<> Translator::TranslateBlock(const spirv::Function& function, std::uint32_t block,
                                    const std::vector<std::uint32_t>& places, Block& out) {
    const spirv::Block& source = function.blocks[block];
    out.merge = source.merge == kNone ? kNone : places[source.merge];
    out.is_loop = source.continue_block != kNone;
    out.line = source.instructions.back().line;
    for (std::size_t i = 0; i + 1 < source.instructions.size(); ++i) {
        if (source.instructions[i].op != spv::Op::OpPhi) {
            ETALON_TRY_STEP(TranslateStep(source.instructions[i]));
        }
    }
    out.steps = static_cast<std::uint32_t>(plan_->steps.size()) - out.first_step;
    if (plan_->steps.size() > kMostSteps) {
        return Error{"the module has more than " + std::to_string(kMostSteps) + " instructions"};
    }
    return Ok();
}

}  // namespace etalon::evaluate
