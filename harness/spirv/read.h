// Reads a SPIR-V module.
#pragma once

#include <cstdint>
#include <span>

#include "base/result.h"
#include "spirv/module.h"

namespace etalon::spirv {

// What no module goes beyond.
inline constexpr std::size_t kMostWords = 1u << 24;
inline constexpr std::uint32_t kMostIds = 1u << 22;
inline constexpr std::uint32_t kMostElements = 1u << 20;  // of an array

// Any sequence of words yields a module that keeps what module.h promises, or an error that names
// the word and the reason ("SPIR-V word 120: OpFAdd: ..."). It is stricter than the format where
// the evaluator needs it (one entry point, logical addressing, names in the order of their use) and
// laxer where it does not: dominance and the structure of control flow are not checked.
Result<Module> ReadModule(std::span<const std::uint32_t> words);

}  // namespace etalon::spirv
