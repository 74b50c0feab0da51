#include "spirv/watch.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <algorithm>
#include <unordered_map>

namespace etalon::spirv {
namespace {

constexpr std::size_t kHeaderWords = 5;
constexpr std::size_t kBoundWord = 3;
constexpr std::uint32_t kOutputBinding = 1;

using Words = std::vector<std::uint32_t>;

spv::Op OpAt(std::span<const std::uint32_t> words, std::size_t at) {
    return static_cast<spv::Op>(words[at] & 0xffffu);
}
std::uint32_t LengthAt(std::span<const std::uint32_t> words, std::size_t at) {
    return words[at] >> 16;
}

void AddLeaves(const Module& module, std::uint32_t type, std::vector<std::uint32_t>& path,
               std::vector<Leaf>& leaves) {
    const Type& outer = module.types[type];
    switch (outer.kind) {
        case Type::Kind::kBool:
        case Type::Kind::kInt:
        case Type::Kind::kFloat:
            leaves.push_back({path, type});
            return;
        case Type::Kind::kVector:
        case Type::Kind::kMatrix:
        case Type::Kind::kArray:
        case Type::Kind::kStruct: {
            const bool is_struct = outer.kind == Type::Kind::kStruct;
            const auto count =
                is_struct ? static_cast<std::uint32_t>(outer.members.size()) : outer.count;
            for (std::uint32_t i = 0; i < count; ++i) {
                path.push_back(i);
                AddLeaves(module, is_struct ? outer.members[i] : outer.element, path, leaves);
                path.pop_back();
            }
            return;
        }
        default:
            return;
    }
}

bool HasFloats(const Module& module, std::uint32_t value) {
    // A pointer's target is not what the instruction computes with.
    return module.values[value].type != kNone &&
           module.TypeOf(value).kind != Type::Kind::kPointer &&
           CountFloats(module, module.values[value].type) != 0;
}

bool OnlyMoves(spv::Op op) {
    switch (op) {
        case spv::Op::OpPhi:
        case spv::Op::OpLoad:
        case spv::Op::OpStore:
        case spv::Op::OpAccessChain:
        case spv::Op::OpInBoundsAccessChain:
        case spv::Op::OpFunctionCall:
        case spv::Op::OpVectorExtractDynamic:
        case spv::Op::OpVectorInsertDynamic:
        case spv::Op::OpVectorShuffle:
        case spv::Op::OpCompositeConstruct:
        case spv::Op::OpCompositeExtract:
        case spv::Op::OpCompositeInsert:
        case spv::Op::OpCopyObject:
        case spv::Op::OpTranspose:
        case spv::Op::OpSelect:
        case spv::Op::OpBitcast:
        case spv::Op::OpImage:
            return true;
        default:
            return false;
    }
}

// Adds declarations to a module, or finds those that are there: no type may be declared twice.
class Declarations {
  public:
    explicit Declarations(std::span<const std::uint32_t> words) : next_(words[kBoundWord]) {
        for (std::size_t at = kHeaderWords; at < words.size(); at += LengthAt(words, at)) {
            const spv::Op op = OpAt(words, at);
            if (op == spv::Op::OpFunction) {
                break;
            }
            if (op >= spv::Op::OpTypeVoid && op <= spv::Op::OpTypeFunction) {
                Words key(words.begin() + static_cast<std::ptrdiff_t>(at),
                          words.begin() + static_cast<std::ptrdiff_t>(at + LengthAt(words, at)));
                const std::uint32_t id = key[1];
                key.erase(key.begin() + 1);
                types_.emplace_back(std::move(key), id);
            }
        }
    }

    std::uint32_t NewId() { return next_++; }
    std::uint32_t bound() const { return next_; }
    const Words& added() const { return added_; }

