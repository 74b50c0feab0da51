// Reads values out of TOML and says where what is wrong stands. The one place, with the sources
// that include it, where the TOML library is named.
#pragma once

#define TOML_EXCEPTIONS 0
#define TOML_ENABLE_FORMATTERS 0
#include <toml++/toml.h>

#include <initializer_list>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/result.h"
#include "case/expression.h"
#include "case/place.h"

namespace etalon {

class TomlReader {
  public:
    // `file` is the name that errors begin with.
    explicit TomlReader(std::string file) : file_(std::move(file)) {}

    const std::string& file() const { return file_; }

    // "file:line:column: reason" for what is not TOML.
    Result<toml::table> Parse(std::string_view text) const;

    // "file:line: reason"; the file is the node's own, whichever reader asks.
    Error Fail(const toml::node& at, const std::string& reason) const;
    Error Fail(int line, const std::string& reason) const;

    // An error of an expression whose text is `at`: its column becomes the file's, where the text
    // stands on one line and without escapes.
    Error FailInside(const toml::node& at, const Error& error) const;

    // Fails at the first key that is not among `keys`, and names the nearest of them.
    Status<> OnlyKeys(const toml::table& table, std::span<const std::string_view> keys) const;
    Status<> OnlyKeys(const toml::table& table,
                      std::initializer_list<std::string_view> keys) const {
        return OnlyKeys(table, {keys.begin(), keys.size()});
    }

    // The keys and values in the order of the file.
    static std::vector<std::pair<std::string, const toml::node*>> InOrder(const toml::table& table);
    static int Line(const toml::node& node);
    Place PlaceOf(const toml::node& node) const;

    // Each of these fails where the value has another type. `what` names the value: "'source'".
    Result<std::string> Text(const toml::node& node, const std::string& what) const;
    Result<double> Number(const toml::node& node, const std::string& what) const;
    Result<std::uint64_t> Count(const toml::node& node, const std::string& what) const;
    Result<bool> Flag(const toml::node& node, const std::string& what) const;
    Result<const toml::table*> Table(const toml::node& node, const std::string& what) const;
    Result<const toml::array*> List(const toml::node& node, const std::string& what) const;
    Result<std::vector<std::string>> Texts(const toml::node& node, const std::string& what) const;
    Result<std::map<std::string, std::string>> TextMap(const toml::node& node,
                                                       const std::string& what) const;
    Result<Expression> Formula(const toml::node& node, const std::string& what) const;

    // The text under the key, or `otherwise`; a key without `otherwise` must be there.
    Result<std::string> TextAt(const toml::table& table, std::string_view key,
                               std::optional<std::string> otherwise) const;

  private:
    std::string file_;
};

}  // namespace etalon
