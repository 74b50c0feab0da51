#include "spirv/grammar.h"

#include <array>
#include <string_view>
#include <unordered_map>

#include "spirv/read.h"

namespace etalon::spirv {
namespace {

constexpr std::uint32_t kHeaderWords = 5;
constexpr std::uint32_t kHighestVersion = 0x00010600;

struct Layout {
    const char* name;
    const char* letters;
    Rule rule;
};

const std::unordered_map<std::uint32_t, Layout>& Layouts() {
    static const std::unordered_map<std::uint32_t, Layout> layouts = {
#define ETALON_INSTRUCTION(name, letters, rule) \
    {static_cast<std::uint32_t>(spv::Op::name), {#name, letters, Rule::rule}},
#include "spirv/instructions.def"
#undef ETALON_INSTRUCTION
    };
    return layouts;
}

const std::unordered_map<std::uint32_t, const char*>& UnreadNames() {
    static const std::unordered_map<std::uint32_t, const char*> names = {
#define ETALON_UNREAD(name) {static_cast<std::uint32_t>(spv::Op::name), #name},
#include "spirv/unread.def"
#undef ETALON_UNREAD
    };
    return names;
}

// Words of an image operand, by its bit from the lowest on.
constexpr std::array<std::uint32_t, 8> kImageOperandWords = {1, 1, 2, 1, 1, 1, 1, 1};
constexpr std::uint32_t kVolatile = 1;
constexpr std::uint32_t kAligned = 2;
constexpr std::uint32_t kNontemporal = 4;

// Reads the operands of one instruction.
class Cutter {
  public:
    Cutter(std::span<const std::uint32_t> words, std::uint32_t end, RawModule& module,
           RawInstruction& instruction)
        : words_(words), at_(instruction.word + 1), end_(end), module_(module), raw_(instruction) {}

    Status<> Cut(std::string_view letters) {
        raw_.first_operand = static_cast<std::uint32_t>(module_.operands.size());
        bool optional = false;
        for (std::size_t i = 0; i < letters.size(); ++i) {
            if (letters[i] == '?') {
                optional = true;
                continue;
            }
            if (i + 1 < letters.size() && letters[i + 1] == '*') {
                while (at_ < end_) {
                    ETALON_TRY_STEP(One(letters[i]));
                }
                break;
            }
            if (optional && at_ == end_) {
                break;
            }
            ETALON_TRY_STEP(One(letters[i]));
        }
        if (at_ != end_) {
            return At(raw_.word, raw_.op, "has operands beyond those that it takes");
        }
        raw_.operands = static_cast<std::uint32_t>(module_.operands.size()) - raw_.first_operand;
        return Ok();
    }

  private:
    Status<> One(char letter) {
        switch (letter) {
            case 'm':
                return at_ == end_ ? Status<>(Ok()) : MemoryAccess();
            case 'i':
                return at_ == end_ ? Status<>(Ok()) : ImageOperands();
            case 'n':
                ETALON_TRY_STEP(One('#'));
                return at_ == end_ ? Status<>(Ok()) : One('#');
            case 'w':
                return Pairs('#', 'b');
            case 'p':
                return Pairs('V', 'b');
            case '$':
                return String();
            default:
                break;
        }
        if (at_ == end_) {
            return At(raw_.word, raw_.op, "lacks an operand");
        }
        const std::uint32_t word = words_[at_++];
        if (letter != '#' && (word == 0 || word >= module_.bound)) {
            return At(raw_.word, raw_.op,
                      "has the id " + std::to_string(word) + ", not below the bound");
        }
        if (letter == 'T') {
            raw_.type = word;
        } else if (letter == 'R') {
            raw_.result = word;
        } else {
            module_.operands.push_back({letter, word});
        }
        return Ok();
    }

    Status<> Pairs(char first, char second) {
        while (at_ < end_) {
            ETALON_TRY_STEP(One(first));
            ETALON_TRY_STEP(One(second));
        }
        return Ok();
    }

    Status<> MemoryAccess() {
        const std::uint32_t mask = words_[at_];
        if ((mask & ~(kVolatile | kAligned | kNontemporal)) != 0) {
            return At(raw_.word, raw_.op, "has an unknown memory access " + std::to_string(mask));
        }
        ETALON_TRY_STEP(One('#'));
        return (mask & kAligned) != 0 ? One('#') : Status<>(Ok());
    }

    Status<> ImageOperands() {
        const std::uint32_t mask = words_[at_];
        if (mask >> kImageOperandWords.size() != 0) {
            return At(raw_.word, raw_.op, "has an unknown image operand " + std::to_string(mask));
        }
        ETALON_TRY_STEP(One('#'));
        for (std::size_t bit = 0; bit < kImageOperandWords.size(); ++bit) {
            for (std::uint32_t i = 0; (mask >> bit & 1u) != 0 && i < kImageOperandWords[bit]; ++i) {
                ETALON_TRY_STEP(One('v'));
            }
        }
        return Ok();
    }

    Status<> String() {
        module_.operands.push_back({'$', at_});
        while (at_ < end_) {
            if (words_[at_++] >> 24 == 0) {
                return Ok();
            }
        }
        return At(raw_.word, raw_.op, "has a string without an end");
    }

    std::span<const std::uint32_t> words_;
    std::uint32_t at_;
    std::uint32_t end_;
    RawModule& module_;
    RawInstruction& raw_;
};

}  // namespace

std::string OpName(spv::Op op) {
    const auto code = static_cast<std::uint32_t>(op);
    if (const auto found = Layouts().find(code); found != Layouts().end()) {
        return found->second.name;
    }
    if (const auto found = UnreadNames().find(code); found != UnreadNames().end()) {
        return found->second;
    }
    return "instruction " + std::to_string(code);
}

Error At(std::uint32_t word, spv::Op op, const std::string& reason) {
    return Error{"SPIR-V word " + std::to_string(word) + ": " + OpName(op) + ": " + reason};
}

std::string StringAt(std::span<const std::uint32_t> words, std::uint32_t word) {
    std::string text;
    for (;; ++word) {
        for (std::uint32_t shift = 0; shift < 32; shift += 8) {
            const char c = static_cast<char>(words[word] >> shift & 0xffu);
            if (c == '\0') {
                return text;
            }
            text += c;
        }
    }
}

Result<RawModule> CutWords(std::span<const std::uint32_t> words) {
    if (words.size() < kHeaderWords) {
        return Error{"SPIR-V: " + std::to_string(words.size()) + " words are no module"};
    }
    if (words.size() > kMostWords) {
        return Error{"SPIR-V: the module is longer than " + std::to_string(kMostWords) + " words"};
    }
    if (words[0] != spv::MagicNumber) {
        return Error{"SPIR-V word 0: not the magic number of SPIR-V in this machine's byte order"};
    }
    if (words[1] > kHighestVersion || words[1] < 0x00010000 || (words[1] & 0xffu) != 0) {
        return Error{"SPIR-V word 1: not a version from 1.0 to 1.6"};
    }
    RawModule module;
    module.bound = words[3];
    if (module.bound == 0 || module.bound > kMostIds) {
        return Error{"SPIR-V word 3: the bound of ids is not within 1.." +
                     std::to_string(kMostIds)};
    }
    if (words[4] != 0) {
        return Error{"SPIR-V word 4: the schema is not 0"};
    }
    const auto size = static_cast<std::uint32_t>(words.size());
    for (std::uint32_t at = kHeaderWords; at < size;) {
        RawInstruction raw;
        raw.op = static_cast<spv::Op>(words[at] & 0xffffu);
        raw.word = at;
        const std::uint32_t length = words[at] >> 16;
        if (length == 0 || length > size - at) {
            return At(at, raw.op,
                      "is " + std::to_string(length) + " words long, but " +
                          std::to_string(size - at) + " are left");
        }
        const auto layout = Layouts().find(static_cast<std::uint32_t>(raw.op));
        if (layout == Layouts().end()) {
            return At(at, raw.op, "is not known");
        }
        raw.rule = layout->second.rule;
        ETALON_TRY_STEP(Cutter(words, at + length, module, raw).Cut(layout->second.letters));
        module.instructions.push_back(raw);
        at += length;
    }
    return module;
}

}  // namespace etalon::spirv
