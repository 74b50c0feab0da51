#include "compile/types.h"

namespace etalon {

Result<Type> FromGlslang(const glslang::TType& type) {
    if (type.isArray()) {
        if (!type.getArraySizes()->isSized()) {
            return Error{"has an array without a length"};
        }
        glslang::TType element(type, 0);
        ETALON_TRY(inner, FromGlslang(element));
        Type array;
        array.kind = Type::Kind::kArray;
        array.length = static_cast<std::uint32_t>(type.getOuterArraySize());
        array.element.push_back(std::move(inner));
        return array;
    }
    Type result;
    if (type.isStruct()) {
        result.kind = Type::Kind::kStruct;
        result.name = type.getTypeName().c_str();
        for (const glslang::TTypeLoc& member : *type.getStruct()) {
            ETALON_TRY(inner, FromGlslang(*member.type));
            result.members.push_back({member.type->getFieldName().c_str(), {std::move(inner)}});
        }
        return result;
    }
    switch (type.getBasicType()) {
        case glslang::EbtVoid:
            return result;
        case glslang::EbtFloat:
            result.scalar = Scalar::kFloat;
            break;
        case glslang::EbtInt:
            result.scalar = Scalar::kInt;
            break;
        case glslang::EbtUint:
            result.scalar = Scalar::kUint;
            break;
        case glslang::EbtBool:
            result.scalar = Scalar::kBool;
            break;
        default:
            return Error{"is of type " + std::string(type.getBasicTypeString().c_str()) +
                         ", which a probe cannot carry: it takes float, int, uint, bool, vectors, "
                         "matrices, arrays and structures of these"};
    }
    if (type.isMatrix()) {
        result.kind = Type::Kind::kMatrix;
        result.columns = static_cast<std::uint32_t>(type.getMatrixCols());
        result.rows = static_cast<std::uint32_t>(type.getMatrixRows());
    } else if (type.isVector()) {
        result.kind = Type::Kind::kVector;
        result.rows = static_cast<std::uint32_t>(type.getVectorSize());
    } else {
        result.kind = Type::Kind::kScalar;
    }
    return result;
}

}  // namespace etalon
