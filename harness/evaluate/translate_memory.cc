#include <algorithm>

#include "evaluate/translate.h"

namespace etalon::evaluate {
namespace {

constexpr std::uint32_t kWordBytes = 4;
constexpr std::uint32_t kInputBinding = 0;
constexpr std::uint32_t kOutputBinding = 1;
constexpr std::uint32_t kFirstImage = 2;
constexpr std::uint32_t kMostImages = 64;

std::string TypeName(const spirv::Type& type) {
    switch (type.kind) {
        case spirv::Type::Kind::kInt:
            return std::to_string(type.width) + "-bit integers";
        case spirv::Type::Kind::kFloat:
            return std::to_string(type.width) + "-bit floats";
        case spirv::Type::Kind::kPointer:
            return "pointers as data";
        case spirv::Type::Kind::kImage:
        case spirv::Type::Kind::kSampler:
        case spirv::Type::Kind::kSampledImage:
            return "images as data";
        case spirv::Type::Kind::kRuntimeArray:
            return "arrays without a length as data";
        default:
            return "values of such a type";
    }
}

}  // namespace

void Translator::LayOutTypes() {
    for (const spirv::Type& type : module_.types) {
        std::optional<Columns> size;
        switch (type.kind) {
            case Kind::kBool:
                size = Columns{0, 1};
                break;
            case Kind::kInt:
            case Kind::kFloat:
                if (type.width == 32) {
                    size = type.kind == Kind::kInt ? Columns{0, 1} : Columns{1, 0};
                }
                break;
            case Kind::kVector:
            case Kind::kMatrix:
            case Kind::kArray:
                // Both factors are small enough for the product.
                if (const auto inner = sizes_[type.element];
                    inner &&
                    (std::uint64_t{inner->floats} + inner->words) * type.count <= kMostColumns) {
                    size = *inner * type.count;
                }
                break;
            case Kind::kStruct: {
                size = Columns{};
                for (const std::uint32_t member : type.members) {
                    if (!size || !sizes_[member]) {
                        size = std::nullopt;
                        break;
                    }
                    size = *size + *sizes_[member];
                    if (size->floats + size->words > kMostColumns) {
                        size = std::nullopt;
                    }
                }
                break;
            }
            default:
                break;
        }
        sizes_.push_back(size);
    }
}

Result<Columns> Translator::SizeOf(std::uint32_t type) const {
    if (!sizes_[type]) {
        return Error{TypeName(module_.types[type]) + " are not supported"};
    }
    return Columns(*sizes_[type]);
}

Result<Columns> Translator::Allocate(std::uint32_t type) {
    ETALON_TRY(size, SizeOf(type));
    const Columns place = plan_->columns;
    plan_->columns = plan_->columns + size;
    if (std::uint64_t{plan_->columns.floats} + plan_->columns.words > kMostColumns) {
        return Error{"the module has more than " + std::to_string(kMostColumns) + " scalars"};
    }
    return Columns(place);
}

// Where the part of a composite begins in it; `type` becomes the part's.
Columns Translator::Part(std::uint32_t& type, std::uint32_t index) const {
    const spirv::Type& outer = module_.types[type];
    if (outer.kind != Kind::kStruct) {
        type = outer.element;
        return *sizes_[outer.element] * index;
    }
    Columns at;
    for (std::uint32_t i = 0; i < index; ++i) {
        at = at + *sizes_[outer.members[i]];
    }
    type = outer.members[index];
    return at;
}

std::uint32_t Translator::AddAddress(const Address& address) {
    plan_->addresses.push_back(address);
    return static_cast<std::uint32_t>(plan_->addresses.size() - 1);
}

Status<> Translator::PlaceVariable(std::uint32_t variable, std::vector<Step>& steps,
                                   bool is_set_first) {
    const spirv::Variable& source = module_.variables[variable];
    const std::uint32_t type = module_.TypeOf(source.value).element;
    const std::string& name = module_.values[source.value].name;
    Address address;
    switch (source.storage) {
        case spv::StorageClass::Function:
        case spv::StorageClass::Private: {
            auto place = Allocate(type);
            if (!place) {
                return Error{"variable '" + name + "': " + place.error().message};
            }
            address.place = *place;
            if (is_set_first) {
                break;
            }
            Step step;
            step.code = static_cast<std::uint32_t>(spv::Op::OpVariable);
            step.result = *place;
            step.size = *sizes_[type];
            step.first_operand = static_cast<std::uint32_t>(plan_->operands.size());
            if (source.initializer != kNone) {
                AddOperand(step, places_[source.initializer]);
            }
            steps.push_back(step);
            break;
        }
        case spv::StorageClass::Input: {
            if (source.built_in != static_cast<std::uint32_t>(spv::BuiltIn::GlobalInvocationId) ||
                sizes_[type] != Columns{0, 3}) {
                return Error{"input '" + name +
                             "': only gl_GlobalInvocationID is supported as an input"};
            }
            ETALON_TRY(place, Allocate(type));
            address.place = place;
            plan_->row_columns.push_back(place.words);
            break;
        }
        case spv::StorageClass::StorageBuffer:
        case spv::StorageClass::Uniform:
            if (source.set != 0 ||
                (source.binding != kInputBinding && source.binding != kOutputBinding)) {
                return Error{"buffer '" + name + "': only bindings 0 and 1 are supported"};
            }
            address.space = source.binding == kInputBinding ? Address::Space::kInputs
                                                            : Address::Space::kOutputs;
            break;
        case spv::StorageClass::UniformConstant:
            if (module_.types[type].kind != Kind::kSampledImage || source.binding < kFirstImage ||
                source.binding - kFirstImage >= kMostImages) {
                return Error{"uniform '" + name +
                             "': only samplers from binding 2 on are supported"};
            }
            address.space = Address::Space::kImage;
            address.place.words = source.binding - kFirstImage;
            plan_->images = std::max(plan_->images, address.place.words + 1);
            break;
        default:
            return Error{"variable '" + name + "': its storage class is not supported"};
    }
    addresses_[source.value] = AddAddress(address);
    return Ok();
}

// True where the first block stores to the whole variable before anything else is done with it, so
// that it needs no value of its own before.
bool Translator::IsSetFirst(const spirv::Function& function, std::uint32_t variable) const {
    const std::uint32_t own = module_.values[variable].index;
    if (module_.variables[own].initializer != kNone) {
        return false;
    }
    for (const Instruction& instruction : function.blocks[0].instructions) {
        const std::span<const std::uint32_t> operands = module_.Operands(instruction);
        if (instruction.op == spv::Op::OpStore && operands[0] == variable) {
            return true;
        }
        // A literal that happens to be the same number costs no more than the zeros.
        if (std::find(operands.begin(), operands.end(), variable) != operands.end()) {
            return false;
        }
    }
    return false;
}

// A variable that cannot be placed is refused where it is used: many are only declared.
Status<> Translator::CheckAddress(const Instruction& instruction, std::uint32_t value) const {
    if (addresses_[value] != kNone) {
        return Ok();
    }
    const auto reason = refused_.find(value);
    return Wrong(instruction,
                 reason != refused_.end() ? reason->second : "its pointer is not supported");
}

Status<> Translator::TranslateLoad(const Instruction& instruction) {
    const std::uint32_t pointer = module_.Operands(instruction)[0];
    ETALON_TRY_STEP(CheckAddress(instruction, pointer));
    const Address& address = plan_->addresses[addresses_[pointer]];
    if (address.space == Address::Space::kImage) {
        addresses_[instruction.result] = addresses_[pointer];
        return Ok();
    }
    auto place = Allocate(instruction.type);
    if (!place) {
        return Wrong(instruction, place.error().message);
    }
    const Columns size = *sizes_[instruction.type];
    if (address.space != Address::Space::kColumns && size.floats + size.words != 1) {
        return Wrong(instruction, "only scalars are loaded from buffers");
    }
    places_[instruction.result] = *place;
    Step step = MakeStep(static_cast<std::uint32_t>(spv::Op::OpLoad), instruction);
    step.address = addresses_[pointer];
    plan_->steps.push_back(step);
    return Ok();
}

Status<> Translator::TranslateStore(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    ETALON_TRY_STEP(CheckAddress(instruction, operands[0]));
    const Address& address = plan_->addresses[addresses_[operands[0]]];
    auto size = SizeOf(module_.values[operands[1]].type);
    if (!size) {
        return Wrong(instruction, size.error().message);
    }
    if (address.space == Address::Space::kInputs ||
        (address.space == Address::Space::kOutputs && size->floats + size->words != 1)) {
        return Wrong(instruction, "only scalars are stored, and into outputs");
    }
    Step step = MakeStep(static_cast<std::uint32_t>(spv::Op::OpStore), instruction);
    step.address = addresses_[operands[0]];
    step.size = *size;
    step.extra = size->floats != 0 ? places_[operands[1]].floats : bits_[operands[1]];
    AddOperand(step, places_[operands[1]]);
    plan_->steps.push_back(step);
    return Ok();
}

std::optional<std::uint32_t> Translator::ConstantWord(std::uint32_t value) const {
    const spirv::Value& source = module_.values[value];
    if (source.kind != spirv::Value::Kind::kConstant) {
        return std::nullopt;
    }
    const spirv::Constant& constant = module_.constants[source.index];
    return constant.is_null ? 0 : constant.words[0];
}

Status<> Translator::TranslateChain(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    ETALON_TRY_STEP(CheckAddress(instruction, operands[0]));
    Address address = plan_->addresses[addresses_[operands[0]]];
    if (address.space == Address::Space::kImage) {
        return Wrong(instruction, "arrays of images are not supported");
    }
    const bool in_buffer = address.space != Address::Space::kColumns;
    std::uint32_t type = module_.TypeOf(operands[0]).element;
    std::vector<Index> dynamic;
    for (const std::uint32_t operand : operands.subspan(1)) {
        const spirv::Type& outer = module_.types[type];
        const std::optional<std::uint32_t> constant = ConstantWord(operand);
        Columns stride;
        if (in_buffer) {
            const bool is_struct = outer.kind == Kind::kStruct;
            const bool is_array = outer.kind == Kind::kArray || outer.kind == Kind::kRuntimeArray;
            if (!is_struct && !is_array) {
                return Wrong(instruction, "only scalars are supported in buffers");
            }
            // The reader knows an index into a structure to be constant and within it.
            const std::uint32_t bytes = is_struct ? outer.offsets[*constant] : outer.array_stride;
            if (bytes == kNone || bytes % kWordBytes != 0 || bytes > kMostColumns) {
                return Wrong(instruction, "the buffer has no layout of words");
            }
            stride.words = bytes / kWordBytes;
            type = is_struct ? outer.members[*constant] : outer.element;
            if (is_struct) {
                address.place.words += stride.words;
                continue;
            }
        } else if (outer.kind == Kind::kStruct) {
            address.place = address.place + Part(type, *constant);
            continue;
        } else {
            stride = *sizes_[outer.element];
            type = outer.element;
        }
        const bool is_bounded = outer.kind != Kind::kRuntimeArray;
        if (constant && is_bounded && *constant >= outer.count) {
            return Wrong(instruction, "index " + std::to_string(*constant) + " is outside of " +
                                          std::to_string(outer.count) + " elements");
        }
        if (constant && *constant <= kMostColumns) {
            address.place = address.place + stride * *constant;
        } else {
            dynamic.push_back({places_[operand].words, is_bounded ? outer.count : kNone, stride});
        }
    }
    if (dynamic.empty()) {
        addresses_[instruction.result] = AddAddress(address);
        return Ok();
    }
    Step step = MakeStep(static_cast<std::uint32_t>(spv::Op::OpAccessChain), instruction);
    step.address = addresses_[operands[0]];
    step.result = {0, plan_->columns.words};
    plan_->columns.words += 2;
    if (std::uint64_t{plan_->columns.floats} + plan_->columns.words > kMostColumns) {
        return Error{"the module has more than " + std::to_string(kMostColumns) + " scalars"};
    }
    step.extra = static_cast<std::uint32_t>(plan_->chains.size());
    plan_->chains.push_back(std::move(dynamic));
    plan_->steps.push_back(step);
    address.offsets = step.result.words;
    addresses_[instruction.result] = AddAddress(address);
    return Ok();
}

// A probe's output is the bits of a number: by OpBitcast, or by a function that does only this to
// what its one parameter points to.
void Translator::NoteBits(const Instruction& instruction) {
    const std::span<const std::uint32_t> operands = module_.Operands(instruction);
    if (module_.types[instruction.type].kind != Kind::kInt) {
        return;
    }
    if (instruction.op == spv::Op::OpBitcast) {
        if (module_.TypeOf(operands[0]).kind == Kind::kFloat) {
            bits_[instruction.result] = places_[operands[0]].floats;
        }
        return;
    }
    if (!ReturnsBits(module_.functions[operands[0]])) {
        return;
    }
    if (addresses_[operands[1]] == kNone) {
        return;
    }
    const Address& address = plan_->addresses[addresses_[operands[1]]];
    if (address.slot == kNone && address.offsets == kNone) {
        bits_[instruction.result] = address.place.floats;
    }
}

bool Translator::ReturnsBits(const spirv::Function& function) const {
    if (function.parameters.size() != 1 || function.blocks.size() != 1 ||
        module_.TypeOf(function.parameters[0]).kind != Kind::kPointer) {
        return false;
    }
    const std::vector<Instruction>& body = function.blocks[0].instructions;
    return body.size() == 3 && body[0].op == spv::Op::OpLoad &&
           module_.Operands(body[0])[0] == function.parameters[0] &&
           module_.types[body[0].type].kind == Kind::kFloat && body[1].op == spv::Op::OpBitcast &&
           module_.Operands(body[1])[0] == body[0].result && body[2].op == spv::Op::OpReturnValue &&
           module_.Operands(body[2])[0] == body[1].result;
}

// True where a value is only ever stored in buffers, by its function or by those that call it. An
// operand that is a literal of the same number is taken for a use.
bool Translator::IsOutputOnly(std::uint32_t value) const {
    const std::uint32_t home = module_.values[value].function;
    const auto is_only_stored = [&](const Instruction& instruction) {
        const std::span<const std::uint32_t> operands = module_.Operands(instruction);
        if (std::find(operands.begin(), operands.end(), value) == operands.end()) {
            return true;
        }
        if (instruction.op == spv::Op::OpStore) {
            const spv::StorageClass storage = module_.TypeOf(operands[0]).storage;
            return operands[0] != value && storage != spv::StorageClass::Function &&
                   storage != spv::StorageClass::Private;
        }
        return instruction.op == spv::Op::OpReturnValue;
    };
    bool is_returned = false;
    for (const spirv::Block& block : module_.functions[home].blocks) {
        for (const Instruction& instruction : block.instructions) {
            if (!is_only_stored(instruction)) {
                return false;
            }
            is_returned = is_returned || (instruction.op == spv::Op::OpReturnValue &&
                                          module_.Operands(instruction)[0] == value);
        }
    }
    if (!is_returned) {
        return true;
    }
    for (const spirv::Function& function : module_.functions) {
        for (const spirv::Block& block : function.blocks) {
            for (const Instruction& instruction : block.instructions) {
                if (instruction.op == spv::Op::OpFunctionCall &&
                    module_.Operands(instruction)[0] == home && !IsOutputOnly(instruction.result)) {
                    return false;
                }
            }
        }
    }
    return true;
}

}  // namespace etalon::evaluate
