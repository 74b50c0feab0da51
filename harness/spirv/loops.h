// Whether a module has loops.
#pragma once

#include <cstdint>
#include <span>

namespace etalon::spirv {

// Of a module that a compiler has made.
bool HasLoop(std::span<const std::uint32_t> words);

}  // namespace etalon::spirv
