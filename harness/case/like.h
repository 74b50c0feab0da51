// The keys of a case: its own, and those of the files that it is like.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "case/toml_reader.h"

namespace etalon {

// True for a file that is no case of its own and only serves others as `like`: "NAME.part.toml".
bool IsPart(const std::filesystem::path& file);

// True for "NAME.family.toml", several functions for one quantity (chart/family.h), and no case.
bool IsFamily(const std::filesystem::path& file);

// All keys that a case may have.
std::span<const std::string_view> CaseKeys();

struct Keys {
    toml::table table;
    std::string like;  // the address of the first case whose keys these are too; empty: of none
};

// Reads the file, and for `like = "FILE.toml"` (relative to this file) or `like = "ADDRESS"` (below
// root/cases) the keys of that file too, and so on. A key stands in place of the same key further
// on; `covers` and `expected_failure` are their own case's alone. Every node knows the file that it
// comes from. Fails where a file has a key that no case has, and where files are like each other.
Result<Keys> ReadKeys(const std::filesystem::path& root, const std::filesystem::path& file);

// The same for a table of keys that stands in `file`: adds those that its `like` names, if it has
// one, and takes `like` away.
Status<> AddLikeKeys(const std::filesystem::path& root, const std::filesystem::path& file,
                     toml::table& table);

}  // namespace etalon