    std::uint32_t Type(spv::Op op, const Words& operands) {
        Words key = {Head(op, operands.size() + 2)};
        key.insert(key.end(), operands.begin(), operands.end());
        const auto found = std::find_if(types_.begin(), types_.end(),
                                        [&](const auto& one) { return one.first == key; });
        if (found != types_.end()) {
            return found->second;
        }
        const std::uint32_t id = NewId();
        added_.insert(added_.end(), {key[0], id});
        added_.insert(added_.end(), operands.begin(), operands.end());
        types_.emplace_back(std::move(key), id);
        return id;
    }
    std::uint32_t Pointer(spv::StorageClass storage, std::uint32_t type) {
        return Type(spv::Op::OpTypePointer, {static_cast<std::uint32_t>(storage), type});
    }
    std::uint32_t Uint() { return Type(spv::Op::OpTypeInt, {32, 0}); }
    std::uint32_t UintConstant(std::uint32_t value) {
        if (const auto found = constants_.find(value); found != constants_.end()) {
            return found->second;
        }
        const std::uint32_t type = Uint();
        const std::uint32_t id = NewId();
        added_.insert(added_.end(), {Head(spv::Op::OpConstant, 4), type, id, value});
        constants_.emplace(value, id);
        return id;
    }
    std::uint32_t PrivateUint(std::uint32_t initializer) {
        const std::uint32_t type = Pointer(spv::StorageClass::Private, Uint());
        const std::uint32_t id = NewId();
        added_.insert(added_.end(),
                      {Head(spv::Op::OpVariable, 5), type, id,
                       static_cast<std::uint32_t>(spv::StorageClass::Private), initializer});
        return id;
    }

    static std::uint32_t Head(spv::Op op, std::size_t words) {
        return static_cast<std::uint32_t>(words << 16) | static_cast<std::uint32_t>(op);
    }

  private:
    std::uint32_t next_;
    std::vector<std::pair<Words, std::uint32_t>> types_;  // without the id
    std::unordered_map<std::uint32_t, std::uint32_t> constants_;
    Words added_;
};

class Watcher {
  public:
    Watcher(std::span<const std::uint32_t> words, const Module& module, WatchPlace place)
        : words_(words), module_(module), place_(place), declared_(words) {}

    Result<Words> Add(std::span<const std::uint32_t> chosen) {
        ETALON_TRY_STEP(FindOutputs());
        uint_ = declared_.Uint();
        word_pointer_ = declared_.Pointer(outputs_storage_, uint_);
        counter_ = declared_.PrivateUint(declared_.UintConstant(0));
        function_ = declared_.NewId();
        const std::vector<std::uint32_t> watchable = Watchable(module_);
        std::unordered_map<std::uint32_t, std::uint32_t> places;  // by word
        for (const std::uint32_t one : chosen) {
            places.emplace(watchable[one], one);
        }
        std::unordered_map<std::uint32_t, Words> after;  // by word of the instruction
        for (const Function& function : module_.functions) {
            for (const Block& block : function.blocks) {
                for (const Instruction& instruction : block.instructions) {
                    if (const auto place = places.find(instruction.word); place != places.end()) {
                        after[instruction.word] = Tell(instruction, place->second);
                    } else if (StoresOutput(instruction)) {
                        after[instruction.word] = TellCount();
                    }
                }
            }
        }
        const Words body = Body();  // declares what it needs
        Words watched(words_.begin(), words_.begin() + kHeaderWords);
        bool is_declared = false;
        for (std::size_t at = kHeaderWords; at < words_.size(); at += LengthAt(words_, at)) {
            if (!is_declared && OpAt(words_, at) == spv::Op::OpFunction) {
                Append(watched, declared_.added());
                is_declared = true;
            }
            Append(watched, words_.subspan(at, LengthAt(words_, at)));
            if (const auto more = after.find(static_cast<std::uint32_t>(at)); more != after.end()) {
                Append(watched, more->second);
            }
        }
        Append(watched, body);
        watched[kBoundWord] = declared_.bound();
        return watched;
    }

  private:
    static void Append(Words& to, std::span<const std::uint32_t> from) {
        to.insert(to.end(), from.begin(), from.end());
    }
    static void Emit(Words& to, spv::Op op, const Words& operands) {
        to.push_back(Declarations::Head(op, operands.size() + 1));
        Append(to, operands);
    }

    Status<> FindOutputs() {
        for (std::size_t at = kHeaderWords; at < words_.size(); at += LengthAt(words_, at)) {
            if (OpAt(words_, at) == spv::Op::OpDecorate && LengthAt(words_, at) == 4 &&
                words_[at + 2] == static_cast<std::uint32_t>(spv::Decoration::Binding) &&
                words_[at + 3] == kOutputBinding) {
                outputs_ = words_[at + 1];
            }
            if (OpAt(words_, at) == spv::Op::OpVariable && words_[at + 2] == outputs_) {
                outputs_storage_ = static_cast<spv::StorageClass>(words_[at + 3]);
                return Ok();
            }
        }
        return Error{"the module has no outputs at binding 1"};
    }

