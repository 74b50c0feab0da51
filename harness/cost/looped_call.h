// A call in a loop: what one evaluation costs, without the way of its inputs and results.
#pragma once

#include <cstddef>
#include <filesystem>

#include "base/result.h"
#include "run/prepared_case.h"

namespace etalon {

inline constexpr unsigned kMostCopies = 8;
inline constexpr unsigned kMostTurns = 1u << 16;

struct LoopedCall {
    Call call;  // its inputs are the case's and then `cost_loops`, an int: how many turns
    Signature signature;
    std::size_t done_column = 0;  // among the outputs: the turns that were made
};

// Writes, as `file`, a source that evaluates the case's call (its first wanted expression) `copies`
// times in each turn of a loop, always at the row's inputs, which the compiler cannot
// know to be the same each time, and yields the sum of all inputs and results. With `empty` the
// case's call is left out, and as many values are added up. Copies let short calls overlap as they
// do among others.
Result<LoopedCall> LoopCall(const PreparedCase& prepared, const std::filesystem::path& file,
                            unsigned copies, bool empty);

}  // namespace etalon
