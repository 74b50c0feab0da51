// A call in a loop: what one evaluation costs, without the way of its inputs and results.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "run/prepared_case.h"

namespace etalon {

// The input that says how often.
inline constexpr const char* kLoops = "cost_loops";

// Writes, as `file`, a source that evaluates the case's call `copies` times in each of `cost_loops`
// turns, at inputs that differ from the row's in their last bit at most, and yields the sum of all
// inputs and results; and makes a call of it, whose inputs are the case's and then kLoops. With
// `empty` the case's call is left out. Copies, 16 at most, let short calls overlap as they do among
// others.
Result<Call> LoopedCall(const PreparedCase& prepared, const std::filesystem::path& file,
                        unsigned copies, bool empty);

}  // namespace etalon