    bool StoresOutput(const Instruction& instruction) {
        if (instruction.op != spv::Op::OpStore) {
            return false;
        }
        const Type& pointer = module_.TypeOf(module_.Operands(instruction)[0]);
        return pointer.storage == outputs_storage_;
    }

    // A constant per word of the place would do, but the module's access chains show the way: the
    // member 0 of the block, then the word.
    std::uint32_t PointerTo(Words& to, std::uint32_t index) {
        const std::uint32_t id = declared_.NewId();
        Emit(to, spv::Op::OpAccessChain,
             {word_pointer_, id, outputs_, declared_.UintConstant(0), index});
        return id;
    }
    std::uint32_t Result2(Words& to, spv::Op op, std::uint32_t type, std::uint32_t a,
                          std::uint32_t b) {
        const std::uint32_t id = declared_.NewId();
        Emit(to, op, {type, id, a, b});
        return id;
    }
    std::uint32_t LoadCounter(Words& to) {
        const std::uint32_t id = declared_.NewId();
        Emit(to, spv::Op::OpLoad, {uint_, id, counter_});
        return id;
    }

    Words TellCount() {
        Words to;
        const std::uint32_t count = LoadCounter(to);
        Emit(to, spv::Op::OpStore, {PointerTo(to, declared_.UintConstant(place_.first)), count});
        return to;
    }

    // After an instruction: a call for each leaf of its result.
    Words Tell(const Instruction& instruction, std::uint32_t place) {
        Words to;
        const std::uint32_t result = words_[instruction.word + 2];
        const std::vector<Leaf> leaves = Leaves(module_, instruction.type);
        for (std::uint32_t i = 0; i < leaves.size() && i < kWatchLeaves; ++i) {
            std::uint32_t leaf = result;
            if (!leaves[i].path.empty()) {
                leaf = declared_.NewId();
                Words operands = {ScalarType(leaves[i].type), leaf, result};
                Append(operands, leaves[i].path);
                Emit(to, spv::Op::OpCompositeExtract, operands);
            }
            const std::uint32_t word = AsWord(to, leaves[i].type, leaf);
            Emit(to, spv::Op::OpFunctionCall,
                 {declared_.Type(spv::Op::OpTypeVoid, {}), declared_.NewId(), function_,
                  declared_.UintConstant(PackMark({place, i})), word});
        }
        return to;
    }

    std::uint32_t ScalarType(std::uint32_t type) {
        const spirv::Type& scalar = module_.types[type];
        switch (scalar.kind) {
            case Type::Kind::kBool:
                return declared_.Type(spv::Op::OpTypeBool, {});
            case Type::Kind::kInt:
                return declared_.Type(spv::Op::OpTypeInt, {32, scalar.is_signed ? 1u : 0u});
            default:
                return declared_.Type(spv::Op::OpTypeFloat, {32});
        }
    }

    std::uint32_t AsWord(Words& to, std::uint32_t type, std::uint32_t scalar) {
        const spirv::Type& from = module_.types[type];
        if (from.kind == Type::Kind::kInt && !from.is_signed) {
            return scalar;
        }
        const std::uint32_t id = declared_.NewId();
        if (from.kind == Type::Kind::kBool) {
            Emit(to, spv::Op::OpSelect,
                 {uint_, id, scalar, declared_.UintConstant(1), declared_.UintConstant(0)});
        } else {
            Emit(to, spv::Op::OpBitcast, {uint_, id, scalar});
        }
        return id;
    }

