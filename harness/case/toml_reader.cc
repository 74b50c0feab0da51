#include "case/toml_reader.h"

#include <algorithm>
#include <cmath>

#include "case/suggestion.h"
#include "numeric/number_text.h"
#include "numeric/ulp.h"

namespace etalon {

Result<toml::table> TomlReader::Parse(std::string_view text) const {
    toml::parse_result parsed = toml::parse(text, file_);
    if (parsed) {
        return std::move(parsed).table();
    }
    const toml::parse_error& error = parsed.error();
    std::string reason(error.description());
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    const toml::source_position& at = error.source().begin;
    return Error{file_ + ":" + std::to_string(at.line) + ":" + std::to_string(at.column) + ": " +
                 reason};
}

int TomlReader::Line(const toml::node& node) {
    return static_cast<int>(std::max<toml::source_index>(node.source().begin.line, 1));
}

Place TomlReader::PlaceOf(const toml::node& node) const {
    return {node.source().path ? *node.source().path : file_, Line(node)};
}

Error TomlReader::Fail(const toml::node& at, const std::string& reason) const {
    return Error{PlaceOf(at).Text() + reason};
}

Error TomlReader::Fail(int line, const std::string& reason) const {
    return Error{file_ + ":" + std::to_string(line) + ": " + reason};
}

Error TomlReader::FailInside(const toml::node& at, const Error& error) const {
    constexpr std::string_view kPrefix = "column ";
    const std::string* const text = at.as_string() != nullptr ? &at.as_string()->get() : nullptr;
    const toml::source_region& region = at.source();
    const bool plain = text != nullptr && region.begin.line == region.end.line &&
                       region.end.column - region.begin.column == text->size() + 2;
    if (!plain || !error.message.starts_with(kPrefix)) {
        return Fail(at, (text != nullptr ? "'" + *text + "': " : "") + error.message);
    }
    std::size_t digits = 0;
    const unsigned long column = std::stoul(error.message.substr(kPrefix.size()), &digits);
    const Place place = PlaceOf(at);
    return Error{place.file + ":" + std::to_string(place.line) + ":" +
                 std::to_string(region.begin.column + column) +
                 error.message.substr(kPrefix.size() + digits)};
}

Status<> TomlReader::OnlyKeys(const toml::table& table,
                              std::span<const std::string_view> keys) const {
    for (const auto& [key, node] : InOrder(table)) {
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
            return Fail(*node, "unknown key '" + key + "'" + Suggestion(key, keys));
        }
    }
    return Ok();
}

std::vector<std::pair<std::string, const toml::node*>> TomlReader::InOrder(
    const toml::table& table) {
    std::vector<std::pair<const toml::key*, const toml::node*>> entries;
    for (const auto& [key, node] : table) {
        entries.emplace_back(&key, &node);
    }
    std::stable_sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
        const auto& first = a.first->source().begin;
        const auto& second = b.first->source().begin;
        return std::pair(first.line, first.column) < std::pair(second.line, second.column);
    });
    std::vector<std::pair<std::string, const toml::node*>> ordered;
    for (const auto& [key, node] : entries) {
        ordered.emplace_back(std::string(key->str()), node);
    }
    return ordered;
}

Result<std::string> TomlReader::Text(const toml::node& node, const std::string& what) const {
    if (const auto* text = node.as_string()) {
        return text->get();
    }
    return Fail(node, what + " must be a text in quotes");
}

Result<double> TomlReader::Number(const toml::node& node, const std::string& what) const {
    if (const auto* integer = node.as_integer()) {
        return static_cast<double>(integer->get());
    }
    if (const auto* real = node.as_floating_point()) {
        return real->get();
    }
    if (const auto* flag = node.as_boolean()) {
        return flag->get() ? 1.0 : 0.0;
    }
    if (const auto* text = node.as_string()) {
        const auto word = ParseWord(Scalar::kFloat, text->get());
        if (word) {
            return static_cast<double>(FromBits(*word));
        }
        return Fail(node, what + ": " + word.error().message);
    }
    return Fail(node, what + " must be a number");
}

Result<std::uint64_t> TomlReader::Count(const toml::node& node, const std::string& what) const {
    const auto* integer = node.as_integer();
    if (integer == nullptr || integer->get() < 0) {
        return Fail(node, what + " must be an integer, 0 or more");
    }
    return static_cast<std::uint64_t>(integer->get());
}

Result<bool> TomlReader::Flag(const toml::node& node, const std::string& what) const {
    if (const auto* flag = node.as_boolean()) {
        return flag->get();
    }
    return Fail(node, what + " must be true or false");
}

Result<const toml::table*> TomlReader::Table(const toml::node& node,
                                             const std::string& what) const {
    if (const auto* table = node.as_table()) {
        return table;
    }
    return Fail(node, what + " must be a table");
}

Result<const toml::array*> TomlReader::List(const toml::node& node, const std::string& what) const {
    if (const auto* list = node.as_array()) {
        return list;
    }
    return Fail(node, what + " must be a list");
}

Result<std::vector<std::string>> TomlReader::Texts(const toml::node& node,
                                                   const std::string& what) const {
    ETALON_TRY(list, List(node, what));
    std::vector<std::string> texts;
    for (const toml::node& entry : *list) {
        ETALON_TRY(text, Text(entry, "an entry of " + what));
        texts.push_back(text);
    }
    return texts;
}

Result<std::map<std::string, std::string>> TomlReader::TextMap(const toml::node& node,
                                                               const std::string& what) const {
    ETALON_TRY(table, Table(node, what));
    std::map<std::string, std::string> texts;
    for (const auto& [key, entry] : InOrder(*table)) {
        ETALON_TRY(text, Text(*entry, what + " of '" + key + "'"));
        texts[key] = text;
    }
    return texts;
}

Result<Expression> TomlReader::Formula(const toml::node& node, const std::string& what) const {
    if (node.is_integer() || node.is_floating_point()) {
        ETALON_TRY(number, Number(node, what));
        return Expression::Constant(number);
    }
    ETALON_TRY(text, Text(node, what));
    auto expression = Expression::Parse(text);
    if (!expression) {
        return FailInside(node, expression.error());
    }
    return expression;
}

Result<std::string> TomlReader::TextAt(const toml::table& table, std::string_view key,
                                       std::optional<std::string> otherwise) const {
    const std::string quoted = "'" + std::string(key) + "'";
    const toml::node* node = table.get(key);
    if (node == nullptr) {
        return otherwise ? Result<std::string>(*otherwise) : Fail(table, quoted + " is missing");
    }
    ETALON_TRY(text, Text(*node, quoted));
    if (text.find_first_not_of(" \t\n") == std::string::npos && !otherwise) {
        return Fail(*node, quoted + " is empty");
    }
    return text;
}

}  // namespace etalon
