// Plan: a compute probe's module made ready for evaluation over any number type.
//
// All values live in columns, one entry per lane: numbers in columns of numbers; integers, bools
// (0 or 1) and offsets in columns of words. A composite takes the columns of its parts one after
// the other, so that a part of it is a range of its columns. No function calls itself, so each
// value and each variable has its columns for good.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "image/image.h"
#include "image/sampling.h"
#include "spirv/module.h"

namespace etalon::evaluate {

using spirv::kNone;

// Counts of columns, or the first of a range.
struct Columns {
    std::uint32_t floats = 0;
    std::uint32_t words = 0;

    bool operator==(const Columns&) const = default;
};
inline Columns operator+(Columns a, Columns b) {
    return {a.floats + b.floats, a.words + b.words};
}
inline Columns operator*(Columns a, std::uint32_t n) {
    return {a.floats * n, a.words * n};
}

// Where a pointer points to.
struct Address {
    enum class Space : std::uint8_t { kColumns, kInputs, kOutputs, kImage };
    Space space = Space::kColumns;
    std::uint32_t slot = kNone;     // of the parameter to which `place` is relative
    Columns place;                  // of a buffer, `words` counts its words; of an image, images
    std::uint32_t offsets = kNone;  // two columns of words, added lane by lane: of number columns
                                    // and word columns
};

// A dynamic index of an access chain.
struct Index {
    std::uint32_t column = 0;  // of words
    std::uint32_t count = 0;   // must be above; kNone where the buffer's end decides
    Columns stride;
};

struct Move {
    Columns from;
    Columns to;
    Columns size;
};

// Codes of steps: the instruction's spv::Op, or kGlslCode and the number in GLSL.std.450.
inline constexpr std::uint32_t kGlslCode = 0x10000;

struct Step {
    std::uint32_t code = 0;
    std::uint32_t components = 1;  // of the operation: of the result, or of what is compared
    Columns result;
    Columns size;  // of the result
    std::uint32_t first_operand = 0;
    std::uint32_t operands = 0;
    std::uint32_t first_literal = 0;
    std::uint32_t literals = 0;
    std::uint32_t address = kNone;  // of a load, a store, an access chain's base, an image
    std::uint32_t extra = kNone;    // a call, an access chain's result, an exact output; see
                                    // translate.cc
    std::uint32_t line = kNone;     // into Module::lines
    std::uint32_t value = kNone;    // of the module: the result
    std::uint32_t word = 0;         // Instruction::word; 0 for what stands for no instruction
    bool is_output_only = false;    // a bit cast of which nothing but outputs are made
};

struct Call {
    struct Pointer {
        std::uint32_t slot = 0;
        std::uint32_t address = 0;
    };
    std::uint32_t function = 0;
    std::vector<Move> values;
    std::vector<Pointer> pointers;
    Move result;
};

struct Edge {
    std::uint32_t block = 0;  // of the function, in the order of the plan
    std::vector<Move> moves;  // of OpPhi, all at the same time
};

struct Block {
    enum class End : std::uint8_t { kBranch, kCondition, kSwitch, kReturn, kKill, kUnreachable };
    std::uint32_t first_step = 0;
    std::uint32_t steps = 0;
    End end = End::kUnreachable;
    std::uint32_t column = 0;          // of the condition or selector
    std::vector<Edge> edges;           // condition: true, false; switch: default, then by case
    std::vector<std::uint32_t> cases;  // of edges[1...]
    Move returned;
    bool is_counted = false;  // a lane that enters it has come one step nearer to the end of its
                              // budget: every loop and every function has such a block
    std::uint32_t merge = kNone;  // where the ways out of it meet, in the order of the plan
    bool is_loop = false;
    std::uint32_t line = kNone;  // into Module::lines: of its end
};

// Blocks stand so that those where ways meet come late: the lanes of the first block that has any
// are run, and so wait for each other there.
struct Function {
    std::vector<Block> blocks;
    Columns result;
    Columns result_size;
};

struct Constant {
    Columns place;
    std::vector<std::uint32_t> floats;  // bits, by column
    std::vector<std::uint32_t> words;
};

struct Plan {
    spirv::Module module;
    std::vector<Function> functions;  // as in the module
    std::uint32_t entry = 0;
    std::vector<Step> steps;
    std::vector<Step> globals;  // before the entry, for each group of lanes
    std::vector<Columns> operands;
    std::vector<std::uint32_t> literals;
    std::vector<Address> addresses;
    std::vector<std::vector<Index>> chains;
    std::vector<Call> calls;
    std::vector<Constant> constants;
    std::vector<std::uint32_t> row_columns;  // those that hold the row's number
    Columns columns;                         // how many there are
    std::uint32_t slots = 0;
    std::uint32_t images = 0;  // that the module may name

    std::span<const Columns> Operands(const Step& step) const {
        return std::span(operands).subspan(step.first_operand, step.operands);
    }
    std::span<const std::uint32_t> Literals(const Step& step) const {
        return std::span(literals).subspan(step.first_literal, step.literals);
    }
};

// "find" of "find(f1;vf2;", as glslang calls functions.
inline std::string PlainName(const std::string& function) {
    return function.substr(0, function.find('('));
}

// Fails, naming what it is, on what cannot be evaluated: another stage than compute, an instruction
// without a row in operations.def, numbers of other than 32 bits, pointers that are data,
// recursion, too many values.
Result<std::shared_ptr<const Plan>> MakePlan(spirv::Module module);

}  // namespace etalon::evaluate
