// Holds what a case expects to fail against what failed.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/case.h"
#include "report/record.h"
#include "run/prepared_case.h"

namespace etalon {

// What the judges said of one output column or law.
struct JudgedThing {
    std::string what;  // "result.x", "law 'energy'"
    std::uint64_t judged = 0;
    std::uint64_t refused = 0;
    std::optional<Observation> worst;  // absent where nothing was judged
};

// Applies the case's expected failures that are about the record's device and recipe. A failure is
// known where each thing that failed is expected to, with the figure that is expected; a crash or a
// hang only where the verdict itself is. A pass where a failure is expected is a failure, for then
// the case tells something that is no longer true. Where not all rows were judged, figures are not
// held, and a case at some of its rows may pass: what fails may not be among them.
void ApplyExpectations(const Case& source, Extent extent, const std::vector<JudgedThing>& things,
                       Record& record);

}  // namespace etalon
