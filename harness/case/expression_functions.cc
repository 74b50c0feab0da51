#include "case/expression_functions.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace etalon {
namespace {

using B = Bounded;
using Shape = Builtin::Shape;

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

const B kOne{1, 0};
const B kTwo{2, 0};
const B kThree{3, 0};

long double Far(const B& a) {
    return std::fabs(a.value) + a.error;
}

B Sine(const B& a, const B&, const B&) {
    return Sloped(std::sin(a.value), a, 1, 2);
}

B Cosine(const B& a, const B&, const B&) {
    return Sloped(std::cos(a.value), a, 1, 2);
}

B Tangent(const B& a, const B&, const B&) {
    const long double cosine = std::fabs(std::cos(a.value)) - a.error;
    return Sloped(std::tan(a.value), a, cosine > 0 ? 1 / (cosine * cosine) : kInfinity, kInfinity);
}

B HyperbolicCosine(const B& a, const B&, const B&) {
    return Sloped(std::cosh(a.value), a, std::sinh(Far(a)), kInfinity);
}

B Exponential(const B& a, const B&, const B&) {
    return Monotone([](long double x) { return std::exp(x); }, a, -kInfinity, kInfinity);
}

B Clamp(const B& x, const B& low, const B& high) {
    return Minimum(Maximum(x, low), high);
}

B Mix(const B& x, const B& y, const B& t) {
    return x * (kOne - t) + y * t;
}

B Smoothstep(const B& from, const B& to, const B& x) {
    const B t = Clamp((x - from) / (to - from), B{0, 0}, kOne);
    return t * t * (kThree - kTwo * t);
}

B Sign(const B& a, const B&, const B&) {
    const long double sign = a.value > 0 ? 1 : (a.value < 0 ? -1 : 0);
    return {sign, a.error == 0 || std::fabs(a.value) > a.error ? 0.0L : 2.0L};
}

B Round(const B& a, const B&, const B&) {
    const long double value = std::nearbyint(a.value);
    return {value, std::max(value - std::nearbyint(a.value - a.error),
                            std::nearbyint(a.value + a.error) - value)};
}

B Fract(const B& a, const B&, const B&) {
    const B whole = Floor(a);
    return whole.error == 0 ? a - whole : B{a.value - whole.value, 1};
}

void Dot(const B* a, const B* b, unsigned size, B* out) {
    B sum = a[0] * b[0];
    for (unsigned k = 1; k < size; ++k) {
        sum = sum + a[k] * b[k];
    }
    *out = sum;
}

void Length(const B* a, const B*, unsigned size, B* out) {
    if (size == 1) {
        *out = Absolute(a[0]);
        return;
    }
    B square;
    Dot(a, a, size, &square);
    *out = Sqrt(square);
}

void Distance(const B* a, const B* b, unsigned size, B* out) {
    B difference[16];
    for (unsigned k = 0; k < size; ++k) {
        difference[k] = a[k] - b[k];
    }
    Length(difference, nullptr, size, out);
}

void Normalize(const B* a, const B*, unsigned size, B* out) {
    B length;
    Length(a, nullptr, size, &length);
    for (unsigned k = 0; k < size; ++k) {
        out[k] = a[k] / length;
    }
}

void Cross(const B* a, const B* b, unsigned, B* out) {
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned i = (k + 1) % 3;
        const unsigned j = (k + 2) % 3;
        out[k] = a[i] * b[j] - a[j] * b[i];
    }
}

void Reflect(const B* incident, const B* normal, unsigned size, B* out) {
    B along;
    Dot(normal, incident, size, &along);
    for (unsigned k = 0; k < size; ++k) {
        out[k] = incident[k] - kTwo * along * normal[k];
    }
}

void All(const B* a, const B*, unsigned size, B* out) {
    *out = kOne;
    for (unsigned k = 0; k < size; ++k) {
        *out = And(*out, a[k]);
    }
}

void Any(const B* a, const B*, unsigned size, B* out) {
    *out = B{0, 0};
    for (unsigned k = 0; k < size; ++k) {
        *out = Or(*out, a[k]);
    }
}

#define EACH(expression)                                                  \
    [](const B& a, const B& b, const B& c) {                              \
        static_cast<void>(a), static_cast<void>(b), static_cast<void>(c); \
        return B(expression);                                             \
    }
#define MONOTONE(function, low, high) \
    EACH(Monotone([](long double x) { return std::function(x); }, a, low, high))

