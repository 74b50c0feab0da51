#include "evaluate/faults.h"

#include <spirv/unified1/GLSL.std.450.h>

#include <map>
#include <optional>
#include <set>

#include "base/check.h"
#include "spirv/grammar.h"

namespace etalon {
namespace {

using Words = std::vector<std::uint32_t>;

Words InstructionOf(spv::Op op, const Words& operands) {
    Words words = {static_cast<std::uint32_t>(operands.size() + 1) << 16 |
                   static_cast<std::uint32_t>(op)};
    words.insert(words.end(), operands.begin(), operands.end());
    return words;
}

// Of operands a, b: where both may be given in either order without an error, but not without
// another meaning.
bool IsOrdered(spv::Op op) {
    switch (op) {
        case spv::Op::OpFSub:
        case spv::Op::OpFDiv:
        case spv::Op::OpFMod:
        case spv::Op::OpFRem:
        case spv::Op::OpISub:
        case spv::Op::OpSDiv:
        case spv::Op::OpUDiv:
        case spv::Op::OpFOrdLessThan:
        case spv::Op::OpFOrdLessThanEqual:
        case spv::Op::OpFOrdGreaterThan:
        case spv::Op::OpFOrdGreaterThanEqual:
        case spv::Op::OpSLessThan:
        case spv::Op::OpSLessThanEqual:
        case spv::Op::OpSGreaterThan:
        case spv::Op::OpSGreaterThanEqual:
            return true;
        default:
            return false;
    }
}

bool IsOrderedGlsl(std::uint32_t number) {
    switch (number) {
        case GLSLstd450Pow:
        case GLSLstd450Atan2:
        case GLSLstd450Step:
        case GLSLstd450FMix:
        case GLSLstd450SmoothStep:
        case GLSLstd450Cross:
        case GLSLstd450Reflect:
        case GLSLstd450Refract:
            return true;
        default:
            return false;
    }
}

class Injector {
  public:
    explicit Injector(std::span<const std::uint32_t> words) : words_(words.begin(), words.end()) {
        Result<spirv::RawModule> raw = spirv::CutWords(words);
        ETALON_CHECK(raw.ok());
        raw_ = std::move(*raw);
        for (const spirv::RawInstruction& instruction : raw_.instructions) {
            Learn(instruction);
        }
    }

    std::vector<Fault> Faults() {
        for (const spirv::RawInstruction& instruction : raw_.instructions) {
            SwapOperands(instruction);
            MoveConstant(instruction);
            DropNegation(instruction);
            Fuse(instruction);
            DropIteration(instruction);
        }
        return std::move(faults_);
    }

  private:
    // Of an instruction, by its place: 0 is its first word.
    std::uint32_t Word(const spirv::RawInstruction& at, std::uint32_t place) const {
        return words_[at.word + place];
    }
    std::uint32_t Length(const spirv::RawInstruction& at) const { return words_[at.word] >> 16; }

    void Learn(const spirv::RawInstruction& at) {
        if (at.result != 0) {
            defined_[at.result] = at;
        }
        if (at.op == spv::Op::OpExtInstImport) {
            glsl_ = at.result;
        } else if (at.op == spv::Op::OpDecorate &&
                   Word(at, 2) == static_cast<std::uint32_t>(spv::Decoration::NoContraction)) {
            not_contracted_.insert(Word(at, 1));
        }
    }

    // The instruction's words are replaced by these.
    Words With(const spirv::RawInstruction& at, const Words& instead) const {
        Words words = words_;
        const auto begin = words.begin() + at.word;
        words.insert(words.erase(begin, begin + Length(at)), instead.begin(), instead.end());
        return words;
    }

    void Add(Fault::Kind kind, const spirv::RawInstruction& at, Words words) {
        faults_.push_back({kind,
                           std::string(NameOf(kind)) + " at SPIR-V word " +
                               std::to_string(at.word) + " (" + spirv::OpName(at.op) + ")",
                           std::move(words)});
    }

    void SwapWords(const spirv::RawInstruction& at, std::uint32_t place) {
        if (Word(at, place) != Word(at, place + 1)) {
            Words words = words_;
            std::swap(words[at.word + place], words[at.word + place + 1]);
            Add(Fault::Kind::kOperandsSwapped, at, std::move(words));
        }
    }

