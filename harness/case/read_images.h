// Reads [images], and the table of one image by itself.
#pragma once

#include <string>
#include <vector>

#include "case/image_source.h"
#include "case/toml_reader.h"

namespace etalon {

Result<std::vector<ImageSource>> ReadImages(const TomlReader& reader, const toml::table& table);

// The same of a text: "NAME = { file = ... }". Errors begin with `origin` in a file's place.
Result<std::vector<ImageSource>> ReadImages(const std::string& text, const std::string& origin);

}  // namespace etalon
