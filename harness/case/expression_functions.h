// The functions and operators of host expressions.
#pragma once

#include <string_view>
#include <vector>

#include "case/bounded.h"

namespace etalon {

struct Builtin {
    // How the arguments' shapes make the result's.
    enum class Shape : unsigned char {
        kEach,    // component by component; a scalar stands for all of a vector's
        kScalar,  // vectors of one size -> a scalar
        kSame,    // vectors of one size -> a vector of that size
        kThree,   // vectors of three -> the same
        kJoin,    // a constructor: components one after the other
    };
    std::string_view name;
    unsigned arguments;
    Shape shape;
    BoundedMap map = nullptr;    // kEach
    BoundedFold fold = nullptr;  // the others, but kJoin
    unsigned joined = 0;         // kJoin: components of the result
};

// The function or operator of that name and number of arguments, or nullptr.
const Builtin* FindBuiltin(std::string_view name, std::size_t arguments);

// All with that name; operators stand under their signs.
std::vector<const Builtin*> BuiltinsNamed(std::string_view name);

// The names of all functions, without operators.
std::vector<std::string_view> FunctionNames();

// pi, e, infinity.
const Bounded* FindConstant(std::string_view name);

}  // namespace etalon
