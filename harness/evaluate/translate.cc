#include "evaluate/translate.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <unordered_set>

namespace etalon::evaluate {
namespace {

bool HasRow(std::uint32_t code) {
    static const std::unordered_set<std::uint32_t> codes = {
#define ETALON_OPERATION(name) static_cast<std::uint32_t>(spv::Op::Op##name),
#include "evaluate/operations.def"
#undef ETALON_OPERATION
#define ETALON_GLSL_OPERATION(name) kGlslCode + GLSLstd450##name,
#include "evaluate/glsl_operations.def"
#undef ETALON_GLSL_OPERATION
    };
    return codes.count(code) != 0;
}

}  // namespace

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

Step Translator::MakeStep(std::uint32_t code, const Instruction& instruction) {
    Step step;
    step.code = code;
    step.line = instruction.line;
    step.value = instruction.result;
    step.word = instruction.word;
    step.first_operand = static_cast<std::uint32_t>(plan_->operands.size());
    step.first_literal = static_cast<std::uint32_t>(plan_->literals.size());
    if (instruction.result != kNone) {
        step.result = places_[instruction.result];
        step.size = sizes_[instruction.type].value_or(Columns{});
        step.components = step.size.floats + step.size.words;
    }
    return step;
}

void Translator::AddOperand(Step& step, Columns place) {
    plan_->operands.push_back(place);
    ++step.operands;
}

Status<> Translator::TranslateStep(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    switch (instruction.op) {
        case spv::Op::OpNop:
            return Ok();
        case spv::Op::OpLoad:
            return TranslateLoad(instruction);
        case spv::Op::OpStore:
            return TranslateStore(instruction);
        case spv::Op::OpAccessChain:
        case spv::Op::OpInBoundsAccessChain:
            return TranslateChain(instruction);
        case spv::Op::OpFunctionCall:
            return TranslateCall(instruction);
        case spv::Op::OpExtInst:
            return TranslateExtended(instruction);
        case spv::Op::OpImage:
            addresses_[instruction.result] = addresses_[operands[0]];
            return Ok();
        case spv::Op::OpImageSampleExplicitLod:
        case spv::Op::OpImageFetch:
        case spv::Op::OpImageQuerySizeLod:
        case spv::Op::OpImageQueryLevels:
            return TranslateImage(instruction);
        case spv::Op::OpCopyObject:
            places_[instruction.result] = places_[operands[0]];
            addresses_[instruction.result] = addresses_[operands[0]];
            if (addresses_[operands[0]] == kNone) {
                ETALON_TRY_STEP(SizeOf(instruction.type));
            }
            return Ok();
        case spv::Op::OpCompositeExtract: {
            // A part of a value is a range of its columns.
            ETALON_TRY_STEP(SizeOf(module_.values[operands[0]].type));
            std::uint32_t type = module_.values[operands[0]].type;
            Columns place = places_[operands[0]];
            for (const std::uint32_t index : operands.subspan(1)) {
                place = place + Part(type, index);
            }
            places_[instruction.result] = place;
            return Ok();
        }
        default:
            return TranslateOrdinary(instruction);
    }
}

Status<> Translator::TranslateOrdinary(const Instruction& instruction) {
    const auto code = static_cast<std::uint32_t>(instruction.op);
    if (!HasRow(code)) {
        return Wrong(instruction, "is not supported");
    }
    std::span<const std::uint32_t> operands = module_.Operands(instruction);
    std::size_t values = operands.size();
    if (instruction.op == spv::Op::OpVectorShuffle ||
        instruction.op == spv::Op::OpCompositeInsert) {
        values = 2;
    }
    for (const std::uint32_t operand : operands.first(values)) {
        if (auto size = SizeOf(module_.values[operand].type); !size) {
            return Wrong(instruction, size.error().message);
        }
    }
    auto place = Allocate(instruction.type);
    if (!place) {
        return Wrong(instruction, place.error().message);
    }
    places_[instruction.result] = *place;
    Step step = MakeStep(code, instruction);
    for (const std::uint32_t operand : operands.first(values)) {
        AddOperand(step, places_[operand]);
    }
    const auto columns = [&](std::uint32_t value) {
        const Columns size = *sizes_[module_.values[value].type];
        return size.floats + size.words;
    };
    const auto literal = [&](std::uint32_t word) {
        plan_->literals.push_back(word);
        ++step.literals;
    };
    switch (instruction.op) {
        case spv::Op::OpVectorShuffle: {
            const std::uint32_t first = columns(operands[0]);
            for (const std::uint32_t index : operands.subspan(2)) {
                // Where any component will do, it is the first.
                literal(index == 0xffffffffu ? 0 : index);
            }
            step.extra = first;
            break;
        }
        case spv::Op::OpCompositeInsert: {
            std::uint32_t type = instruction.type;
            Columns at;
            for (const std::uint32_t index : operands.subspan(2)) {
                at = at + Part(type, index);
            }
            AddOperand(step, at);
            AddOperand(step, *sizes_[type]);
            break;
        }
        case spv::Op::OpCompositeConstruct:
            for (const std::uint32_t operand : operands) {
                AddOperand(step, *sizes_[module_.values[operand].type]);
            }
            break;
        case spv::Op::OpMatrixTimesVector:
        case spv::Op::OpMatrixTimesMatrix:
        case spv::Op::OpMatrixTimesScalar:
        case spv::Op::OpTranspose: {
            const spirv::Type& matrix = module_.TypeOf(operands[0]);
            literal(matrix.count);
            literal(module_.types[matrix.element].count);
            break;
        }
        case spv::Op::OpSelect:
        case spv::Op::OpVectorExtractDynamic:
        case spv::Op::OpVectorTimesMatrix:
        case spv::Op::OpOuterProduct:
        case spv::Op::OpDot:
        case spv::Op::OpAny:
        case spv::Op::OpAll:
            step.extra = columns(operands[0]);
            break;
        case spv::Op::OpBitcast:
            NoteBits(instruction);
            step.is_output_only = IsOutputOnly(instruction.result);
            step.extra = sizes_[module_.values[operands[0]].type]->floats;
            break;
        default:
            break;
    }
    plan_->steps.push_back(step);
    return Ok();
}

Status<> Translator::TranslateExtended(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    std::uint32_t number = operands[0];
    const bool through_pointer = number == GLSLstd450Modf || number == GLSLstd450Frexp;
    std::span<const std::uint32_t> values = operands.subspan(1);
    if (through_pointer) {
        number = number == GLSLstd450Modf ? GLSLstd450ModfStruct : GLSLstd450FrexpStruct;
        values = values.first(1);
    }
    if (!HasRow(kGlslCode + number)) {
        return Wrong(instruction, spirv::GlslName(number) + " is not supported");
    }
    for (const std::uint32_t value : values) {
        if (auto size = SizeOf(module_.values[value].type); !size) {
            return Wrong(instruction, size.error().message);
        }
    }
    auto place = Allocate(instruction.type);
    if (!place) {
        return Wrong(instruction, place.error().message);
    }
    places_[instruction.result] = *place;
    Columns second;
    Address target;
    if (through_pointer) {
        const std::uint32_t type = module_.TypeOf(operands[2]).element;
        ETALON_TRY_STEP(CheckAddress(instruction, operands[2]));
        target = plan_->addresses[addresses_[operands[2]]];
        if (target.space != Address::Space::kColumns) {
            return Wrong(instruction, "a pointer into a buffer is not supported here");
        }
        // It comes right after the result, as in a structure of both.
        ETALON_TRY(more, Allocate(type));
        second = more;
    }
    Step step = MakeStep(kGlslCode + number, instruction);
    for (const std::uint32_t value : values) {
        AddOperand(step, places_[value]);
    }
    const Columns first = *sizes_[module_.values[values[0]].type];
    // Of what the operands have: a length is one number of many components.
    step.extra = first.floats + first.words;
    if (number == GLSLstd450ModfStruct || number == GLSLstd450FrexpStruct) {
        step.components = first.floats;
    }
    if (number == GLSLstd450Determinant || number == GLSLstd450MatrixInverse) {
        step.extra = module_.TypeOf(values[0]).count;
    }
    plan_->steps.push_back(step);
    if (through_pointer) {
        Step store = MakeStep(static_cast<std::uint32_t>(spv::Op::OpStore), instruction);
        store.address = addresses_[operands[2]];
        store.size = *sizes_[module_.TypeOf(operands[2]).element];
        AddOperand(store, second);
        plan_->steps.push_back(store);
    }
    return Ok();
}

Status<> Translator::TranslateCall(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    const spirv::Function& function = module_.functions[operands[0]];
    Call call;
    call.function = operands[0];
    for (std::size_t i = 0; i < function.parameters.size(); ++i) {
        const std::uint32_t argument = operands[i + 1];
        const std::uint32_t parameter = function.parameters[i];
        if (slots_[call.function][i] != kNone) {
            ETALON_TRY_STEP(CheckAddress(instruction, argument));
            call.pointers.push_back({slots_[call.function][i], addresses_[argument]});
        } else {
            ETALON_TRY(size, SizeOf(module_.values[argument].type));
            call.values.push_back({places_[argument], places_[parameter], size});
        }
    }
    if (module_.types[instruction.type].kind != Kind::kVoid) {
        ETALON_TRY(place, Allocate(instruction.type));
        places_[instruction.result] = place;
        call.result = {plan_->functions[call.function].result, place,
                       plan_->functions[call.function].result_size};
    }
    NoteBits(instruction);
    Step step = MakeStep(static_cast<std::uint32_t>(instruction.op), instruction);
    step.extra = static_cast<std::uint32_t>(plan_->calls.size());
    plan_->calls.push_back(std::move(call));
    plan_->steps.push_back(step);
    return Ok();
}

// The literals: the mask of image operands, whether the image is a cube, how many numbers the
// coordinate has.
Status<> Translator::TranslateImage(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    const spirv::Type* image = &module_.TypeOf(operands[0]);
    if (image->kind == Kind::kSampledImage) {
        image = &module_.types[image->element];
    }
    const bool is_cube = image->dimension == spv::Dim::Cube;
    if ((image->dimension != spv::Dim::Dim2D && !is_cube) || image->is_arrayed ||
        image->is_multisampled || image->is_depth ||
        module_.types[image->element].kind != Kind::kFloat) {
        return Wrong(instruction, "only sampler2D and samplerCube are supported");
    }
    if (addresses_[operands[0]] == kNone) {
        return Wrong(instruction, "its image is no variable");
    }
    const bool has_coordinate = instruction.op == spv::Op::OpImageSampleExplicitLod ||
                                instruction.op == spv::Op::OpImageFetch;
    const std::uint32_t mask = has_coordinate && operands.size() > 2 ? operands[2] : 0;
    constexpr auto kLod = static_cast<std::uint32_t>(spv::ImageOperandsMask::Lod);
    if (has_coordinate && mask != kLod && !(mask == 0 && instruction.op == spv::Op::OpImageFetch)) {
        return Wrong(instruction, "other image operands than a level are not supported");
    }
    if (is_cube && instruction.op == spv::Op::OpImageFetch) {
        return Wrong(instruction, "a cube has no texels to fetch");
    }
    ETALON_TRY(place, Allocate(instruction.type));
    places_[instruction.result] = place;
    const spirv::Numbers result = spirv::NumbersOf(module_, instruction.type);
    const bool is_size = instruction.op == spv::Op::OpImageQuerySizeLod;
    if (result.count != (has_coordinate ? 4u
                         : is_size      ? 2u
                                        : 1u) ||
        (has_coordinate && result.kind != Kind::kFloat)) {
        return Wrong(instruction, "its result has the wrong type");
    }
    Step step = MakeStep(static_cast<std::uint32_t>(instruction.op), instruction);
    step.address = addresses_[operands[0]];
    if (has_coordinate) {
        const std::uint32_t count =
            spirv::NumbersOf(module_, module_.values[operands[1]].type).count;
        if (count < (is_cube ? 3u : 2u)) {
            return Wrong(instruction, "its coordinate has too few components");
        }
        AddOperand(step, places_[operands[1]]);
    }
    if (mask == kLod) {
        const spirv::Numbers level = spirv::NumbersOf(module_, module_.values[operands[3]].type);
        const bool is_fetch = instruction.op == spv::Op::OpImageFetch;
        if (level.count != 1 || level.kind != (is_fetch ? Kind::kInt : Kind::kFloat)) {
            return Wrong(instruction, "its level has the wrong type");
        }
        AddOperand(step, places_[operands[3]]);
    } else if (is_size) {
        AddOperand(step, places_[operands[1]]);
    }
    plan_->steps.push_back(step);
    return Ok();
}

}  // namespace etalon::evaluate
