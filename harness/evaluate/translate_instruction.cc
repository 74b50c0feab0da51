#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <unordered_set>

#include "evaluate/translate.h"

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
