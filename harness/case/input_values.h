// The values that an input has by itself: listed, drawn from a range, or from the sphere.
#pragma once

#include <cstdint>
#include <vector>

#include "base/result.h"
#include "case/domain.h"

namespace etalon {

// A basic GLSL type: `columns` vectors of `rows` scalars.
struct TypeShape {
    Scalar scalar = Scalar::kFloat;
    unsigned rows = 1;
    unsigned columns = 1;

    unsigned size() const { return rows * columns; }
};

// Fails, with the reason alone, for a type that is not scalar, vector or matrix.
Result<TypeShape> ShapeOf(const std::string& type);

// Component c of value k stands at words[k * components + c].
struct ValueList {
    unsigned components = 1;
    std::vector<std::uint32_t> words;

    std::size_t size() const { return words.size() / components; }
};

// The word of a number. An integer type takes integers in its range only; a float takes whatever
// does not overflow, and rounds it.
Result<std::uint32_t> WordOf(Scalar scalar, double value);

// The values of an input, edges aside; it must have values, a range, or sample "sphere" or "any".
// With `side_by_side` all but listed values are exactly `count`, shuffled. The error is the reason
// alone.
Result<ValueList> OwnValues(const Input& input, std::uint64_t seed, bool side_by_side);

}  // namespace etalon
