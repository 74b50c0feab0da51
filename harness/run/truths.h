// The truths of a table's rows.
#pragma once

#include <cstdint>
#include <vector>

#include "case/domain.h"
#include "case/expression.h"
#include "judge/judge.h"

namespace etalon {

// What the oracle's components are at all rows. It is bound to the table's variables.
std::vector<Truth> TruthsOf(const Expression& oracle, const Table& table);

bool IsSubnormal(std::uint32_t word);

// Some rows of a table.
Table RowsOf(const Table& table, const std::vector<std::uint64_t>& rows);

}  // namespace etalon
