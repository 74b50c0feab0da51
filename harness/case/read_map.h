// Reads a [map].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "case/case_map.h"
#include "case/domain.h"
#include "case/toml_reader.h"

namespace etalon {

// The range of an input of that name that the domains give first; absent where none has one. The
// spacing "bits" counts as linear.
std::optional<MapRange> OwnMapRange(const std::vector<Domain>& domains, const std::string& name);

// The reason why an input cannot be an axis over these domains; empty where it can.
std::string WhyNoAxis(const std::vector<Domain>& domains, const std::string& name);

// True for the types of which an axis has whole numbers alone.
bool IsWhole(const std::string& type);

// Why the range is none; empty where it is one.
std::string WhyNoRange(const MapRange& range);

// Checks everything that needs neither a device nor a shader.
Result<CaseMap> ReadMap(const TomlReader& reader, const toml::table& table,
                        const std::vector<Domain>& domains);

}  // namespace etalon
