// Checks the results of a sweep's blocks on several cores.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "run/sweep_journal.h"
#include "run/sweep_plan.h"

namespace etalon {

// Successive floats at one setting.
struct SweepBlock {
    std::uint64_t setting = 0;
    std::uint64_t first_row = 0;   // of the whole sweep
    std::int64_t first_float = 0;  // OrderedBits
    std::uint32_t rows = 0;
};

// The swept input's words.
void FillFloats(std::int64_t first, std::span<std::uint32_t> words);

// Judges a block's results, `words` by columns over its rows, on so many threads. What is found
// does not depend on their number. One for each output of the plan, in its order.
std::vector<SweptColumn> CheckBlock(const SweepPlan& plan, const SweepBlock& block,
                                    std::span<const std::uint32_t> words, unsigned threads);

}  // namespace etalon
