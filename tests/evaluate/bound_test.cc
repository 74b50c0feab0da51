#include "evaluate/bound.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "evaluate/probed.h"

namespace etalon {
namespace {

using evaluate::Bound;

std::vector<Bound> BoundsOf(const Probed& probed, const std::vector<std::vector<float>>& inputs,
                            const std::string& profile = "vulkan-1.3",
                            evaluate::Limits limits = {}) {
    std::vector<std::uint32_t> words;
    for (const auto& column : inputs) {
        for (const float x : column) {
            words.push_back(std::bit_cast<std::uint32_t>(x));
        }
    }
    return evaluate::BoundOutputs(probed.plan(), {}, *evaluate::FindProfile(profile),
                                  static_cast<std::uint32_t>(inputs.at(0).size()), words,
                                  probed.program().output_words, limits);
}

// Of one output at one row of floats a, b, c...
Bound BoundAt(const std::string& expression, const std::vector<float>& inputs,
              const std::string& functions = "", const std::string& recipe = "spirv",
              const std::string& profile = "vulkan-1.3") {
    std::vector<std::string> names;
    std::vector<std::vector<float>> columns;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        names.push_back(std::string("float ") + static_cast<char>('a' + i));
        columns.push_back({inputs[i]});
    }
    const Probed probed(functions + "\nfloat unused() { return 0.0; }\n", expression, names,
                        recipe);
    EXPECT_EQ(probed.error(), "");
    return probed.error().empty() ? BoundsOf(probed, columns, profile).at(0) : Bound{};
}

float Next(float x, int steps) {
    for (int i = 0; i < std::abs(steps); ++i) {
        x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
    }
    return x;
}

#define EXPECT_BOUND(bound, expected_low, expected_high)                   \
    do {                                                                   \
        const Bound seen = bound;                                          \
        EXPECT_EQ(seen.kind, Bound::Kind::kNumber);                        \
        EXPECT_EQ(seen.low, expected_low) << std::hexfloat << seen.low;    \
        EXPECT_EQ(seen.high, expected_high) << std::hexfloat << seen.high; \
    } while (false)

TEST(Bound, OfOneRoundedOperationAreTheNeighbours) {
    EXPECT_BOUND(BoundAt("a + b", {1.0f, 0x1p-30f}), 1.0f, Next(1.0f, 1));
    EXPECT_BOUND(BoundAt("a - b", {1.0f, 0x1p-30f}), Next(1.0f, -1), 1.0f);
    EXPECT_BOUND(BoundAt("a * b", {1.1f, 1.3f}), 1.43f, Next(1.43f, 1));
}

TEST(Bound, OfWhatNeedsNoRoundingIsOneValue) {
    EXPECT_BOUND(BoundAt("2.0 * a + 0.5 * b", {1.0f, 3.0f}), 3.5f, 3.5f);
    EXPECT_BOUND(BoundAt("a + b - a", {8.0f, 0.125f}), 0.125f, 0.125f);
    EXPECT_BOUND(BoundAt("sum(a)", {1.0f},
                         "float sum(float x) { float s = 0.0;"
                         " for (float t = 0.0; t < 1.0; t += 0.0625) s += t * x; return s; }"),
                 7.5f, 7.5f);
}

TEST(Bound, OfSumsHoldsEveryOrder) {
    // In the order of the source 1e10 + 1 - 1e10 is 0 or 1024; rearranged it is 1.
    const Bound any_order = BoundAt("a + b - a", {1e10f, 1.0f});
    EXPECT_TRUE(any_order.Holds(std::bit_cast<std::uint32_t>(1.0f)));
    EXPECT_TRUE(any_order.Holds(std::bit_cast<std::uint32_t>(1024.0f)));
    EXPECT_TRUE(any_order.Holds(0));
    EXPECT_FALSE(any_order.Holds(std::bit_cast<std::uint32_t>(8192.0f)));
    EXPECT_BOUND(BoundAt("a + b - a", {1e10f, 1.0f}, "", "spirv+precise"), 0.0f, 1024.0f);
    // A factor taken out of x + x y is rounded where x is.
    const float x = 1.9f;
    const float y = 0x1.8p-22f;
    const Bound factored = BoundAt("a + a * b", {x, y});
    EXPECT_TRUE(factored.Holds(std::bit_cast<std::uint32_t>(x * (1.0f + y))));
    EXPECT_TRUE(factored.Holds(std::bit_cast<std::uint32_t>(x + x * y)));
}

TEST(Bound, UnderNoContractionIsNotFused) {
    const float a = 1.1f;
    const float b = 1.2f;
    const float fused = std::fma(a, b, -1.32f);
    const Bound precise = BoundAt("a * b + c", {a, b, -1.32f}, "", "spirv+precise");
    EXPECT_FALSE(precise.Holds(std::bit_cast<std::uint32_t>(fused)));
    EXPECT_TRUE(precise.Holds(std::bit_cast<std::uint32_t>(a * b + -1.32f)));
    EXPECT_TRUE(BoundAt("a * b + c", {a, b, -1.32f}).Holds(std::bit_cast<std::uint32_t>(fused)));
}

TEST(Bound, OfFunctionsIsWhatTheProfileStates) {
    EXPECT_BOUND(BoundAt("a / b", {1.5f, 1.0f}), Next(1.5f, -2), Next(1.5f, 2));
    EXPECT_BOUND(BoundAt("inversesqrt(a)", {0.25f}), Next(2.0f, -4), Next(2.0f, 2));
    EXPECT_BOUND(BoundAt("exp2(a)", {1.0f}), 2.0f - 5 * 0x1p-22f, 2.0f + 5 * 0x1p-22f);
    EXPECT_BOUND(BoundAt("sqrt(a)", {0.0f}), 0.0f, 0.0f);
    // An absolute error within [0.5, 2], three ulp outside.
    EXPECT_BOUND(BoundAt("log2(a)", {1.0f}), -0x1p-21f, 0x1p-21f);
    EXPECT_BOUND(BoundAt("log2(a)", {8.0f}), Next(3.0f, -3), Next(3.0f, 3));
    EXPECT_BOUND(BoundAt("round(a)", {2.5f}), 2.0f, 3.0f);
    EXPECT_BOUND(BoundAt("roundEven(a)", {2.5f}), 2.0f, 2.0f);
    EXPECT_BOUND(BoundAt("mod(a, b)", {7.5f, 2.0f}), 1.5f, 1.5f);
    // The quotient may be below 1, and the error counts to both sides.
    EXPECT_BOUND(BoundAt("mod(a, b)", {1.0f, 1.0f}), -1.0f, 1.0f);
    EXPECT_BOUND(BoundAt("cos(a)", {0.0f}), 1.0f - 0x1p-11f, 1.0f + 0x1p-11f);
    EXPECT_BOUND(BoundAt("max(a * b, c)", {1.1f, 1.2f, 2.0f}), 2.0f, 2.0f);
}

TEST(Bound, IsSilentWhereTheSpecificationIs) {
    const auto kind = [](const std::string& expression, float a,
                         const std::string& profile = "vulkan-1.3") {
        return BoundAt(expression, {a}, "", "spirv", profile).kind;
    };
    EXPECT_EQ(kind("sin(a)", 4.0f), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("sin(a)", 1.0f), Bound::Kind::kNumber);
    EXPECT_EQ(kind("sin(a)", 1.0f, "glsl-4.60"), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("exp(a)", 1.0f, "glsl-4.60"), Bound::Kind::kNumber);
    EXPECT_EQ(kind("1.0 / a", 0.0f), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("1.0 / a", 0x1.8p126f), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("sqrt(a)", -1.0f), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("log(a)", 0.0f), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("a + 1.0", NAN), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("min(a, 1.0)", INFINITY), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind("determinant(mat2(a, 1.0, 2.0, a))", 1.0f), Bound::Kind::kUnbounded);
}

TEST(Bound, OfAnOverflowHoldsTheLargestFloatAndTheInfinity) {
    const Bound bound = BoundAt("a * a", {1e30f});
    EXPECT_BOUND(bound, std::numeric_limits<float>::max(), INFINITY);
    EXPECT_FALSE(bound.Holds(std::bit_cast<std::uint32_t>(-INFINITY)));
    EXPECT_FALSE(bound.Holds(std::bit_cast<std::uint32_t>(NAN)));
    // One of its parts may overflow: what is then made of the infinity is open.
    EXPECT_EQ(BoundAt("a * a * b", {1e30f, 1e-30f}).kind, Bound::Kind::kUnbounded);
}

TEST(Bound, OfSubnormalNumbersHoldsZero) {
    EXPECT_BOUND(BoundAt("a * 1.0", {0x1p-130f}), 0.0f, 0x1p-130f);
    EXPECT_BOUND(BoundAt("a * b", {0x1p-100f, 0x1p-30f}), 0.0f, 0x1p-130f);
    EXPECT_BOUND(BoundAt("a * b", {0x1p-100f, 0x1p-10f}), 0x1p-110f, 0x1p-110f);
}

TEST(Bound, HoldsAProductThatUnderflowsInAnotherOrder) {
    // (a c) b is 2^-30 or so; of (a b) c the first product is subnormal.
    const Bound bound = BoundAt("a * c * b", {0x1.8p-80f, 0x1.8p-50f, 0x1p100f});
    EXPECT_TRUE(bound.Holds(0));
    EXPECT_TRUE(bound.Holds(std::bit_cast<std::uint32_t>(0x1.2p-29f)));
    EXPECT_FALSE(
        BoundAt("a * c * b", {0x1.8p-80f, 0x1.8p-50f, 0x1p100f}, "", "spirv+precise").Holds(0));
}

TEST(Bound, OfQuotientsOfSmallNumbersIsThatOfOthers) {
    const auto width = [](float a, float b) {
        const Bound bound = BoundAt("a / b", {a, b});
        return (bound.high - bound.low) / (a / b);
    };
    EXPECT_LT(width(0x1.8p-124f, 3.0f), 0x1p-20f);
    EXPECT_LT(width(0x1.8p-120f, 0x1.5p-100f), 0x1p-20f);
    // The ulp of a power of two is that of the floats below it.
    EXPECT_BOUND(BoundAt("a / b", {1.0f, 2.0f}), Next(0.5f, -2), Next(0.5f, 1));
}

TEST(Bound, IsSilentWhereTheResultIsUndefined) {
    const auto is_silent = [](const std::string& expression, const std::vector<float>& inputs) {
        return BoundAt(expression, inputs).kind == Bound::Kind::kUnbounded;
    };
    EXPECT_TRUE(is_silent("uint(a)", {-1.5f}));
    EXPECT_FALSE(is_silent("uint(a)", {-0.5f}));
    EXPECT_FALSE(is_silent("uint(a)", {3e9f}));
    EXPECT_TRUE(is_silent("int(a)", {3e9f}));
    EXPECT_TRUE(is_silent("int(a) / int(b)", {7.0f, 0.0f}));
    EXPECT_FALSE(is_silent("int(a) / int(b)", {7.0f, 2.0f}));
    EXPECT_TRUE(is_silent("uint(a) % uint(b)", {7.0f, 0.0f}));
    EXPECT_TRUE(is_silent("int(a) << int(b)", {7.0f, 32.0f}));
    EXPECT_TRUE(is_silent("int(a) >> int(b)", {7.0f, -1.0f}));
    EXPECT_FALSE(is_silent("int(a) >> int(b)", {7.0f, 31.0f}));
    EXPECT_TRUE(is_silent("bitfieldExtract(int(a), 30, int(b))", {7.0f, 3.0f}));
    EXPECT_FALSE(is_silent("bitfieldExtract(int(a), 30, int(b))", {7.0f, 2.0f}));
    EXPECT_TRUE(is_silent("bitfieldInsert(7, 7, int(a), int(b))", {-1.0f, 3.0f}));
    EXPECT_TRUE(is_silent("clamp(a, b, 1.0)", {0.0f, 2.0f}));
    EXPECT_FALSE(is_silent("clamp(a, b, 1.0)", {0.0f, 1.0f}));
    EXPECT_TRUE(is_silent("clamp(int(a), int(b), 1)", {0.0f, 2.0f}));
    EXPECT_TRUE(is_silent("smoothstep(1.0, a, b)", {0.0f, 0.5f}));
    EXPECT_TRUE(is_silent("ldexp(a, int(b))", {0x1p-100f, 150.0f}));
    const std::string unset = "float unset(float x) { float y; if (x > 2.0) y = x; return y; }";
    EXPECT_EQ(BoundAt("unset(a)", {1.0f}, unset).kind, Bound::Kind::kUnbounded);
    EXPECT_EQ(BoundAt("unset(a)", {3.0f}, unset).kind, Bound::Kind::kNumber);
    const std::string rough = "mediump float rough(mediump float x) { return x * 1.1; }";
    EXPECT_EQ(BoundAt("rough(a)", {3.0f}, rough).kind, Bound::Kind::kUnbounded);
}

TEST(Bound, OfANegativeRemainderIsOpenInGlsl) {
    const auto kind = [](float a, const std::string& profile) {
        return BoundAt("int(a) % 5", {a}, "", "spirv", profile).kind;
    };
    EXPECT_EQ(kind(-77.0f, "vulkan-1.3"), Bound::Kind::kWord);
    EXPECT_EQ(kind(-77.0f, "glsl-4.60"), Bound::Kind::kUnbounded);
    EXPECT_EQ(kind(77.0f, "glsl-4.60"), Bound::Kind::kWord);
}

TEST(Bound, HoldsWhatAnImplementationMayFlush) {
    EXPECT_TRUE(BoundAt("unpackHalf2x16(floatBitsToUint(a)).x", {0x1.8p-149f}).Holds(0));
    EXPECT_TRUE(BoundAt("ldexp(a, int(b))", {0x1p100f, -130.0f}).Holds(0));
}

TEST(Bound, TakesBothWaysOfAnUndecidedBranch) {
    EXPECT_BOUND(BoundAt("a < b ? 1.0 : 2.0", {1.0f, 2.0f}), 1.0f, 1.0f);
    // 1.1f * 1.3f lies between two floats.
    EXPECT_BOUND(BoundAt("a * b > c ? 1.0 : 2.0", {1.1f, 1.3f, 1.43f}), 1.0f, 2.0f);
    EXPECT_BOUND(BoundAt("float(int(a * b))", {1.1f, 10.0f}), 11.0f, 11.0f);
    EXPECT_BOUND(BoundAt("float(int(a * b))", {0.7f, 10.0f}), 6.0f, 7.0f);
    // A bool that may be either is not bounded; one that may not is a word.
    EXPECT_EQ(BoundAt("a * b > c", {1.1f, 1.3f, 1.43f}).kind, Bound::Kind::kUnbounded);
    const Bound decided = BoundAt("a > b", {2.0f, 1.0f});
    EXPECT_EQ(decided.kind, Bound::Kind::kWord);
    EXPECT_TRUE(decided.Holds(1));
    EXPECT_FALSE(decided.Holds(0));
}

TEST(Bound, GivesUpOnALoopThatStaysUndecided) {
    const std::string halved =
        "float halved(float x) { while (x * 0.3 > 0.0) x = x * 0.3; return x; }";
    const Probed probed(halved, "halved(a)", {"float a"});
    const auto bounds = BoundsOf(probed, {{1.0f, -1.0f}});
    EXPECT_EQ(bounds[0].kind, Bound::Kind::kUnbounded);
    // The other row is its own.
    EXPECT_BOUND(bounds[1], -1.0f, -1.0f);
}

TEST(Bound, OfBitsFollowsEachFloat) {
    EXPECT_BOUND(BoundAt("intBitsToFloat(floatBitsToInt(a * b))", {1.1f, 1.3f}), 1.43f,
                 Next(1.43f, 1));
    EXPECT_BOUND(BoundAt("unpackHalf2x16(packHalf2x16(vec2(a, b))).x", {1.1f, 2.0f}), 0x1.198p+0f,
                 0x1.19cp+0f);
}

TEST(Profile, IsFoundByItsName) {
    ASSERT_NE(evaluate::FindProfile("vulkan-1.3"), nullptr);
    EXPECT_EQ(evaluate::FindProfile("vulkan-9"), nullptr);
    for (const std::string_view name : evaluate::ProfileNames()) {
        EXPECT_EQ(evaluate::FindProfile(name)->name, name);
    }
}

TEST(Bound, OfAZeroTimesWhatOverflowsIsAnything) {
    // The product, taken into the sum, is 0 times what overflows; taken out of it, it is not there.
    EXPECT_EQ(BoundAt("(a * b + 1.0) * c", {0.0f, 1e30f, 1e30f}).kind, Bound::Kind::kUnbounded);
    EXPECT_EQ(BoundAt("a + (b * c) * d", {1.0f, 1e30f, 1e30f, 0.0f}).kind, Bound::Kind::kUnbounded);
    EXPECT_BOUND(BoundAt("a + (b * c) * d", {1.0f, 1e10f, 1e10f, 0.0f}), 1.0f, 1.0f);
}

TEST(Bound, OfAHalfAreTheNeighbours) {
    const std::string halves = "unpackHalf2x16(packHalf2x16(vec2(a, b)))";
    EXPECT_BOUND(BoundAt(halves + ".x", {1.0001f, 1.0f}), 1.0f, 1.0f + 0x1p-10f);
    EXPECT_BOUND(BoundAt(halves + ".x", {-1.0001f, 1.0f}), -1.0f - 0x1p-10f, -1.0f);
    EXPECT_BOUND(BoundAt(halves + ".x", {0x1.4p-23f, 1.0f}), 0.0f, 0x1.8p-23f);
    EXPECT_BOUND(BoundAt(halves + ".x", {0.0f, 1.0f}), 0.0f, 0.0f);
    // What overflows leaves the other half alone.
    EXPECT_BOUND(BoundAt(halves + ".y", {1e30f, 0x1p-14f}), 0x1p-14f, 0x1p-14f);
}

// A way that is run again passes what was decided before its choices, too.
TEST(Bound, OfWaysAfterADecidedBitCast) {
    const char* functions =
        "float f(float a, float b) { float y = intBitsToFloat(floatBitsToInt(a));\n"
        "  return a / 3.0 > b ? y : 2.0 * y; }\n";
    EXPECT_BOUND(BoundAt("f(a, b)", {1.0f, 1.0f / 3.0f}, functions), 1.0f, 2.0f);
}

// Integers reach the outputs by bit casts, as floats do.
TEST(Bound, OfIntegersAreTheirWords) {
    for (const float a : {-3.0f, 0.0f, 13.0f}) {
        const Bound bound = BoundAt("int(a) + 1", {a});
        EXPECT_EQ(bound.kind, Bound::Kind::kWord);
        EXPECT_EQ(static_cast<std::int32_t>(bound.word), static_cast<std::int32_t>(a) + 1);
    }
}

// The ways in which shaders keep NaN out, which no comparison of floats does.
TEST(Bound, PassesLimitsThatAreSetInBits) {
    const std::string limit =
        "float limit(float x) { return intBitsToFloat(clamp(floatBitsToInt(x), 0,"
        " floatBitsToInt(1.0))); }";
    EXPECT_BOUND(BoundAt("limit(a / b)", {1.0f, 3.0f}, limit), Next(1.0f / 3.0f, -2),
                 Next(1.0f / 3.0f, 2));
    // 0 / 0 may be anything; its limits are not.
    EXPECT_BOUND(BoundAt("limit(a / b)", {0.0f, 0.0f}, limit), 0.0f, 1.0f);
    EXPECT_BOUND(BoundAt("limit(a - b)", {1e10f, 1e10f}, limit), 0.0f, 0.0f);
    const std::string magnitude =
        "float magnitude(float x) { return intBitsToFloat(min(floatBitsToInt(x) & 0x7fffffff,"
        " floatBitsToInt(2.0))); }";
    EXPECT_BOUND(BoundAt("magnitude(a / b)", {-1.0f, 0.0f}, magnitude), 0.0f, 2.0f);
    EXPECT_BOUND(BoundAt("magnitude(a * b)", {-1.1f, 1.3f}, magnitude), 1.43f, Next(1.43f, 1));
    const std::string number =
        "float number(float x) { int bits = floatBitsToInt(x);"
        " return intBitsToFloat((bits & 0x7fffffff) > 0x7f800000 ? 0 : bits); }";
    EXPECT_BOUND(BoundAt("number(a * b)", {1.1f, 1.3f}, number), 1.43f, Next(1.43f, 1));
    EXPECT_EQ(BoundAt("number(a / b)", {0.0f, 0.0f}, number).kind, Bound::Kind::kUnbounded);
    // Where more is done with the bits than that, they are decided one by one.
    EXPECT_BOUND(BoundAt("intBitsToFloat(floatBitsToInt(a * b) + 2)", {1.1f, 1.3f}), Next(1.43f, 2),
                 Next(1.43f, 3));
    EXPECT_EQ(BoundAt("intBitsToFloat(floatBitsToInt(a / b) * 3)", {1.0f, 0.0f}).kind,
              Bound::Kind::kUnbounded);
}

TEST(Profile, BoundsAlikeWhatItDoesNotSpeakOf) {
    const auto& vulkan = *evaluate::FindProfile("vulkan-1.3");
    const auto& glsl = *evaluate::FindProfile("glsl-4.60");
    const auto alike = [&](const std::string& expression) {
        const Probed probed("float unused() { return 0.0; }", expression, {"float a"});
        return evaluate::BoundAlike(*probed.plan(), vulkan, glsl);
    };
    EXPECT_TRUE(alike("exp(a) / (1.0 + sqrt(a))"));
    EXPECT_FALSE(alike("exp(a) + sin(a)"));
    EXPECT_FALSE(alike("atan(a, 2.0)"));
}

}  // namespace
}  // namespace etalon
