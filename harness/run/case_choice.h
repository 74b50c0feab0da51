// Which cases a command is about.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"

namespace etalon {

// The folder at or above `from` that holds a folder "cases".
Result<std::filesystem::path> FindRoot(const std::filesystem::path& from);

// The addresses of the cases that the patterns name, in order; all for no pattern. Fails where one
// names none.
Result<std::vector<std::string>> ChooseCases(const std::filesystem::path& root,
                                             const std::vector<std::string>& patterns);

}  // namespace etalon
