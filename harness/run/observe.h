// Observations: single values as records tell them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "judge/budget.h"
#include "report/record.h"
#include "run/prepared_case.h"

namespace etalon {

Value ValueOf(Scalar scalar, std::uint32_t word);
std::vector<std::pair<std::string, Value>> InputsAt(const Table& table, std::uint64_t row);
AllowedValue AllowedValueOf(const Allowed& allowed, Scalar scalar, std::uint32_t word);

std::string LawLabel(const Law& law);  // "law 'energy'"

// A value as it was judged, without its inputs: by the column's rule; by what a specification
// allows; by the law between its sides.
Observation ObserveOutput(const JudgedColumn& column, std::uint32_t word, std::uint64_t row);
Observation ObserveAllowed(const JudgedColumn& column, const Allowed& allowed,
                           std::string_view profile, std::uint32_t word, std::uint64_t row);
Observation ObserveLaw(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                       std::uint32_t right);

}  // namespace etalon
