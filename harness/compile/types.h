// Types as glslang has them, as a probe's types.
#pragma once

#include <glslang/Include/intermediate.h>

#include "base/result.h"
#include "probe/type.h"

namespace etalon {

// Fails for what a probe cannot carry; the error goes on after the name of the thing: "is of type
// double, ...".
Result<Type> FromGlslang(const glslang::TType& type);

}  // namespace etalon
