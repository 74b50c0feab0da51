// Cuts a module's words into instructions and their operands, by the layouts of instructions.def.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "spirv/module.h"

namespace etalon::spirv {

// What check.cc asks of an instruction's types.
enum class Rule : std::uint8_t {
    kAny,
    kAccessChain,
    kAnyAll,
    kArrayLength,
    kBitcast,
    kBools,
    kCall,
    kCompareFloats,
    kCompareInts,
    kCondition,
    kConstruct,
    kCopyLogical,
    kCopyMemory,
    kDot,
    kExtended,
    kExtract,
    kExtractDynamic,
    kFetch,
    kFieldExtract,
    kFieldInsert,
    kFloatToFloat,
    kFloatToInt,
    kFloats,
    kImageOf,
    kInsert,
    kInsertDynamic,
    kIntPair,
    kIntToFloat,
    kIntToInt,
    kInts,
    kLoad,
    kMatrixTimesMatrix,
    kMatrixTimesScalar,
    kMatrixTimesVector,
    kOuterProduct,
    kPhi,
    kQuery,
    kReturn,
    kSame,
    kSample,
    kSelect,
    kSelector,
    kShuffle,
    kStore,
    kTranspose,
    kVectorTimesMatrix,
    kVectorTimesScalar,
};

// A letter of the layout and its word: 'v', 'y', 'b', 'f', 'e', 's', 'a' an id within the bound,
// '#' a literal, '$' the word at which a string begins, 'V' a value that may follow later.
struct RawOperand {
    char kind = 0;
    std::uint32_t value = 0;
};

struct RawInstruction {
    spv::Op op = spv::Op::OpNop;
    Rule rule = Rule::kAny;
    std::uint32_t word = 0;
    std::uint32_t type = 0;    // id, 0 for none
    std::uint32_t result = 0;  // id, 0 for none
    std::uint32_t first_operand = 0;
    std::uint32_t operands = 0;
};

struct RawModule {
    std::vector<RawInstruction> instructions;
    std::vector<RawOperand> operands;
    std::uint32_t bound = 0;  // all ids are below; none is 0
};

Result<RawModule> CutWords(std::span<const std::uint32_t> words);

// The string that begins at this word; CutWords has seen its end.
std::string StringAt(std::span<const std::uint32_t> words, std::uint32_t word);

// "SPIR-V word 12: OpFAdd: reason".
Error At(std::uint32_t word, spv::Op op, const std::string& reason);

}  // namespace etalon::spirv
