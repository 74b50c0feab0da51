#include "run/given.h"

#include <algorithm>

#include "numeric/number_text.h"

namespace etalon {

Result<std::vector<std::optional<std::uint32_t>>> ReadGiven(const std::vector<Column>& columns,
                                                            const std::string& at,
                                                            const std::string& origin) {
    std::vector<std::optional<std::uint32_t>> given(columns.size());
    std::size_t from = 0;
    while (!at.empty() && from <= at.size()) {
        const std::size_t comma = std::min(at.find(',', from), at.size());
        std::string item = at.substr(from, comma - from);
        from = comma + 1;
        item.erase(0, item.find_first_not_of(' '));
        const std::size_t equals = item.find('=');
        if (equals == std::string::npos) {
            return Error{origin + ": '" + item + "' is not NAME=VALUE"};
        }
        const std::string name = item.substr(0, equals);
        const auto column = std::find_if(columns.begin(), columns.end(),
                                         [&](const Column& one) { return one.name == name; });
        if (column == columns.end()) {
            return Error{origin + ": the case has no input '" + name + "'"};
        }
        Result<std::uint32_t> word = ParseWord(column->scalar, item.substr(equals + 1));
        if (!word) {
            return Error{origin + ": " + name + ": " + word.error().message};
        }
        auto& place = given[static_cast<std::size_t>(column - columns.begin())];
        if (place) {
            return Error{origin + ": '" + name + "' stands twice"};
        }
        place = *word;
    }
    return given;
}

}  // namespace etalon