    void SwapOperands(const spirv::RawInstruction& at) {
        if (IsOrdered(at.op)) {
            SwapWords(at, 3);
        } else if (at.op == spv::Op::OpSelect) {
            SwapWords(at, 4);
        } else if (at.op == spv::Op::OpExtInst && IsOrderedGlsl(Word(at, 4))) {
            SwapWords(at, 5);
        } else if (at.op == spv::Op::OpCompositeConstruct && Length(at) > 4 &&
                   defined_.at(Word(at, 3)).type == defined_.at(Word(at, 4)).type) {
            SwapWords(at, 3);
        }
    }

    void MoveConstant(const spirv::RawInstruction& at) {
        if (at.op == spv::Op::OpConstant && defined_.at(at.type).op == spv::Op::OpTypeFloat &&
            Length(at) == 4) {
            Words words = words_;
            words[at.word + 3] += 8;
            Add(Fault::Kind::kConstantOff, at, std::move(words));
        }
    }

    void DropNegation(const spirv::RawInstruction& at) {
        std::optional<spv::Op> instead;
        if (at.op == spv::Op::OpFNegate) {
            instead = spv::Op::OpCopyObject;
        } else if (at.op == spv::Op::OpFSub) {
            instead = spv::Op::OpFAdd;
        }
        if (instead) {
            Words words = words_;
            words[at.word] = Length(at) << 16 | static_cast<std::uint32_t>(*instead);
            Add(Fault::Kind::kNegationDropped, at, std::move(words));
        }
    }

    void Fuse(const spirv::RawInstruction& at) {
        const bool is_difference = at.op == spv::Op::OpFSub;
        if ((at.op != spv::Op::OpFAdd && !is_difference) || !not_contracted_.contains(at.result)) {
            return;
        }
        for (std::uint32_t place = 3; place <= 4; ++place) {
            const spirv::RawInstruction& product = defined_.at(Word(at, place));
            if (product.op != spv::Op::OpFMul || !not_contracted_.contains(product.result)) {
                continue;
            }
            std::uint32_t factor = Word(product, 3);
            std::uint32_t addend = Word(at, 7 - place);
            Words instead;
            if (is_difference) {
                // Of the second operand, which is the product or is not.
                std::uint32_t& negated = place == 4 ? factor : addend;
                instead = InstructionOf(spv::Op::OpFNegate, {at.type, raw_.bound, negated});
                negated = raw_.bound;
            }
            const Words fused = InstructionOf(
                spv::Op::OpExtInst,
                {at.type, at.result, glsl_, GLSLstd450Fma, factor, Word(product, 4), addend});
            instead.insert(instead.end(), fused.begin(), fused.end());
            Words faulty = With(at, instead);
            faulty[3] = raw_.bound + 1;
            Add(Fault::Kind::kFused, at, std::move(faulty));
        }
    }

    void DropIteration(const spirv::RawInstruction& at) {
        if (at.op != spv::Op::OpSLessThan) {
            return;
        }
        const std::uint32_t type = defined_.at(Word(at, 3)).type;
        for (const auto& [id, constant] : defined_) {
            if (constant.op != spv::Op::OpConstant || constant.type != type ||
                Word(constant, 3) != 1) {
                continue;
            }
            Words instead = InstructionOf(spv::Op::OpIAdd, {type, raw_.bound, Word(at, 3), id});
            const Words compare =
                InstructionOf(at.op, {at.type, at.result, raw_.bound, Word(at, 4)});
            instead.insert(instead.end(), compare.begin(), compare.end());
            Words faulty = With(at, instead);
            faulty[3] = raw_.bound + 1;
            Add(Fault::Kind::kIterationDropped, at, std::move(faulty));
            return;
        }
    }

    Words words_;
    spirv::RawModule raw_;
    std::map<std::uint32_t, spirv::RawInstruction> defined_;  // by id
    std::set<std::uint32_t> not_contracted_;                  // ids
    std::uint32_t glsl_ = 0;
    std::vector<Fault> faults_;
};

}  // namespace

std::string_view NameOf(Fault::Kind kind) {
    switch (kind) {
        case Fault::Kind::kOperandsSwapped:
            return "operands swapped";
        case Fault::Kind::kConstantOff:
            return "constant off by eight ulp";
        case Fault::Kind::kNegationDropped:
            return "negation dropped";
        case Fault::Kind::kFused:
            return "fused in spite of NoContraction";
        case Fault::Kind::kIterationDropped:
            return "iteration dropped";
    }
    return "";
}

std::vector<Fault> FaultsOf(std::span<const std::uint32_t> spirv) {
    return Injector(spirv).Faults();
}

}  // namespace etalon
