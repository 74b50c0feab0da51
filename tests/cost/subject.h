// A call to be timed or counted, made by hand.
#pragma once

#include <bit>
#include <string>
#include <vector>

#include "compile/compile.h"
#include "run/prepared_case.h"
#include "support/folder.h"

namespace etalon {

// Of one input "x", a float with these values, or of others by `arguments` and `columns`, the words
// of each column.
struct SubjectText {
    std::string source;
    std::string call;
    std::vector<float> x = {0.25f, 0.5f, 0.75f};
    std::vector<Argument> arguments = {{"x", "float", true, false}};
    std::vector<std::vector<std::uint32_t>> columns = {};
    std::vector<BoundImage> images = {};
};

inline PreparedCase SubjectOf(const Folder& folder, const std::string& name,
                              const SubjectText& text) {
    PreparedCase prepared;
    prepared.call.source = folder.Write(name + ".glsl", text.source);
    prepared.call.arguments = text.arguments;
    prepared.call.images = text.images;
    prepared.call.wanted = {{"result", text.call, "CALL"}};
    const auto signature = Inspect(prepared.call);
    ETALON_CHECK(signature.ok());
    prepared.signature = *signature;
    std::vector<std::vector<std::uint32_t>> columns = text.columns;
    if (columns.empty()) {
        columns.emplace_back();
        for (const float value : text.x) {
            columns.back().push_back(std::bit_cast<std::uint32_t>(value));
        }
    }
    prepared.table.rows = columns.front().size();
    for (const std::vector<std::uint32_t>& column : columns) {
        prepared.table.columns.push_back({"input"});
        prepared.table.words.insert(prepared.table.words.end(), column.begin(), column.end());
    }
    prepared.all_rows = prepared.table.rows;
    return prepared;
}

}  // namespace etalon
