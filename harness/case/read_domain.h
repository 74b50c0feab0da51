// Reads a [domain].
#pragma once

#include <span>

#include "case/domain.h"
#include "case/toml_reader.h"

namespace etalon {

// What a case says for all its domains.
struct DomainDefaults {
    bool zip = false;
    const toml::node* where = nullptr;  // its text; applies beside the domain's own
};

// True for what GLSL takes as a name.
bool IsIdentifier(const std::string& name);

Result<bool> ReadCombine(const TomlReader& reader, const toml::node& node);

// Reads and checks everything that can be checked without drawing samples.
Result<Domain> ReadDomain(const TomlReader& reader, const toml::table& table,
                          const DomainDefaults& defaults);

// The inputs as an expression sees them.
std::vector<Symbol> SymbolsOf(const Domain& domain);

// Binds a copy of the expression, to check its names and shape.
Status<> CheckExpression(const TomlReader& reader, const toml::node& node,
                         const Expression& expression, std::span<const Symbol> symbols,
                         unsigned components);

}  // namespace etalon
