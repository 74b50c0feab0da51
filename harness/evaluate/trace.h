// Trace: one row of a probe, operation by operation, in binary32 and beside it without rounding.
//
// The way is that of binary32: where it branches, indexes and converts to integers, the numbers
// without rounding (Big) are led the same way, so that each operation has an exact value to
// compare with. A number that is moved by its bits stays what it is.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "evaluate/big.h"
#include "evaluate/evaluate.h"
#include "evaluate/plan.h"

namespace etalon::evaluate {

// Which number: a result of a traced step. `step` is kNone for an input, a constant, or what came
// by way of integers.
struct Origin {
    std::uint32_t step = kNone;
    std::uint32_t number = 0;

    bool operator==(const Origin&) const = default;
};

struct TracedOperand {
    float value = 0;
    Big exact;
    Origin origin;
};

struct TracedNumber {
    float value = 0;
    Big exact;
    // How much larger the relative error of the result can be than those of the operands, to first
    // order: the sum over the operands' numbers x of |x df/dx| / |f|, where both are exact.
    double amplification = 0;
    std::vector<Origin> from;  // what it changes with, and is a traced number
};

// Of what is no number: an int, or a bool (0 or 1).
struct TracedWord {
    std::uint32_t value = 0;
    std::uint32_t exact = 0;  // what the exact operands yield; the way does not follow it
};

// Pointers are into the plan's module, which must outlive them.
// One execution of an instruction that computes with numbers (spirv::IsWatchable).
struct TracedStep {
    const spirv::Instruction* instruction = nullptr;   // of the plan's module
    std::vector<TracedNumber> numbers;                 // floats of the result, as spirv::Leaves
    std::vector<TracedWord> words;                     // its ints and bools
    std::vector<std::vector<TracedOperand>> operands;  // by operand: its floats
    std::vector<std::vector<std::uint32_t>> operand_words;  // by operand: its ints and bools
    const spirv::Instruction* stored = nullptr;  // the OpStore that first kept it in a variable
};

struct Trace {
    std::vector<TracedStep> steps;  // in the order of their execution
    std::vector<std::uint32_t> outputs;
    std::vector<Big> exact;       // of the outputs; of what is no float, its bits taken as one
    std::vector<Origin> origins;  // of the outputs
    bool is_killed = false;       // by `discard`: the outputs were not written
    bool is_cut = false;          // the path has more than kMostTraced steps; the rest is missing
};

inline constexpr std::size_t kMostTraced = 1u << 17;

// The trace of a program for one row. Fails as the evaluator does.
Result<Trace> TraceRow(std::shared_ptr<const Plan> plan, const std::vector<Texture>& images,
                       std::span<const std::uint32_t> inputs, std::uint32_t output_words,
                       Limits limits = {});

// The values that the instruction computes with, in the order of TracedStep::operands.
std::vector<std::uint32_t> OperandValues(const spirv::Module& module,
                                         const spirv::Instruction& instruction);

}  // namespace etalon::evaluate
