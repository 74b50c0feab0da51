// Where the result of an operation on integers is undefined, nothing bounds what depends on it.
#pragma once

#include "evaluate/interval_context.h"

namespace etalon::evaluate::operation {

// After a step: loses the lanes whose operands leave its result undefined.
void LoseUndefined(Machine<Interval>& m, const Step& step);

}  // namespace etalon::evaluate::operation
