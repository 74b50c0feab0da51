// Every instruction family against the host's arithmetic.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "evaluate/big.h"
#include "evaluate/probed.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using Words = std::vector<std::uint32_t>;

constexpr std::size_t kRows = 1000;

// All kinds of floats: any bits, and near one.
std::vector<float> SomeFloats(std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<float> values = {0.0f,  -0.0f,  1.0f,  -1.0f,    0.5f,      1.5f, 2.5f,
                                 -2.5f, 1e-40f, 3e38f, INFINITY, -INFINITY, NAN};
    std::uniform_real_distribution<float> near(-4.0f, 4.0f);
    while (values.size() < kRows) {
        values.push_back(values.size() % 3 == 0
                             ? std::bit_cast<float>(static_cast<std::uint32_t>(random()))
                             : near(random));
    }
    std::shuffle(values.begin(), values.end(), random);
    return values;
}
Words Bits(const std::vector<float>& values) {
    Words words;
    for (const float value : values) {
        words.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return words;
}
Words SomeWords(std::uint32_t seed) {
    std::mt19937 random(seed);
    Words words = {0, 1, 2, 31, 32, 0xffffffffu, 0x80000000u, 0x7fffffffu};
    while (words.size() < kRows) {
        words.push_back(
            static_cast<std::uint32_t>(words.size() % 2 == 0 ? random() : random() % 64));
    }
    std::shuffle(words.begin(), words.end(), random);
    return words;
}
bool SameFloat(std::uint32_t a, std::uint32_t b) {
    return a == b || (std::isnan(std::bit_cast<float>(a)) && std::isnan(std::bit_cast<float>(b)));
}

struct FloatRow {
    const char* expression;
    std::function<float(float, float)> host;
};

float Min(float a, float b) {
    return std::isnan(a) || b < a ? b : a;
}
float Max(float a, float b) {
    return std::isnan(a) || a < b ? b : a;
}
float Wide(double x) {
    return static_cast<float>(x);
}

TEST(Operations, OfFloatsAreTheHosts) {
    const std::vector<FloatRow> rows = {
        {"a + b", [](float a, float b) { return a + b; }},
        {"a - b", [](float a, float b) { return a - b; }},
        {"a * b", [](float a, float b) { return a * b; }},
        {"a / b", [](float a, float b) { return a / b; }},
        {"-a", [](float a, float) { return -a; }},
        {"mod(a, b)", [](float a, float b) { return a - b * std::floor(a / b); }},
        {"a * b + a", [](float a, float b) { return a * b + a; }},
        {"fma(a, b, a)", [](float a, float b) { return std::fma(a, b, a); }},
        {"abs(a)", [](float a, float) { return std::abs(a); }},
        {"floor(a)", [](float a, float) { return std::floor(a); }},
        {"ceil(a)", [](float a, float) { return std::ceil(a); }},
        {"trunc(a)", [](float a, float) { return std::trunc(a); }},
        {"roundEven(a)", [](float a, float) { return std::nearbyint(a); }},
        {"fract(a)", [](float a, float) { return a - std::floor(a); }},
        {"sign(a)", [](float a, float) { return a > 0   ? 1.0f
                                                : a < 0 ? -1.0f
                                                        : a; }},
        {"min(a, b)", Min},
        {"max(a, b)", Max},
        {"clamp(a, -1.0, 1.0)", [](float a, float) { return Min(Max(a, -1.0f), 1.0f); }},
        {"mix(a, b, 0.25)", [](float a, float b) { return a * 0.75f + b * 0.25f; }},
        {"step(a, b)", [](float a, float b) { return b < a ? 0.0f : 1.0f; }},
        {"sqrt(a)", [](float a, float) { return std::sqrt(a); }},
        {"inversesqrt(a)", [](float a, float) { return Wide(1.0 / std::sqrt(double{a})); }},
        {"sin(a)", [](float a, float) { return Wide(std::sin(double{a})); }},
        {"cos(a)", [](float a, float) { return Wide(std::cos(double{a})); }},
        {"tan(a)", [](float a, float) { return Wide(std::tan(double{a})); }},
        {"asin(a)", [](float a, float) { return Wide(std::asin(double{a})); }},
        {"acos(a)", [](float a, float) { return Wide(std::acos(double{a})); }},
        {"atan(a)", [](float a, float) { return Wide(std::atan(double{a})); }},
        {"atan(a, b)", [](float a, float b) { return Wide(std::atan2(double{a}, double{b})); }},
        {"sinh(a)", [](float a, float) { return Wide(std::sinh(double{a})); }},
        {"cosh(a)", [](float a, float) { return Wide(std::cosh(double{a})); }},
        {"tanh(a)", [](float a, float) { return Wide(std::tanh(double{a})); }},
        {"asinh(a)", [](float a, float) { return Wide(std::asinh(double{a})); }},
        {"acosh(a)", [](float a, float) { return Wide(std::acosh(double{a})); }},
        {"atanh(a)", [](float a, float) { return Wide(std::atanh(double{a})); }},
        {"exp(a)", [](float a, float) { return Wide(std::exp(double{a})); }},
        {"log(a)", [](float a, float) { return Wide(std::log(double{a})); }},
        {"exp2(a)", [](float a, float) { return Wide(std::exp2(double{a})); }},
        {"log2(a)", [](float a, float) { return Wide(std::log2(double{a})); }},
        {"pow(a, b)", [](float a, float b) { return Wide(std::pow(double{a}, double{b})); }},
        {"a < b ? a : b", [](float a, float b) { return a < b ? a : b; }},
        {"length(a)", [](float a, float) { return std::abs(a); }},
        {"float(isnan(a))", [](float a, float) { return std::isnan(a) ? 1.0f : 0.0f; }},
        {"float(isinf(a))", [](float a, float) { return std::isinf(a) ? 1.0f : 0.0f; }},
        {"float(a == b)", [](float a, float b) { return a == b ? 1.0f : 0.0f; }},
        {"float(a != b)", [](float a, float b) { return a != b ? 1.0f : 0.0f; }},
        {"float(a <= b)", [](float a, float b) { return a <= b ? 1.0f : 0.0f; }},
        {"float(a >= b)", [](float a, float b) { return a >= b ? 1.0f : 0.0f; }},
        {"uintBitsToFloat(floatBitsToUint(a))", [](float a, float) { return a; }},
        {"ldexp(a, 3)", [](float a, float) { return std::ldexp(a, 3); }},
    };
    const std::vector<float> a = SomeFloats(1);
    const std::vector<float> b = SomeFloats(2);
    for (const FloatRow& row : rows) {
        const Probed probed("", row.expression, {"float a", "float b"});
        ASSERT_EQ(probed.error(), "") << row.expression;
        const auto out = probed.Words<float>({Bits(a), Bits(b)});
        ASSERT_TRUE(out.ok()) << row.expression << ": " << out.error().message;
        for (std::size_t i = 0; i < kRows; ++i) {
            const auto truth = std::bit_cast<std::uint32_t>(row.host(a[i], b[i]));
            ASSERT_TRUE(SameFloat((*out)[i], truth))
                << row.expression << " of " << a[i] << ", " << b[i] << " is "
                << std::bit_cast<float>((*out)[i]);
        }
    }
}

struct WordRow {
    const char* expression;
    std::function<std::uint32_t(std::uint32_t, std::uint32_t)> host;
};

std::int32_t Signed(std::uint32_t word) {
    return static_cast<std::int32_t>(word);
}

TEST(Operations, OfWordsAreTheHosts) {
    using Word = std::uint32_t;
    const auto of_signed = [](std::int64_t x) { return static_cast<Word>(x); };
    const std::vector<WordRow> rows = {
        {"a + b", [](Word a, Word b) { return a + b; }},
        {"a - b", [](Word a, Word b) { return a - b; }},
        {"a * b", [](Word a, Word b) { return a * b; }},
        {"a / b", [](Word a, Word b) { return b == 0 ? 0 : a / b; }},
        {"a % b", [](Word a, Word b) { return b == 0 ? a : a % b; }},
        {"uint(int(a) / int(b))",
         [&](Word a, Word b) {
             return b == 0 ? 0 : of_signed(std::int64_t{Signed(a)} / Signed(b));
         }},
        {"uint(-int(a))", [](Word a, Word) { return 0u - a; }},
        {"a & b", [](Word a, Word b) { return a & b; }},
        {"a | b", [](Word a, Word b) { return a | b; }},
        {"a ^ b", [](Word a, Word b) { return a ^ b; }},
        {"~a", [](Word a, Word) { return ~a; }},
        {"a << (b & 31u)", [](Word a, Word b) { return a << (b & 31u); }},
        {"a >> (b & 31u)", [](Word a, Word b) { return a >> (b & 31u); }},
        {"uint(int(a) >> (b & 31u))",
         [&](Word a, Word b) { return of_signed(Signed(a) >> (b & 31u)); }},
        {"uint(bitCount(a))", [](Word a, Word) { return static_cast<Word>(std::popcount(a)); }},
        {"bitfieldReverse(bitfieldReverse(a))", [](Word a, Word) { return a; }},
        {"bitfieldReverse(a) & 1u", [](Word a, Word) { return a >> 31; }},
        {"bitfieldExtract(a, 5, 9)", [](Word a, Word) { return a >> 5 & 0x1ffu; }},
        {"uint(bitfieldExtract(int(a), 5, 9))",
         [&](Word a, Word) { return of_signed(Signed(a << 18) >> 23); }},
        {"bitfieldInsert(a, b, 4, 8)",
         [](Word a, Word b) { return (a & ~0xff0u) | (b << 4 & 0xff0u); }},
        {"uint(findLSB(a))",
         [](Word a, Word) { return a == 0 ? ~0u : static_cast<Word>(std::countr_zero(a)); }},
        {"uint(findMSB(a))",
         [](Word a, Word) { return static_cast<Word>(std::bit_width(a)) - 1u; }},
        {"uint(findMSB(int(a)))",
         [](Word a, Word) {
             return static_cast<Word>(std::bit_width(Signed(a) < 0 ? ~a : a)) - 1u;
         }},
        {"min(a, b)", [](Word a, Word b) { return std::min(a, b); }},
        {"uint(max(int(a), int(b)))",
         [&](Word a, Word b) { return of_signed(std::max(Signed(a), Signed(b))); }},
        {"uint(abs(int(a)))", [](Word a, Word) { return Signed(a) < 0 ? 0u - a : a; }},
        {"uint(sign(int(a)))",
         [&](Word a, Word) { return of_signed((Signed(a) > 0) - (Signed(a) < 0)); }},
        {"uint(clamp(int(a), -3, 7))",
         [&](Word a, Word) { return of_signed(std::clamp(Signed(a), -3, 7)); }},
        {"uint(int(a) < int(b))", [](Word a, Word b) { return Word{Signed(a) < Signed(b)}; }},
        {"uint(a <= b)", [](Word a, Word b) { return Word{a <= b}; }},
        {"uint(a == b || a > b && !(a >= 7u))",
         [](Word a, Word b) { return Word{a == b || (a > b && a < 7)}; }},
        {"uint((a > b) != (b > 3u))", [](Word a, Word b) { return Word{(a > b) != (b > 3)}; }},
        {"floatBitsToUint(float(a))",
         [](Word a, Word) { return std::bit_cast<Word>(static_cast<float>(a)); }},
        {"floatBitsToUint(float(int(a)))",
         [](Word a, Word) { return std::bit_cast<Word>(static_cast<float>(Signed(a))); }},
        {"uint(float(a & 0xffffu) * 0.5)", [](Word a, Word) { return (a & 0xffffu) / 2; }},
        {"carry(a, b)", [](Word a, Word b) { return Word{a + b < a} + 2 * Word{a < b}; }},
        {"high(a, b)",
         [](Word a, Word b) { return static_cast<Word>(std::uint64_t{a} * b >> 32); }},
        {"pick(a, b)", [](Word a, Word b) { return (a & 3u) == 2 ? b : a; }},
        {"packUnorm4x8(unpackUnorm4x8(a))", [](Word a, Word) { return a; }},
        {"packUnorm2x16(unpackUnorm2x16(a))", [](Word a, Word) { return a; }},
        {"packSnorm4x8(unpackSnorm4x8(a & 0x7f7f7f7fu))",
         [](Word a, Word) { return a & 0x7f7f7f7fu; }},
        {"packSnorm2x16(unpackSnorm2x16(a & 0x7fff7fffu))",
         [](Word a, Word) { return a & 0x7fff7fffu; }},
        {"packHalf2x16(unpackHalf2x16(a & 0xfbfffbffu))",
         [](Word a, Word) { return a & 0xfbfffbffu; }},
    };
    const char* source =
        "uint carry(uint a, uint b) { uint c; uint d; uaddCarry(a, b, c); usubBorrow(a, b, d);\n"
        "  return c + 2u * d; }\n"
        "uint high(uint a, uint b) { uint m; uint l; umulExtended(a, b, m, l); return m; }\n"
        "uint pick(uint a, uint b) { uvec4 v = uvec4(a, a, b, a); return v[a & 3u]; }\n";
    const Words a = SomeWords(1);
    const Words b = SomeWords(2);
    for (const WordRow& row : rows) {
        const Probed probed(source, row.expression, {"uint a", "uint b"});
        ASSERT_EQ(probed.error(), "") << row.expression;
        const auto out = probed.Words<float>({a, b});
        ASSERT_TRUE(out.ok()) << row.expression << ": " << out.error().message;
        for (std::size_t i = 0; i < kRows; ++i) {
            ASSERT_EQ((*out)[i], row.host(a[i], b[i]))
                << row.expression << " of " << a[i] << ", " << b[i];
        }
    }
}

TEST(Operations, OfVectorsAndMatrices) {
    const Probed probed(
        "float both(vec3 a, vec3 b) {\n"
        "  mat3 m = outerProduct(a, b);\n"
        "  mat2x3 n = mat2x3(a, b);\n"
        "  vec3 v = m * a + a * m + n * vec2(2.0, 3.0);\n"
        "  mat3 q = transpose(m) * m;\n"
        "  v += q[1] + vec3(a * n, 1.0);\n"
        "  v = cross(v, a).zxy + reflect(a, b) + faceforward(a, b, v);\n"
        "  return dot(v, b) + determinant(mat3(a, b, a.yzx)) + length(v) + distance(a, b);\n"
        "}\n",
        "both(a, b)", {"vec3 a", "vec3 b"});
    ASSERT_EQ(probed.error(), "");
    using V = std::array<float, 3>;
    const auto dot = [](const V& a, const V& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    const auto host = [&](const V& a, const V& b) {
        std::array<V, 3> m;
        for (std::size_t i = 0; i < 9; ++i) {
            m[i / 3][i % 3] = a[i % 3] * b[i / 3];
        }
        V v;
        for (std::size_t r = 0; r < 3; ++r) {
            v[r] = (m[0][r] * a[0] + m[1][r] * a[1] + m[2][r] * a[2]) + dot(a, m[r]);
            v[r] = v[r] + (a[r] * 2.0f + b[r] * 3.0f);
        }
        const V row = {dot(m[0], m[1]), dot(m[1], m[1]), dot(m[2], m[1])};
        const V more = {dot(a, a), dot(a, b), 1.0f};
        for (std::size_t r = 0; r < 3; ++r) {
            v[r] = v[r] + (row[r] + more[r]);
        }
        const auto cross = [](const V& x, const V& y) {
            return V{x[1] * y[2] - y[1] * x[2], x[2] * y[0] - y[2] * x[0],
                     x[0] * y[1] - y[0] * x[1]};
        };
        const V c = cross(v, a);
        const V turned = {c[2], c[0], c[1]};
        const float twice = 2.0f * dot(b, a);
        const bool keeps = dot(v, b) < 0;
        for (std::size_t r = 0; r < 3; ++r) {
            v[r] = turned[r] + (a[r] - twice * b[r]) + (keeps ? a[r] : -a[r]);
        }
        const V d = {a[1], a[2], a[0]};
        const auto two = [](float p, float q, float r, float s) { return p * s - r * q; };
        const float determinant = a[0] * two(b[1], b[2], d[1], d[2]) -
                                  b[0] * two(a[1], a[2], d[1], d[2]) +
                                  d[0] * two(a[1], a[2], b[1], b[2]);
        const V way = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        return dot(v, b) + determinant + std::sqrt(dot(v, v)) + std::sqrt(dot(way, way));
    };
    std::vector<std::vector<float>> inputs;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> near(-2.0f, 2.0f);
    for (int column = 0; column < 6; ++column) {
        inputs.emplace_back();
        for (std::size_t i = 0; i < kRows; ++i) {
            inputs.back().push_back(near(random));
        }
    }
    const std::vector<float> out = probed.Floats(inputs);
    ASSERT_EQ(out.size(), kRows);
    for (std::size_t i = 0; i < kRows; ++i) {
        const V a = {inputs[0][i], inputs[1][i], inputs[2][i]};
        const V b = {inputs[3][i], inputs[4][i], inputs[5][i]};
        ASSERT_EQ(out[i], host(a, b)) << i;
    }
}

TEST(Operations, InverseTimesMatrixIsOne) {
    const Probed probed("mat4 turn(mat4 m) { return inverse(m) * m; }\n", "turn(m)", {"mat4 m"});
    ASSERT_EQ(probed.error(), "");
    std::vector<Words> inputs;
    std::mt19937 random(4);
    std::uniform_real_distribution<float> near(-1.0f, 1.0f);
    for (std::size_t i = 0; i < 16; ++i) {
        inputs.push_back({});
        for (std::size_t row = 0; row < 50; ++row) {
            inputs.back().push_back(
                std::bit_cast<std::uint32_t>(near(random) + (i % 5 == 0 ? 3.0f : 0.0f)));
        }
    }
    std::vector<evaluate::Big> exact;
    ASSERT_TRUE(probed.Words<evaluate::Big>(inputs, &exact).ok());
    for (std::size_t i = 0; i < exact.size(); ++i) {
        EXPECT_NEAR(exact[i].ToDouble(), i / 50 % 5 == 0 ? 1.0 : 0.0, 1e-30);
    }
}

TEST(Operations, StructuresOfTwoResults) {
    const Probed probed(
        "vec4 parts(float x) { float whole; int power; float rest = modf(x, whole);\n"
        "  float significand = frexp(x, power);\n"
        "  return vec4(rest, whole, significand, float(power)); }\n",
        "parts(x)", {"float x"});
    ASSERT_EQ(probed.error(), "");
    const std::vector<float> out = probed.Floats({{5.75f, -5.75f, 1e-40f, 0.0f}});
    EXPECT_THAT(
        out, ElementsAre(0.75f, -0.75f, 1e-40f, 0.0f, 5.0f, -5.0f, -0.0f, 0.0f, 0.71875f, -0.71875f,
                         std::ldexp(1e-40f, 132), 0.0f, 3.0f, 3.0f, -132.0f, 0.0f));
}

TEST(Operations, WiderNumbersKeepWhatBinary32Loses) {
    const Probed probed("float sum(float x) { return (1.0 + x) - 1.0; }\n", "sum(x)", {"float x"});
    ASSERT_EQ(probed.error(), "");
    const Words tiny = Bits({0x1p-30f, 0x1p-70f});
    std::vector<float> binary32;
    std::vector<double> binary64;
    std::vector<evaluate::Big> big;
    ASSERT_TRUE(probed.Words<float>({tiny}, &binary32).ok());
    ASSERT_TRUE(probed.Words<double>({tiny}, &binary64).ok());
    ASSERT_TRUE(probed.Words<evaluate::Big>({tiny}, &big).ok());
    EXPECT_THAT(binary32, ElementsAre(0.0f, 0.0f));
    EXPECT_THAT(binary64, ElementsAre(0x1p-30, 0.0));
    EXPECT_EQ(big[0].ToDouble(), 0x1p-30);
    EXPECT_EQ(big[1].ToDouble(), 0x1p-70);
}

TEST(Operations, BitCastsSeeBinary32) {
    const Probed probed(
        "float third(float x) { return uintBitsToFloat(floatBitsToUint(x / 3.0)); }\n", "third(x)",
        {"float x"});
    ASSERT_EQ(probed.error(), "");
    std::vector<double> exact;
    ASSERT_TRUE(probed.Words<double>({Bits({1.0f})}, &exact).ok());
    EXPECT_THAT(exact, ElementsAre(static_cast<double>(1.0f / 3.0f)));
}

}  // namespace
}  // namespace etalon
