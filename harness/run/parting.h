// Parting: the first operation at which a device must have left the strict reading, found by making
// the device tell what its operations yield.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "evaluate/trace.h"
#include "probe/program.h"
#include "run/runner.h"

namespace etalon {

struct Parting {
    enum class Kind : std::uint8_t {
        kNowhere,    // every operation yields what the strict reading does
        kOperation,  // `word` at `leaf` of the step; all before, and so its operands, are alike
        kWay,        // the device does not do the step, but something else: it has branched
        kUnseen,     // all cannot be watched at once, or then the result is another one; watched in
                     // parts, and the result kept, nothing differs
        kFailed,     // it could not be watched; `reason` tells why
    };
    Kind kind = Kind::kNowhere;
    std::size_t step = 0;    // of the trace
    std::uint32_t leaf = 0;  // of the step's result, as spirv::Leaves
    std::uint32_t word = 0;
    bool is_in_parts = false;  // the instructions were watched some at a time: what the others
                               // yielded in the same program is not known
    std::size_t tried = 0;     // instructions that were watched alone, of those on the path
    std::size_t instructions = 0;
    std::string reason;
};

// Runs a program at the one row and returns its outputs.
using Execute =
    std::function<Result<std::vector<std::uint32_t>, EvaluationFailure>(const Program& program)>;

// `program` is in SPIR-V, `traced` the module that `trace` is of: the same source, perhaps for
// another target. `plain` are the outputs that the device returns unwatched. `execute` gets
// programs that are not optimised yet.
Parting FindParting(const Program& program, const spirv::Module& traced,
                    const evaluate::Trace& trace, std::span<const std::uint32_t> plain,
                    const Execute& execute);

// True for the same number: NaNs are alike, zeros too, whatever their sign.
bool IsSameFloat(std::uint32_t a, std::uint32_t b);

}  // namespace etalon
