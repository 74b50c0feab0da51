// The name that somebody who wrote another one may have meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace etalon {

// "; did you mean 'source'?", or nothing where no name is near.
std::string Suggestion(std::string_view written, std::span<const std::string_view> names);

}  // namespace etalon
