#include "run/csv.h"

#include <algorithm>
#include <cctype>

#include "base/file.h"

namespace etalon {
namespace {

std::string_view Trim(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<std::string_view> Fields(std::string_view line) {
    std::vector<std::string_view> fields;
    for (;;) {
        const std::size_t comma = line.find(',');
        fields.push_back(Trim(line.substr(0, comma)));
        if (comma == std::string_view::npos) {
            return fields;
        }
        line = line.substr(comma + 1);
    }
}

bool IsIdentifier(std::string_view text) {
    return !text.empty() &&
           (std::isalpha(static_cast<unsigned char>(text[0])) != 0 || text[0] == '_') &&
           std::all_of(text.begin(), text.end(), [](char c) {
               return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
           });
}

std::string_view BaseName(std::string_view name) {
    return name.substr(0, name.find_first_of(".["));
}

// "v.x:float" as a column; a missing type is float where `type_needed` is false.
Result<InputTable::Column> ParseColumn(std::string_view text, bool type_needed) {
    const std::size_t colon = text.find(':');
    const std::string_view name = Trim(text.substr(0, colon));
    if (!IsIdentifier(BaseName(name))) {
        return Error{"'" + std::string(name) + "' is not a GLSL name"};
    }
    InputTable::Column column{std::string(name), Scalar::kFloat};
    if (colon == std::string_view::npos) {
        if (type_needed) {
            return Error{"column '" + std::string(name) +
                         "' has no type; a header reads name:type, as in n1:float"};
        }
        return column;
    }
    const std::string_view type = Trim(text.substr(colon + 1));
    const std::optional<Scalar> scalar = ScalarFromName(type);
    if (!scalar) {
        return Error{"column '" + std::string(name) + "': '" + std::string(type) +
                     "' is not float, int, uint or bool"};
    }
    column.scalar = *scalar;
    return column;
}

bool HasColumn(const std::vector<InputTable::Column>& columns, const std::string& name) {
    return std::any_of(columns.begin(), columns.end(),
                       [&](const InputTable::Column& one) { return one.name == name; });
}

// Takes the next line off the text.
std::string_view NextLine(std::string_view& text) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    return Trim(line);
}

}  // namespace

Result<InputTable> ReadCsv(const std::filesystem::path& path) {
    ETALON_TRY(content, ReadTextFile(path));
    std::string_view text = content;
    if (text.starts_with("\xef\xbb\xbf")) {
        text.remove_prefix(3);
    }
    const auto at = [&](std::size_t line) {
        return path.string() + ":" + std::to_string(line) + ": ";
    };
    InputTable table;
    std::size_t line_number = 0;
    while (!text.empty() && table.columns.empty()) {
        ++line_number;
        const std::string_view line = NextLine(text);
        if (line.empty()) {
            continue;
        }
        for (const std::string_view field : Fields(line)) {
            Result<InputTable::Column> column = ParseColumn(field, true);
            if (!column) {
                return Error{at(line_number) + column.error().message};
            }
            if (HasColumn(table.columns, column->name)) {
                return Error{at(line_number) + "column '" + column->name + "' stands twice"};
            }
            table.columns.push_back(*column);
        }
    }
    if (table.columns.empty()) {
        return Error{at(1) + "no header; it reads name:type, as in n1:float,n2:float"};
    }
    const std::size_t width = table.columns.size();
    std::vector<std::uint32_t> by_rows;
    while (!text.empty()) {
        ++line_number;
        std::string_view line = NextLine(text);
        if (line.empty()) {
            continue;
        }
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t comma = line.find(',');
            const bool is_last = i + 1 == width;
            if ((comma == std::string_view::npos) != is_last) {
                const std::size_t fields =
                    i + 1 + static_cast<std::size_t>(std::count(line.begin(), line.end(), ','));
                return Error{at(line_number) + std::to_string(fields) + " values, the header has " +
                             std::to_string(width) + " columns"};
            }
            Result<std::uint32_t> word = ParseWord(table.columns[i].scalar, line.substr(0, comma));
            if (!word) {
                return Error{at(line_number) + "column '" + table.columns[i].name +
                             "': " + word.error().message};
            }
            by_rows.push_back(*word);
            line = is_last ? std::string_view() : line.substr(comma + 1);
        }
        ++table.rows;
    }
    if (table.rows == 0) {
        return Error{at(line_number) + "no rows"};
    }
    table.words.resize(by_rows.size());
    for (std::uint64_t row = 0; row < table.rows; ++row) {
        for (std::size_t c = 0; c < width; ++c) {
            table.words[c * table.rows + row] = by_rows[row * width + c];
        }
    }
    return table;
}

