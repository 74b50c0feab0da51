// What is to be swept: one float input of a case over a range, at settings of the other inputs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/case.h"
#include "run/prepared_case.h"

namespace etalon {

struct SweepScope {
    std::string over = {};   // the input; empty: the only float that has a range
    std::string from = {};   // in place of the range's own ends
    std::string to = {};     // likewise
    std::string at = {};     // other inputs: "n1=1,n2=1.5"
    std::uint64_t grid = 3;  // how many values another input takes that has a range, or is drawn
};

struct SweepPlan {
    // One expectation of the case: an oracle, and the outputs that it is the truth of.
    struct Oracle {
        Expression expression = Expression::Constant(0);  // bound to the table's variables
        std::vector<JudgedColumn> outputs;                // one for each component
    };

    Call call;
    Signature signature;
    std::vector<Oracle> oracles;
    Table settings;         // a row for each; the swept column holds the first float
    std::size_t swept = 0;  // among its columns
    std::uint32_t from = 0;
    std::uint32_t to = 0;
    std::string fixed;  // the other inputs as they are told: "n1=1, n2=1.5"
};

// The other inputs take the values that `at` gives, else those of the case; where the case gives a
// range, `grid` values from end to end in the range's own spacing (side by side with others: as
// many rows at random). Of several domains it is the first in which the swept input has a range.
//
// Fails, beside what is wrong with the scope, for a case that judges by shares or by a
// specification, or not at all by an oracle, and where another input or the domain's condition
// depends on the swept one.
Result<SweepPlan> PlanSweep(const Case& source, const SweepScope& scope);

}  // namespace etalon
