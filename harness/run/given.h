// The inputs that a user gives by --at.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/domain.h"

namespace etalon {

// The word of each column for which `at` gives one: "n1=0x1p+0, v.x=0.5". Empty text gives none.
// `origin` is what errors begin with.
Result<std::vector<std::optional<std::uint32_t>>> ReadGiven(const std::vector<Column>& columns,
                                                            const std::string& at,
                                                            const std::string& origin = "--at");

}  // namespace etalon
