// Reads what a case judges by: acceptances, laws and expected failures.
#pragma once

#include "case/case.h"
#include "case/toml_reader.h"

namespace etalon {

Result<Acceptance> ReadAcceptance(const TomlReader& reader, const toml::table& table);

// The name of the specification whose bounds are accepted: { spec = "vulkan-1.3" }, alone.
Result<std::string> ReadSpec(const TomlReader& reader, const toml::table& table);

Result<Law> ReadLaw(const TomlReader& reader, const toml::table& table);

// The law's two sides, parted at the one comparison that stands outside all brackets.
struct Comparison {
    std::string left;
    Relation relation = Relation::kEqual;
    std::string right;
};
Result<Comparison> SplitComparison(const std::string& holds);

Result<ExpectedFailure> ReadExpectedFailure(const TomlReader& reader, const toml::table& table,
                                            const std::vector<Law>& laws);

}  // namespace etalon
