// Files and text: whole-file reading with a user's reason on failure, glob patterns.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "base/result.h"

namespace etalon {

// The whole content. Fails, naming the path, where it is missing, a folder, or unreadable.
Result<std::string> ReadFile(const std::filesystem::path& path);

// As ReadFile, and refuses content with a NUL byte ("is not text").
Result<std::string> ReadTextFile(const std::filesystem::path& path);

// Writes beside the target and renames, so that a full disk or a kill leaves the old content whole.
// A target that is no regular file (a device, a pipe) is written in place.
Status<> WriteFile(const std::filesystem::path& path, std::string_view content);

// True if `text` matches `pattern`, where * stands for any run of characters and ? for any one.
bool GlobMatches(std::string_view pattern, std::string_view text);

// The text as one word of a shell's command: as it is where nothing in it has a meaning to a shell,
// else in single quotes.
std::string ShellWord(const std::string& text);

// The running program's own file.
std::filesystem::path ProgramPath();

}  // namespace etalon
