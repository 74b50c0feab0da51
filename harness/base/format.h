// Text formatting: fmt's, until the compilers in use have std::format.
#pragma once

#include <fmt/format.h>

namespace etalon {
using fmt::format;
}  // namespace etalon
