// GLSL types as a probe sees them: flattened into scalars, each a 32-bit word.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/result.h"
#include "numeric/number_text.h"

namespace etalon {

struct Type;

struct Member {
    std::string name;
    std::vector<Type> type;  // exactly one; a vector because Type is incomplete here
};

// A scalar, vector, matrix, structure, or array of these; or void.
struct Type {
    enum class Kind : std::uint8_t { kVoid, kScalar, kVector, kMatrix, kStruct, kArray };
    Kind kind = Kind::kVoid;
    Scalar scalar = Scalar::kFloat;  // of scalar, vector and matrix
    std::uint32_t columns = 1;       // of a matrix
    std::uint32_t rows = 1;          // components of a vector; rows of a matrix
    std::string name;                // of a structure
    std::vector<Member> members;     // of a structure
    std::vector<Type> element;       // of an array: exactly one
    std::uint32_t length = 0;        // of an array

    bool operator==(const Type&) const = default;
};
inline bool operator==(const Member& a, const Member& b) {
    return a.name == b.name && a.type == b.type;
}

// One scalar of a value: how GLSL reaches it and what its table column is called. For `hit` of a
// structure type the path is ".position.x", ".normals[2].y"; empty for a scalar.
struct Leaf {
    std::string path;
    Scalar scalar = Scalar::kFloat;
};

std::string TypeText(const Type& type);  // "mat2x3", "Hit", "float[3]"
std::vector<Leaf> Leaves(const Type& type);

// A basic type by its GLSL name ("vec3", "mat4x2", "uint"), without arrays and structures.
Result<Type> BasicType(std::string_view name);

}  // namespace etalon
