// The oracles: analytic truths by name, in binary64, each with a proven bound on its own error.
//
// To add one: a function in its topic's file (fresnel.cc, ...), a row in that file's table, and a
// test that holds it against MPFR at 200 bits over its whole domain.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace etalon::oracle {

struct Parameter {
    std::string_view name;
    unsigned components;  // 1 a scalar, 2..4 a vector
};

struct Function {
    std::string_view name;  // "fresnel.reflectance"
    std::vector<Parameter> parameters;
    unsigned components;  // of the result

    // Evaluates `rows` rows. inputs[k][row]: component k of the flattened parameters;
    // results[k][row] likewise. Inputs are exact. Where the quantity has no value (no critical
    // angle) the result is NaN.
    void (*evaluate)(const double* const* inputs, double* const* results, std::size_t rows);

    // |computed - exact| <= relative_bound * |exact| + absolute_bound for each component, over the
    // domain that the function's header states.
    double relative_bound;
    double absolute_bound;
};

// All functions, in the order of their files.
const std::vector<Function>& Functions();

// The function of that name, or nullptr.
const Function* FindFunction(std::string_view name);

}  // namespace etalon::oracle
