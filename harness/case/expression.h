// Host expressions: the truth of a case, its edges and its conditions, over named inputs and
// oracles.
//
//   fresnel.reflectance(n1, n2, cos_i)      an oracle, its arguments scalars or vectors
//   1 - 2^(-d / h)                          arithmetic; ^ is a power
//   dot(v, n) <= 0 && n1 < n2               comparisons and && || ! yield 1 or 0
//   v.x, vec3(1, 0, 0), length(v), sqrt(x)  components, constructors, functions as in GLSL
//
// Values are scalars or vectors (matrices stand flattened, column by column). Evaluated in the
// 64-bit mantissa of long double, except inside oracles, with a running bound on the error of each
// value.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace etalon {

// Name and number of components of something that an expression may mention.
struct Symbol {
    std::string name;
    unsigned components = 1;
};

class Expression {
  public:
    // Parses; names are resolved at Bind. The error is "column 7: reason", its place counted from 1
    // in `text`.
    static Result<Expression> Parse(std::string_view text);
    static Expression Constant(double value);

    const std::string& text() const;

    // The names that the expression mentions, without oracles and functions.
    std::vector<std::string> Names() const;

    // Resolves names against `symbols` and checks shapes; after it the expression can be evaluated.
    // Returns the number of components of the value.
    Result<unsigned> Bind(std::span<const Symbol> symbols);

    // One component of a value, and a bound on its distance from the exact value at the exact
    // inputs.
    struct Value {
        double value = 0;
        double error = 0;
    };

    // Evaluates rows: columns[k][row] is component k of the flattened symbols, in the order of
    // Bind. results is resized to components * rows, by columns. Thread-safe.
    void Evaluate(std::span<const double* const> columns, std::size_t rows,
                  std::vector<Value>& results) const;

    // True where the value is a single oracle applied to plain symbols and constants: then
    // EvaluateFast fills plain doubles (by columns) and the bounds are the oracle's relative and
    // absolute ones.
    bool IsFast() const;
    void EvaluateFast(std::span<const double* const> columns, std::size_t rows,
                      std::vector<double>& results) const;
    double relative_bound() const;
    double absolute_bound() const;

    struct Node;  // in expression_node.h

  private:
    std::shared_ptr<const Node> root_;
    std::string text_;
};

}  // namespace etalon
