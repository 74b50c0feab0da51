#include "probe/type.h"

#include "base/check.h"

namespace etalon {
namespace {

constexpr std::string_view kComponents = "xyzw";

void AddLeaves(const Type& type, const std::string& path, std::vector<Leaf>& leaves) {
    switch (type.kind) {
        case Type::Kind::kVoid:
            return;
        case Type::Kind::kScalar:
            leaves.push_back({path, type.scalar});
            return;
        case Type::Kind::kVector:
            for (std::uint32_t row = 0; row < type.rows; ++row) {
                leaves.push_back({path + "." + kComponents[row], type.scalar});
            }
            return;
        case Type::Kind::kMatrix:
            for (std::uint32_t column = 0; column < type.columns; ++column) {
                for (std::uint32_t row = 0; row < type.rows; ++row) {
                    leaves.push_back({path + "[" + std::to_string(column) + "]." + kComponents[row],
                                      type.scalar});
                }
            }
            return;
        case Type::Kind::kStruct:
            for (const Member& member : type.members) {
                AddLeaves(member.type.front(), path + "." + member.name, leaves);
            }
            return;
        case Type::Kind::kArray:
            for (std::uint32_t i = 0; i < type.length; ++i) {
                AddLeaves(type.element.front(), path + "[" + std::to_string(i) + "]", leaves);
            }
            return;
    }
}

std::string_view VectorPrefix(Scalar scalar) {
    switch (scalar) {
        case Scalar::kFloat:
            return "";
        case Scalar::kInt:
            return "i";
        case Scalar::kUint:
            return "u";
        case Scalar::kBool:
            return "b";
    }
    return "";
}

}  // namespace

std::string TypeText(const Type& type) {
    switch (type.kind) {
        case Type::Kind::kVoid:
            return "void";
        case Type::Kind::kScalar:
            return std::string(ScalarName(type.scalar));
        case Type::Kind::kVector:
            return std::string(VectorPrefix(type.scalar)) + "vec" + std::to_string(type.rows);
        case Type::Kind::kMatrix:
            return "mat" + std::to_string(type.columns) + "x" + std::to_string(type.rows);
        case Type::Kind::kStruct:
            return type.name;
        case Type::Kind::kArray: {
            // GLSL reads float[2][3] as two arrays of three: the outermost length comes first.
            std::string lengths;
            const Type* inner = &type;
            for (; inner->kind == Type::Kind::kArray; inner = &inner->element.front()) {
                lengths += "[" + std::to_string(inner->length) + "]";
            }
            return TypeText(*inner) + lengths;
        }
    }
    return "";
}

std::vector<Leaf> Leaves(const Type& type) {
    std::vector<Leaf> leaves;
    AddLeaves(type, "", leaves);
    return leaves;
}

Result<Type> BasicType(std::string_view name) {
    Type type;
    if (const auto scalar = ScalarFromName(name)) {
        type.kind = Type::Kind::kScalar;
        type.scalar = *scalar;
        return type;
    }
    const auto digit = [&](std::size_t at) -> std::uint32_t {
        return at < name.size() && name[at] >= '2' && name[at] <= '4'
                   ? static_cast<std::uint32_t>(name[at] - '0')
                   : 0;
    };
    for (const Scalar scalar : {Scalar::kFloat, Scalar::kInt, Scalar::kUint, Scalar::kBool}) {
        const std::string stem = std::string(VectorPrefix(scalar)) + "vec";
        if (name.starts_with(stem) && name.size() == stem.size() + 1 && digit(stem.size()) != 0) {
            type.kind = Type::Kind::kVector;
            type.scalar = scalar;
            type.rows = digit(stem.size());
            return type;
        }
    }
    if (name.starts_with("mat") && digit(3) != 0) {
        type.kind = Type::Kind::kMatrix;
        type.columns = digit(3);
        type.rows = type.columns;
        if (name.size() == 4) {
            return type;
        }
        if (name.size() == 6 && name[4] == 'x' && digit(5) != 0) {
            type.rows = digit(5);
            return type;
        }
    }
    return Error{"'" + std::string(name) + "' is not a scalar, vector or matrix type"};
}

}  // namespace etalon
