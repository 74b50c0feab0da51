// A call in a loop: what one evaluation costs, without the way of its inputs and results.
#pragma once

#include <cstddef>
#include <filesystem>

#include "base/result.h"
#include "run/prepared_case.h"

namespace etalon {

inline constexpr unsigned kMostSlots = 64;
inline constexpr unsigned kMostTurns = 1u << 16;

struct LoopedCall {
    Call call;  // its inputs are the case's and then `cost_loops`, an int: how many turns, 1 at
                // least
    Signature signature;
    std::size_t done_column = 0;  // among the outputs: the turns that were made
};

// Writes, as `file`, a source whose loop has so many slots in each turn. The first `calls` of them
// evaluate the case's call (its first wanted expression), the others nothing; always at the row's
// inputs, which the compiler cannot know to be the same each time. A slot's inputs wait for the
// results of the one before, as far as the processor knows: else short calls would overlap, and as
// much as they fit beside each other and the loop. Yields the sum of the last slot's results, or of
// as many inputs.
Result<LoopedCall> LoopCall(const PreparedCase& prepared, const std::filesystem::path& file,
                            unsigned slots, unsigned calls);

}  // namespace etalon
