// Runs one prepared case on one device by one recipe.
#pragma once

#include <optional>
#include <string>

#include "report/record.h"
#include "run/evaluation.h"
#include "run/prepared_case.h"
#include "run/runner.h"

namespace etalon {

// How the command that repeats a case is written: what the user chose beside the case itself.
struct RepeatContext {
    std::string program = "etalon";
    std::string options;  // "--root DIR --driver NAME=DIR", with a leading space, or empty
};

// What it makes of a case that it happens to.
Verdict VerdictOf(const EvaluationFailure& failure);

// Never fails: whatever happens is a verdict. Expected failures of the case are taken into account.
// The case must stay where it is as long as the evaluations are used.
Record RunCase(const PreparedCase& prepared, Runner& runner, const Recipe& recipe,
               Evaluations& evaluations, const RepeatContext& context);

}  // namespace etalon
