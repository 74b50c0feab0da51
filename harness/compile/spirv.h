// What is done to SPIR-V after glslang: validation, optimisation, NoContraction everywhere.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "compile/compile.h"

namespace etalon {

// Fails with the validator's first message.
Status<> ValidateSpirv(const std::vector<std::uint32_t>& module, Target target);

// SPIRV-Tools' passes for speed (-O) or size (-Os). Fails with the optimiser's message.
Result<std::vector<std::uint32_t>> OptimiseSpirv(const std::vector<std::uint32_t>& module,
                                                 Recipe::Optimise goal, Target target);

// Decorates every floating-point operation as NoContraction: the whole program becomes `precise`.
std::vector<std::uint32_t> ForbidContraction(const std::vector<std::uint32_t>& module);

}  // namespace etalon
