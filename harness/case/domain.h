// A domain: which inputs a case is evaluated at.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "case/expression.h"
#include "numeric/number_text.h"

namespace etalon {

// One input of the call and how its values are made (exactly one of values, range, sample "sphere",
// "hemisphere" or "any", and expr).
struct Input {
    std::string name;
    std::string type = "float";               // GLSL: scalar, vector or matrix
    std::vector<std::vector<double>> values;  // each of as many components as the type has
    std::optional<std::pair<double, double>> range;
    std::string sample;       // of a range "bits" (default), "linear", "log"; else as in cases
    std::string against;      // hemisphere: the vector that this one opposes, dot <= 0
    std::uint64_t count = 0;  // samples beside edges, ends and other special values
    std::uint64_t full = 0;   // the count of a deep run; 0: the same
    std::vector<Expression> edges;   // both sides of each boundary, over the other inputs
    std::optional<Expression> expr;  // computed from the other inputs, rounded to the type
    int line = 0;
};

struct Domain {
    std::vector<Input> inputs;
    bool zip = false;                 // rows side by side instead of every combination
    std::optional<Expression> where;  // rows for which this is false are left out
    std::string file;                 // where it and its inputs stand
    int line = 0;
};

// Names that expressions give a meaning of their own: no input may bear them.
bool IsReservedName(const std::string& name);

// A scalar column of a table of rows: "v.x" of type float.
struct Column {
    std::string name;
    Scalar scalar = Scalar::kFloat;
};

// An input as a GLSL variable and the columns that fill it, in order.
struct Variable {
    std::string name;
    std::string type;
    std::uint32_t first_column = 0;
    std::uint32_t columns = 1;
};

// Rows of 32-bit words, by columns: word of (row, column) at words[column * rows + row].
struct Table {
    std::vector<Variable> variables;
    std::vector<Column> columns;
    std::vector<std::uint32_t> words;
    std::uint64_t rows = 0;

    std::uint32_t At(std::uint64_t row, std::size_t column) const {
        return words[column * rows + row];
    }
};

// All rows of the domains, one after the other; they must have the same variables (their order is
// the first domain's). An empty result is an error, so is one of more than 2^24 rows. The seed
// decides every random choice. Errors begin with "file:line: ".
//
// Every combination: nested loops in the order of the inputs, the first outermost; an input that
// depends on others stands inside them. A range has `count` samples, one per stratum, and the
// landmarks of its spacing (see sampling.h), ascending; a sphere its axes, a hemisphere the normal
// and three nearly grazing directions before the samples; "any" is told in any_bits.h.
// Side by side (zip): a range, sphere or "any" has exactly `count` values in random order; a list
// of one value stands beside every row; edges cannot be had. A vector's range draws each component
// by itself, `count` values in all.
Result<Table> Expand(const std::vector<Domain>& domains, std::uint64_t seed);

// The columns of a variable of a basic GLSL type: "v.x", "v.y"; "m[0].x" (column 0, row x) for
// matrices; itself for a scalar. Fails for a type that is not scalar, vector or matrix.
Result<std::vector<Column>> ColumnsOf(const std::string& name, const std::string& type);

// The variables as an expression sees them: Expression::Bind(Symbols(...)) fits the columns below.
std::vector<Symbol> Symbols(const std::vector<Variable>& variables);

// Rows first ... first + rows - 1 of all columns as numbers, for Expression::Evaluate.
std::vector<std::vector<double>> Numbers(const Table& table, std::uint64_t first,
                                         std::uint64_t rows);

}  // namespace etalon
