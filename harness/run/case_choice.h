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

// The address of the one case that the pattern is, or names alone. `done` says what is done to one
// case only: "explained".
Result<std::string> ChooseOneCase(const std::filesystem::path& root, const std::string& pattern,
                                  const std::string& done);

}  // namespace etalon
