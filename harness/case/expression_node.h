// The tree of a host expression. A tree is never changed once an Expression holds it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "case/bounded.h"
#include "case/expression.h"
#include "case/expression_functions.h"
#include "oracle/function.h"

namespace etalon {

struct Expression::Node {
    enum class Kind : unsigned char { kConstant, kSymbol, kBuiltin, kOracle, kSelect };

    Kind kind = Kind::kConstant;
    std::size_t place = 1;  // column in the text
    std::string name;       // kSymbol, kOracle; kBuiltin: the function's or operator's
    Bounded constant;       // kConstant
    std::string selection;  // kSelect: the components' letters, or a number
    std::vector<std::shared_ptr<Node>> children;

    // Known after Bind.
    unsigned components = 0;
    unsigned first_column = 0;       // kSymbol
    std::vector<unsigned> selected;  // kSelect
    const Builtin* builtin = nullptr;
    const oracle::Function* oracle = nullptr;
};

// Parses the text into an unbound tree.
Result<std::shared_ptr<Expression::Node>> ParseExpression(std::string_view text);

// "column 7: reason"
Error At(std::size_t place, const std::string& reason);

}  // namespace etalon
