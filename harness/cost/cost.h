// What one evaluation of a case's call costs: the time that a device takes for it, and the
// operations that it executes, which depend on no machine.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/case.h"
#include "probe/recipe.h"
#include "run/prepared_case.h"
#include "run/runner.h"

namespace etalon {

// The call of a case at its rows, with no need of an oracle, a tolerance or a law.
Result<PreparedCase> PrepareCall(const Case& source);
Result<PreparedCase> PrepareCall(const Case& source, Table table);

// Seconds of one evaluation: at as many rows at once as keep the device busy, and at each row one
// after the other. `low` to `high` is what the parts of the measurement say, each taken alone: it
// tells how far to believe `seconds`, and no more. 0 where noise hides the call.
struct TimeEstimate {
    double seconds = 0;
    double low = 0;
    double high = 0;
    std::uint64_t rounds = 0;  // runs of the call, each of many evaluations
    // "processor time": what one core of the host takes; of a device that computes there, however
    // busy the machine is else. "device timestamps" (or OpenGL's timer queries), else "host clock":
    // what the whole device takes.
    std::string clock;
};

struct CostOptions {
    double seconds = 1.0;     // about so long for each subject, more where the spread stays wide
    double most_seconds = 4;  // at most about so long
    double spread = 0.04;     // (high - low) / seconds that is aimed at
    std::uint64_t seed = 1;   // of the order of the runs in each round
};

// Told from time to time: the share that is done, 0 to 1.
using CostProgress = std::function<void(double share)>;

// How long the call of each subject (its first wanted expression, at all its rows) takes, all of
// them in turns with each other and with loops of fewer calls, in an order that changes. One for
// each subject, in their order; an error where it has no time: the device cannot run it, or failed.
// The times of one call of this function may be compared with each other, those of two not quite.
Result<std::vector<Result<TimeEstimate>>> EstimateTimes(std::span<const PreparedCase> subjects,
                                                        Runner& runner, const Recipe& recipe,
                                                        const CostOptions& options = {},
                                                        const CostProgress& progress = {});

// Operations executed. Each component counts: a product of two vec3 is 3.
//   arithmetic  sums, products, negations, abs, floor, fract...; what stands for a formula counts
//               as that: fma 2, dot(vec3) 5, mix 4 for each component
//   division    quotients and remainders of floats
//   special     sqrt, inversesqrt, exp, log, pow, sin...; length is a dot and one of these, and so
//               is normalize, with a product for each component
//   comparison  comparisons, min, max, step, selections, logic of bools; clamp and sign are 2
//   integer     whatever works on integers but compares none
//   fetch       reads of images, whatever the filter
//   other       conversions, packing, questions about images
// What only moves values (loads, stores, swizzles, bit casts) and branches count nothing.
struct OperationCounts {
    double arithmetic = 0;
    double division = 0;
    double special = 0;
    double comparison = 0;
    double integer = 0;
    double fetch = 0;
    double other = 0;

    double Total() const {
        return arithmetic + division + special + comparison + integer + fetch + other;
    }
    bool operator==(const OperationCounts&) const = default;
};

struct CountedCall {
    OperationCounts mean;         // over the rows
    OperationCounts worst;        // of the row with most in total
    std::uint64_t worst_row = 0;  // the first of these
};

// The operations of one evaluation, by the evaluator on the host in binary32, of the program as
// SPIRV-Tools optimises it for speed: what nothing depends on is not counted, nor twice what is
// computed already. But a sum of a product has become an fma: a product that is needed for itself,
// too, counts in both, and `a * b - c` has a negation. Fails, with the reason, where the program
// cannot be evaluated there (derivatives).
Result<CountedCall> CountOperations(const PreparedCase& subject);

}  // namespace etalon