    // void f(uint mark, uint word) { i = min(counter, most); out[first + 1 + 2 i] = mark; ... }
    Words Body() {
        const std::uint32_t void_type = declared_.Type(spv::Op::OpTypeVoid, {});
        const std::uint32_t type =
            declared_.Type(spv::Op::OpTypeFunction, {void_type, uint_, uint_});
        const std::uint32_t mark = declared_.NewId();
        const std::uint32_t word = declared_.NewId();
        const std::uint32_t most = declared_.UintConstant(place_.most);
        const std::uint32_t one = declared_.UintConstant(1);
        Words to;
        Emit(to, spv::Op::OpFunction, {void_type, function_, 0, type});
        Emit(to, spv::Op::OpFunctionParameter, {uint_, mark});
        Emit(to, spv::Op::OpFunctionParameter, {uint_, word});
        Emit(to, spv::Op::OpLabel, {declared_.NewId()});
        const std::uint32_t count = LoadCounter(to);
        const std::uint32_t is_within =
            Result2(to, spv::Op::OpULessThan, declared_.Type(spv::Op::OpTypeBool, {}), count, most);
        const std::uint32_t index = declared_.NewId();
        Emit(to, spv::Op::OpSelect, {uint_, index, is_within, count, most});
        const std::uint32_t twice = Result2(to, spv::Op::OpIAdd, uint_, index, index);
        const std::uint32_t at =
            Result2(to, spv::Op::OpIAdd, uint_, twice, declared_.UintConstant(place_.first + 1));
        Emit(to, spv::Op::OpStore, {PointerTo(to, at), mark});
        const std::uint32_t next = Result2(to, spv::Op::OpIAdd, uint_, at, one);
        Emit(to, spv::Op::OpStore, {PointerTo(to, next), word});
        Emit(to, spv::Op::OpStore, {counter_, Result2(to, spv::Op::OpIAdd, uint_, count, one)});
        Emit(to, spv::Op::OpReturn, {});
        Emit(to, spv::Op::OpFunctionEnd, {});
        return to;
    }

    std::span<const std::uint32_t> words_;
    const Module& module_;
    WatchPlace place_;
    Declarations declared_;
    std::uint32_t outputs_ = kNone;
    spv::StorageClass outputs_storage_ = {};
    std::uint32_t uint_ = 0;
    std::uint32_t word_pointer_ = 0;
    std::uint32_t counter_ = 0;
    std::uint32_t function_ = 0;
};

}  // namespace

std::vector<Leaf> Leaves(const Module& module, std::uint32_t type) {
    std::vector<Leaf> leaves;
    std::vector<std::uint32_t> path;
    AddLeaves(module, type, path, leaves);
    std::stable_partition(leaves.begin(), leaves.end(), [&](const Leaf& leaf) {
        return module.types[leaf.type].kind == Type::Kind::kFloat;
    });
    return leaves;
}

std::uint32_t CountFloats(const Module& module, std::uint32_t type) {
    const Type& outer = module.types[type];
    switch (outer.kind) {
        case Type::Kind::kFloat:
            return 1;
        case Type::Kind::kVector:
        case Type::Kind::kMatrix:
        case Type::Kind::kArray:
            return CountFloats(module, outer.element) * outer.count;
        case Type::Kind::kStruct: {
            std::uint32_t count = 0;
            for (const std::uint32_t member : outer.members) {
                count += CountFloats(module, member);
            }
            return count;
        }
        default:
            return 0;
    }
}

bool IsWatchable(const Module& module, const Instruction& instruction) {
    if (instruction.result == kNone || OnlyMoves(instruction.op)) {
        return false;
    }
    if (HasFloats(module, instruction.result)) {
        return true;
    }
    std::span<const std::uint32_t> operands = module.Operands(instruction);
    switch (instruction.op) {
        case spv::Op::OpExtInst:
            operands = operands.subspan(1);
            break;
        case spv::Op::OpArrayLength:
        case spv::Op::OpImageQuerySizeLod:
        case spv::Op::OpImageQueryLevels:
            return false;
        default:
            break;
    }
    return std::any_of(operands.begin(), operands.end(),
                       [&](std::uint32_t value) { return HasFloats(module, value); });
}

std::vector<std::uint32_t> Watchable(const Module& module) {
    std::vector<std::uint32_t> words;
    for (const Function& function : module.functions) {
        for (const Block& block : function.blocks) {
            for (const Instruction& instruction : block.instructions) {
                if (IsWatchable(module, instruction)) {
                    words.push_back(instruction.word);
                }
            }
        }
    }
    std::sort(words.begin(), words.end());
    return words;
}

Result<std::vector<std::uint32_t>> Watch(std::span<const std::uint32_t> words, const Module& module,
                                         WatchPlace place, std::span<const std::uint32_t> chosen) {
    return Watcher(words, module, place).Add(chosen);
}

}  // namespace etalon::spirv
