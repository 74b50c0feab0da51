// The shader itself, read as C++: so much of GLSL as it needs, and constants in single precision by
// the compiler's option.
#include "benchmark/fresnel_host.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace etalon {
namespace {
namespace glsl {

using uint = std::uint32_t;

template <typename T>
struct Two {
    T x{}, y{};
    Two() = default;
    explicit Two(T a) : x(a), y(a) {}
    Two(T a, T b) : x(a), y(b) {}
};
template <typename T>
struct Three {
    union {
        struct {
            T x, y, z;
        };
        struct {
            T r, g, b;
        };
    };
    Three() : x(0), y(0), z(0) {}
    explicit Three(T a) : x(a), y(a), z(a) {}
    Three(T a, T b_, T c) : x(a), y(b_), z(c) {}
    Three operator-() const { return {-x, -y, -z}; }
    friend Three operator-(Three a, Three c) { return {a.x - c.x, a.y - c.y, a.z - c.z}; }
    friend Three operator*(T a, Three c) { return {a * c.x, a * c.y, a * c.z}; }
    friend Three operator/(Three a, T c) { return {a.x / c, a.y / c, a.z / c}; }
};
using vec2 = Two<float>;
using ivec2 = Two<int>;
using uvec2 = Two<uint>;
using vec3 = Three<float>;
using ivec3 = Three<int>;
struct vec4 {
    union {
        struct {
            float x, y, z, w;
        };
        vec2 xy;
    };
    vec4(float a, float b, float c, float d) : x(a), y(b), z(c), w(d) {}
};
struct mat3 {
    vec3 a, b, c;
    mat3(vec3 p, vec3 q, vec3 r) : a(p), b(q), c(r) {}
};
inline ivec2 operator&(ivec2 a, int b) {
    return {a.x & b, a.y & b};
}
inline ivec2 operator|(ivec2 a, ivec2 b) {
    return {a.x | b.x, a.y | b.y};
}
inline ivec3 operator&(ivec3 a, int b) {
    return {a.x & b, a.y & b, a.z & b};
}
inline ivec3 operator|(ivec3 a, ivec3 b) {
    return {a.x | b.x, a.y | b.y, a.z | b.z};
}

inline float min(float a, float b) {
    return b < a ? b : a;
}
inline float max(float a, float b) {
    return a < b ? b : a;
}
inline int min(int a, int b) {
    return b < a ? b : a;
}
inline ivec2 min(ivec2 a, int b) {
    return {min(a.x, b), min(a.y, b)};
}
inline ivec3 min(ivec3 a, int b) {
    return {min(a.x, b), min(a.y, b), min(a.z, b)};
}
inline int clamp(int x, int a, int b) {
    return std::min(std::max(x, a), b);
}
inline float clamp(float x, float a, float b) {
    return min(max(x, a), b);
}
inline ivec3 clamp(ivec3 x, int a, int b) {
    return {clamp(x.x, a, b), clamp(x.y, a, b), clamp(x.z, a, b)};
}
inline float sqrt(float x) {
    return std::sqrt(x);
}
inline float dot(vec3 a, vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline int floatBitsToInt(float x) {
    return std::bit_cast<int>(x);
}
inline uint floatBitsToUint(float x) {
    return std::bit_cast<uint>(x);
}
inline float intBitsToFloat(int x) {
    return std::bit_cast<float>(x);
}
inline float uintBitsToFloat(uint x) {
    return std::bit_cast<float>(x);
}
inline ivec2 floatBitsToInt(vec2 v) {
    return {floatBitsToInt(v.x), floatBitsToInt(v.y)};
}
inline ivec3 floatBitsToInt(vec3 v) {
    return {floatBitsToInt(v.x), floatBitsToInt(v.y), floatBitsToInt(v.z)};
}
inline vec2 intBitsToFloat(ivec2 v) {
    return {intBitsToFloat(v.x), intBitsToFloat(v.y)};
}
inline vec3 intBitsToFloat(ivec3 v) {
    return {intBitsToFloat(v.x), intBitsToFloat(v.y), intBitsToFloat(v.z)};
}

#include "../../shaders/optics/fresnel.glsl"

}  // namespace glsl
}  // namespace

float FresnelTransmittance(float n1, float n2, float cos_i) {
    return glsl::fresnel_transmittance(n1, n2, cos_i);
}

}  // namespace etalon