Result<InputTable> ReadAt(const std::string& text) {
    InputTable table;
    table.rows = 1;
    for (const std::string_view item : Fields(text)) {
        const std::size_t equals = item.find('=');
        if (equals == std::string_view::npos) {
            return Error{"--at: '" + std::string(item) + "' is not NAME=VALUE or NAME:TYPE=VALUE"};
        }
        Result<InputTable::Column> column = ParseColumn(item.substr(0, equals), false);
        if (!column) {
            return Error{"--at: " + column.error().message};
        }
        Result<std::uint32_t> word = ParseWord(column->scalar, item.substr(equals + 1));
        if (!word) {
            return Error{"--at: " + column->name + ": " + word.error().message};
        }
        if (HasColumn(table.columns, column->name)) {
            return Error{"--at: '" + column->name + "' stands twice"};
        }
        table.columns.push_back(*column);
        table.words.push_back(*word);
    }
    return table;
}

Result<std::vector<Argument>> ArgumentsOf(const InputTable& table,
                                          const std::vector<Argument>& declared,
                                          const std::string& origin) {
    std::vector<Argument> arguments;
    const auto known = [](const std::vector<Argument>& list, std::string_view name) {
        return std::find_if(list.begin(), list.end(),
                            [&](const Argument& one) { return one.name == name; });
    };
    for (const InputTable::Column& first : table.columns) {
        const std::string name(BaseName(first.name));
        if (known(arguments, name) != arguments.end()) {
            continue;
        }
        if (const auto given = known(declared, name); given != declared.end()) {
            arguments.push_back(*given);
            continue;
        }
        std::string parts;
        for (const InputTable::Column& column : table.columns) {
            if (BaseName(column.name) != name) {
                continue;
            }
            if (column.scalar != first.scalar) {
                return Error{origin + ": the components of '" + name + "' have different types"};
            }
            parts += column.name.substr(name.size()) + " ";
        }
        Type type;
        type.scalar = first.scalar;
        type.kind = Type::Kind::kScalar;
        const auto components =
            static_cast<std::uint32_t>(std::count(parts.begin(), parts.end(), '.'));
        if (components >= 2 && components <= 4) {
            type.kind = Type::Kind::kVector;
            type.rows = components;
        }
        std::string expected;
        for (const Leaf& leaf : Leaves(type)) {
            expected += leaf.path + " ";
        }
        // The components may stand in any order, but must be x, y and so on without a gap.
        std::string sorted = parts;
        if (type.kind == Type::Kind::kVector) {
            std::vector<std::string> words;
            for (std::size_t from = 0; from < parts.size();) {
                const std::size_t space = parts.find(' ', from);
                words.push_back(parts.substr(from, space - from));
                from = space + 1;
            }
            // w follows z but precedes x in the alphabet.
            std::sort(words.begin(), words.end(), [](const std::string& a, const std::string& b) {
                return (a == ".w" ? ".{" : a) < (b == ".w" ? ".{" : b);
            });
            sorted.clear();
            for (const std::string& word : words) {
                sorted += word + " ";
            }
        }
        if (sorted != expected) {
            return Error{origin + ": the columns of '" + name +
                         "' make no scalar and no vector (v.x, v.y, ...); --in " + name +
                         ":TYPE declares another type"};
        }
        arguments.push_back({name, TypeText(type), true, false});
    }
    for (const Argument& argument : declared) {
        if (known(arguments, argument.name) == arguments.end()) {
            return Error{origin + ": no column for input '" + argument.name + "'"};
        }
    }
    return arguments;
}

Result<std::vector<std::uint32_t>> Arrange(const InputTable& table,
                                           const std::vector<ProbeColumn>& columns,
                                           const std::string& origin) {
    std::vector<std::uint32_t> words;
    words.reserve(table.words.size());
    for (const ProbeColumn& column : columns) {
        const auto found =
            std::find_if(table.columns.begin(), table.columns.end(),
                         [&](const InputTable::Column& one) { return one.name == column.name; });
        if (found == table.columns.end()) {
            return Error{origin + ": no column '" + column.name + "'"};
        }
        if (found->scalar != column.scalar) {
            return Error{origin + ": column '" + column.name + "' is " +
                         std::string(ScalarName(found->scalar)) + ", the type wants " +
                         std::string(ScalarName(column.scalar))};
        }
        const auto from = table.words.begin() +
                          (found - table.columns.begin()) * static_cast<std::ptrdiff_t>(table.rows);
        words.insert(words.end(), from, from + static_cast<std::ptrdiff_t>(table.rows));
    }
    for (const InputTable::Column& column : table.columns) {
        const bool is_used =
            std::any_of(columns.begin(), columns.end(),
                        [&](const ProbeColumn& one) { return one.name == column.name; });
        if (!is_used) {
            return Error{origin + ": column '" + column.name + "' is no part of its type"};
        }
    }
    return words;
}

}  // namespace etalon
