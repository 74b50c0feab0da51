// Reads what the sources describe from root/shaders/catalogue.toml.
#pragma once

#include <filesystem>
#include <vector>

#include "base/result.h"
#include "case/case.h"
#include "report/catalogue.h"

namespace etalon {

// One table an id, in the file's order: name, source, and for what only reading shows
// `seen = "by reading"` with its reason.
Result<std::vector<CatalogueEntry>> ReadCatalogue(const std::filesystem::path& root);

// Fails where a case covers an id that is not in the catalogue.
Status<> CheckCovers(const Case& source, const std::vector<CatalogueEntry>& entries);

}  // namespace etalon