const Builtin kBuiltins[] = {
    {"+", 2, Shape::kEach, EACH(a + b)},
    {"-", 2, Shape::kEach, EACH(a - b)},
    {"*", 2, Shape::kEach, EACH(a* b)},
    {"/", 2, Shape::kEach, EACH(a / b)},
    {"^", 2, Shape::kEach, EACH(Power(a, b))},
    {"-", 1, Shape::kEach, EACH(-a)},
    {"<", 2, Shape::kEach, EACH(Less(a, b))},
    {"<=", 2, Shape::kEach, EACH(LessEqual(a, b))},
    {">", 2, Shape::kEach, EACH(Less(b, a))},
    {">=", 2, Shape::kEach, EACH(LessEqual(b, a))},
    {"==", 2, Shape::kEach, EACH(Equal(a, b))},
    {"!=", 2, Shape::kEach, EACH(Not(Equal(a, b)))},
    {"&&", 2, Shape::kEach, EACH(And(a, b))},
    {"||", 2, Shape::kEach, EACH(Or(a, b))},
    {"!", 1, Shape::kEach, EACH(Not(a))},
    {"not", 1, Shape::kEach, EACH(Not(a))},

    {"abs", 1, Shape::kEach, EACH(Absolute(a))},
    {"sign", 1, Shape::kEach, Sign},
    {"min", 2, Shape::kEach, EACH(Minimum(a, b))},
    {"max", 2, Shape::kEach, EACH(Maximum(a, b))},
    {"clamp", 3, Shape::kEach, Clamp},
    {"mix", 3, Shape::kEach, Mix},
    {"step", 2, Shape::kEach, EACH(LessEqual(a, b))},
    {"smoothstep", 3, Shape::kEach, Smoothstep},
    {"floor", 1, Shape::kEach, EACH(Floor(a))},
    {"ceil", 1, Shape::kEach, EACH(-Floor(-a))},
    {"round", 1, Shape::kEach, Round},
    {"fract", 1, Shape::kEach, Fract},
    {"mod", 2, Shape::kEach, EACH(Modulo(a, b))},
    {"isnan", 1, Shape::kEach, EACH((B{std::isnan(a.value) ? 1.0L : 0.0L, 0}))},
    {"isinf", 1, Shape::kEach, EACH((B{std::isinf(a.value) ? 1.0L : 0.0L, 0}))},

    {"sqrt", 1, Shape::kEach, EACH(Sqrt(a))},
    {"inversesqrt", 1, Shape::kEach, EACH(kOne / Sqrt(a))},
    {"pow", 2, Shape::kEach, EACH(Power(a, b))},
    {"exp", 1, Shape::kEach, Exponential},
    {"exp2", 1, Shape::kEach, MONOTONE(exp2, -kInfinity, kInfinity)},
    {"log", 1, Shape::kEach, MONOTONE(log, 0, kInfinity)},
    {"log2", 1, Shape::kEach, MONOTONE(log2, 0, kInfinity)},
    {"sin", 1, Shape::kEach, Sine},
    {"cos", 1, Shape::kEach, Cosine},
    {"tan", 1, Shape::kEach, Tangent},
    {"asin", 1, Shape::kEach, MONOTONE(asin, -1, 1)},
    {"acos", 1, Shape::kEach, MONOTONE(acos, -1, 1)},
    {"atan", 1, Shape::kEach, MONOTONE(atan, -kInfinity, kInfinity)},
    {"atan", 2, Shape::kEach, EACH(Arctangent(a, b))},
    {"sinh", 1, Shape::kEach, MONOTONE(sinh, -kInfinity, kInfinity)},
    {"cosh", 1, Shape::kEach, HyperbolicCosine},
    {"tanh", 1, Shape::kEach, MONOTONE(tanh, -kInfinity, kInfinity)},

    {"dot", 2, Shape::kScalar, nullptr, Dot},
    {"length", 1, Shape::kScalar, nullptr, Length},
    {"distance", 2, Shape::kScalar, nullptr, Distance},
    {"any", 1, Shape::kScalar, nullptr, Any},
    {"all", 1, Shape::kScalar, nullptr, All},
    {"normalize", 1, Shape::kSame, nullptr, Normalize},
    {"reflect", 2, Shape::kSame, nullptr, Reflect},
    {"cross", 2, Shape::kThree, nullptr, Cross},

    {"vec2", 1, Shape::kJoin, nullptr, nullptr, 2},
    {"vec2", 2, Shape::kJoin, nullptr, nullptr, 2},
    {"vec3", 1, Shape::kJoin, nullptr, nullptr, 3},
    {"vec3", 2, Shape::kJoin, nullptr, nullptr, 3},
    {"vec3", 3, Shape::kJoin, nullptr, nullptr, 3},
    {"vec4", 1, Shape::kJoin, nullptr, nullptr, 4},
    {"vec4", 2, Shape::kJoin, nullptr, nullptr, 4},
    {"vec4", 3, Shape::kJoin, nullptr, nullptr, 4},
    {"vec4", 4, Shape::kJoin, nullptr, nullptr, 4},
};
#undef EACH
#undef MONOTONE

constexpr long double kRounding = std::numeric_limits<long double>::epsilon();
const std::pair<std::string_view, B> kConstants[] = {
    {"pi", {std::numbers::pi_v<long double>, std::numbers::pi_v<long double>* kRounding}},
    {"e", {std::numbers::e_v<long double>, std::numbers::e_v<long double>* kRounding}},
    {"infinity", {kInfinity, 0}},
};

}  // namespace

const Builtin* FindBuiltin(std::string_view name, std::size_t arguments) {
    for (const Builtin& builtin : kBuiltins) {
        if (builtin.name == name && builtin.arguments == arguments) {
            return &builtin;
        }
    }
    return nullptr;
}

std::vector<const Builtin*> BuiltinsNamed(std::string_view name) {
    std::vector<const Builtin*> found;
    for (const Builtin& builtin : kBuiltins) {
        if (builtin.name == name) {
            found.push_back(&builtin);
        }
    }
    return found;
}

std::vector<std::string_view> FunctionNames() {
    std::vector<std::string_view> names;
    for (const Builtin& builtin : kBuiltins) {
        if (std::isalpha(static_cast<unsigned char>(builtin.name[0])) != 0) {
            names.push_back(builtin.name);
        }
    }
    return names;
}

const Bounded* FindConstant(std::string_view name) {
    for (const auto& [constant, value] : kConstants) {
        if (constant == name) {
            return &value;
        }
    }
    return nullptr;
}

}  // namespace etalon
