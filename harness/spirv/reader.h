// What the parts of the reader share: read.cc leads, read_global.cc reads what stands outside
// functions, read_function.cc the functions.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "spirv/grammar.h"

namespace etalon::spirv {

class Reader {
  public:
    Reader(std::span<const std::uint32_t> words, const RawModule& raw)
        : words_(words), raw_(raw), ids_(raw.bound) {}

    Result<Module> Read();

  private:
    struct Id {
        enum class Kind : std::uint8_t {
            kNothing,
            kType,
            kValue,
            kLabel,
            kFunction,
            kImport,
            kString,
        };
        Kind kind = Kind::kNothing;
        std::uint32_t index = 0;     // in its vector of the module; of a string, its word
        std::uint32_t function = 0;  // of a label
    };
    struct Decoration {
        std::uint32_t member = kNone;
        std::uint32_t kind = 0;
        std::uint32_t value = kNone;  // the first literal
    };
    struct PhiSource {
        std::uint32_t operand;
        std::uint32_t id;
        const RawInstruction* raw;
    };

    // read.cc
    Status<> Announce();
    Status<> ReadDebug(const RawInstruction& raw);
    Status<> ReadEntry();
    std::span<const RawOperand> Operands(const RawInstruction& raw) const {
        return std::span(raw_.operands).subspan(raw.first_operand, raw.operands);
    }
    std::uint32_t Word(const RawInstruction& raw, std::size_t operand) const {
        return Operands(raw)[operand].value;
    }
    Result<std::uint32_t> TypeAt(const RawInstruction& raw, std::uint32_t id) const;
    Result<std::uint32_t> ValueAt(const RawInstruction& raw, std::uint32_t id) const;
    std::uint32_t AddValue(const RawInstruction& raw, std::uint32_t type, Value::Kind kind,
                           std::uint32_t index);
    Result<std::uint32_t> ResultType(const RawInstruction& raw) const;
    static Error Wrong(const RawInstruction& raw, const std::string& reason) {
        return At(raw.word, raw.op, reason);
    }

    // read_global.cc
    Status<> ReadGlobal(const RawInstruction& raw);
    Status<> ReadType(const RawInstruction& raw);
    Status<> ReadStruct(const RawInstruction& raw, Type& type);
    Status<> ReadArray(const RawInstruction& raw, Type& type);
    Status<> ReadImage(const RawInstruction& raw, Type& type);
    Status<> ReadConstant(const RawInstruction& raw);
    Status<> ReadNumber(const RawInstruction& raw, const Type& type, Constant& constant);
    Status<> ReadComposite(const RawInstruction& raw, const Type& type, Constant& constant);
    Status<> ReadVariable(const RawInstruction& raw);
    Status<> AddNull(const RawInstruction& raw);

    // read_function.cc
    Status<> ReadFunctions();
    Status<> BeginFunction(const RawInstruction& raw);
    Status<> ReadParameter(const RawInstruction& raw);
    Status<> EndFunction(const RawInstruction& raw);
    Status<> ReadInBlock(const RawInstruction& raw);
    Status<> ReadMerge(const RawInstruction& raw);
    Status<> ResolveOperands(const RawInstruction& raw, Instruction& instruction);
    Status<> CheckPhis(const Function& function) const;
    Status<> CheckCall(const Instruction& instruction) const;

    std::span<const std::uint32_t> words_;
    const RawModule& raw_;
    Module module_;
    std::vector<Id> ids_;
    std::unordered_map<std::uint32_t, std::string> names_;
    std::unordered_map<std::uint32_t, std::vector<std::pair<std::uint32_t, std::string>>>
        member_names_;
    std::unordered_map<std::uint32_t, std::vector<Decoration>> decorations_;
    std::vector<std::uint32_t> depths_;  // nesting, by type
    std::size_t first_function_ = 0;     // raw instruction

    // Of the function that is being read.
    std::uint32_t function_ = kNone;
    std::uint32_t block_ = kNone;
    std::uint32_t line_ = kNone;
    bool merged_ = false;  // the block has had its merge instruction
    std::vector<PhiSource> phi_sources_;
};

}  // namespace etalon::spirv
