// Tables of inputs as CSV.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "probe/call.h"

namespace etalon {

// A table as read: columns in the file's order, words by columns.
struct InputTable {
    struct Column {
        std::string name;
        Scalar scalar = Scalar::kFloat;
    };
    std::vector<Column> columns;
    std::vector<std::uint32_t> words;
    std::uint64_t rows = 0;
};

// Reads "name:type,..." and rows of values. Blank lines are passed over; both ends of line are
// taken. Errors name file, line and column. A table without rows is an error.
Result<InputTable> ReadCsv(const std::filesystem::path& path);

// Reads "n1=0x1p+0,steps:int=3,v.x=0.5" as a table of one row; a type that is not given is float.
Result<InputTable> ReadAt(const std::string& text);

// The inputs that the table's columns make: "v.x", "v.y" are a vec2, a plain name is a scalar.
// Columns of other types are declared, with any GLSL type of the sources (a matrix, an array, a
// structure). `origin` is named in errors.
Result<std::vector<Argument>> ArgumentsOf(const InputTable& table,
                                          const std::vector<Argument>& declared,
                                          const std::string& origin);

// The words of the table in the order of `columns`. Fails where a column is missing, left over or
// of another type.
Result<std::vector<std::uint32_t>> Arrange(const InputTable& table,
                                           const std::vector<ProbeColumn>& columns,
                                           const std::string& origin);

}  // namespace etalon
