// Types as the compiler would find them.
#pragma once

#include "probe/type.h"

namespace etalon {

inline Type ArrayOf(Type element, std::uint32_t length) {
    Type type;
    type.kind = Type::Kind::kArray;
    type.element.push_back(std::move(element));
    type.length = length;
    return type;
}

// struct Hit { vec3 position; float[2] depth; bool inside; };
inline Type HitType() {
    Type type;
    type.kind = Type::Kind::kStruct;
    type.name = "Hit";
    type.members.push_back({"position", {*BasicType("vec3")}});
    type.members.push_back({"depth", {ArrayOf(*BasicType("float"), 2)}});
    type.members.push_back({"inside", {*BasicType("bool")}});
    return type;
}

}  // namespace etalon
