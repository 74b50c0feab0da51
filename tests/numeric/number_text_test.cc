#include "numeric/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

std::string Parsed(Scalar scalar, std::string_view text) {
    const auto word = ParseWord(scalar, text);
    return word ? WordText(scalar, *word) : word.error().message;
}

TEST(NumberText, ReadsFloats) {
    EXPECT_EQ(Parsed(Scalar::kFloat, " 1.5 "), "1.5");
    EXPECT_EQ(Parsed(Scalar::kFloat, "+.5"), "0.5");
    EXPECT_EQ(Parsed(Scalar::kFloat, "1e3"), "1000");
    EXPECT_EQ(Parsed(Scalar::kFloat, "-0"), "-0");
    EXPECT_EQ(Parsed(Scalar::kFloat, "0x1.8p-3"), "0.1875");
    EXPECT_EQ(Parsed(Scalar::kFloat, "-0X1.8P+1"), "-3");
    EXPECT_EQ(Parsed(Scalar::kFloat, "0xff"), "255");
    EXPECT_EQ(Parsed(Scalar::kFloat, "nan"), "nan");
    EXPECT_EQ(Parsed(Scalar::kFloat, "-nan"), "nan");
    EXPECT_EQ(Parsed(Scalar::kFloat, "inf"), "inf");
    EXPECT_EQ(Parsed(Scalar::kFloat, "-inf"), "-inf");
}

TEST(NumberText, RefusesWhatIsNoFloat) {
    for (
        const char* text :
        {"",    " ",        "abc",    "1.0f", "1,5",          "0x",          "--1",           "+-1",
         "1 2", "infinity", "nan(1)", "nan:", "nan:7f800000", "nan:7f80001", "-nan:7f800001", "1e",
         "NaN", "-",        ".",      "e5",   "0x0x1",        "0x-1"}) {
        EXPECT_NE(Parsed(Scalar::kFloat, text).find("is not a float"), std::string::npos) << text;
    }
    EXPECT_EQ(Parsed(Scalar::kFloat, "abc"), "'abc' is not a float");
}

TEST(NumberText, RoundsOnceAndKnowsItsLimits) {
    // Just above the tie of 1 and its neighbour: a detour over binary64 would round to the tie
    // first.
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "1.000000059604644775390626"), ToBits(1.0f) + 1);
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "1.000000059604644775390625"), ToBits(1.0f));
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "3.4028235e38"), 0x7f7fffffu);
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "1e-45"), 1u);
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "1e-40"), ToBits(1e-40f));
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "0x1p-149"), 1u);
    EXPECT_EQ(*ParseWord(Scalar::kFloat, "0x1.8p-148"), 3u);
    for (const char* tiny : {"1e-46", "1e-400", "0x1p-160", "0x1p-2000", "1e-99999999999999999999",
                             "0.000000000000000000000000000000000000000000000000000001", "0e99"}) {
        EXPECT_EQ(Parsed(Scalar::kFloat, tiny), "0") << tiny;
    }
    EXPECT_EQ(Parsed(Scalar::kFloat, "-1e-400"), "-0");
    for (const char* huge :
         {"3.5e38", "1e39", "-1e400", "0x1p128", "0x1.ffffffp127", "1e99999999999999999999",
          "100000000000000000000000000000000000000000"}) {
        EXPECT_NE(Parsed(Scalar::kFloat, huge).find("does not fit a float"), std::string::npos)
            << huge << ": " << Parsed(Scalar::kFloat, huge);
    }
}

TEST(NumberText, ReadsIntegersAndBools) {
    EXPECT_EQ(*ParseWord(Scalar::kInt, "-2147483648"), 0x80000000u);
    EXPECT_EQ(*ParseWord(Scalar::kInt, "0x7fffffff"), 0x7fffffffu);
    EXPECT_EQ(*ParseWord(Scalar::kUint, "0xffffffff"), 0xffffffffu);
    EXPECT_EQ(Parsed(Scalar::kInt, "-12"), "-12");
    EXPECT_EQ(Parsed(Scalar::kUint, "4294967295"), "4294967295");
    EXPECT_EQ(Parsed(Scalar::kBool, "true"), "true");
    EXPECT_EQ(Parsed(Scalar::kBool, "0"), "false");
    EXPECT_EQ(Parsed(Scalar::kInt, "2147483648"), "'2147483648' does not fit an int");
    EXPECT_EQ(Parsed(Scalar::kInt, "0x80000000"), "'0x80000000' does not fit an int");
    EXPECT_EQ(Parsed(Scalar::kUint, "-1"), "'-1' does not fit a uint");
    EXPECT_EQ(Parsed(Scalar::kUint, "99999999999999999999999"),
              "'99999999999999999999999' does not fit a uint");
    EXPECT_EQ(Parsed(Scalar::kInt, "1.5"), "'1.5' is not an int");
    EXPECT_EQ(Parsed(Scalar::kUint, ""), "'' is not a uint");
    EXPECT_EQ(Parsed(Scalar::kBool, "2"), "'2' is not a bool");
}

TEST(NumberText, EveryFloatReadsBackToItsBits) {
    for (std::uint64_t k = 0; k < 200000; ++k) {
        const auto word = static_cast<std::uint32_t>(Mix(1, k));
        const float value = FromBits(word);
        if (std::isnan(value)) {
            continue;
        }
        ASSERT_EQ(*ParseWord(Scalar::kFloat, WordText(Scalar::kFloat, word)), word);
        ASSERT_EQ(*ParseWord(Scalar::kFloat, HexFloat(value)), word) << HexFloat(value);
        ASSERT_EQ(ToBits(std::strtof(HexFloat(value).c_str(), nullptr)), word);
    }
}

TEST(NumberText, KeepsTheBitsOfANan) {
    EXPECT_EQ(ExactText(Scalar::kFloat, 0x7fc00000), "nan");
    EXPECT_EQ(ExactText(Scalar::kFloat, 0xffc00000), "-nan");
    EXPECT_EQ(ExactText(Scalar::kFloat, 0x7f800001), "nan:7f800001");
    EXPECT_EQ(ExactText(Scalar::kFloat, ToBits(-1.5f)), "-1.5");
    EXPECT_EQ(ExactText(Scalar::kUint, 0x7f800001), "2139095041");
    for (const std::uint32_t word : {0x7fc00000u, 0xffc00000u, 0x7f800001u, 0xffffffffu}) {
        EXPECT_EQ(*ParseWord(Scalar::kFloat, ExactText(Scalar::kFloat, word)), word);
    }
}

TEST(NumberText, WritesHexadecimalFloats) {
    EXPECT_EQ(HexFloat(0.1875f), "0x1.8p-3");
    EXPECT_EQ(HexFloat(-0.0f), "-0x0p+0");
    EXPECT_EQ(HexFloat(0x1p-149f), "0x1p-149");
    EXPECT_EQ(HexFloat(std::numeric_limits<float>::quiet_NaN()), "nan");
    EXPECT_EQ(HexFloat(-std::numeric_limits<double>::infinity()), "-inf");
    EXPECT_EQ(HexFloat(0.1), "0x1.999999999999ap-4");
    EXPECT_EQ(Shortest(0.1), "0.1");
    EXPECT_EQ(Shortest(-std::numeric_limits<double>::quiet_NaN()), "nan");
    EXPECT_EQ(Shortest(1e-9), "1e-09");
}

TEST(NumberText, NamesTheScalars) {
    for (const Scalar scalar : {Scalar::kFloat, Scalar::kInt, Scalar::kUint, Scalar::kBool}) {
        EXPECT_EQ(ScalarFromName(ScalarName(scalar)), scalar);
    }
    EXPECT_FALSE(ScalarFromName("double"));
    EXPECT_EQ(WordValue(Scalar::kInt, 0xffffffffu), -1);
    EXPECT_EQ(WordValue(Scalar::kUint, 0xffffffffu), 4294967295.0);
    EXPECT_EQ(WordValue(Scalar::kBool, 7), 1);
    EXPECT_EQ(WordValue(Scalar::kFloat, ToBits(0.5f)), 0.5);
}

}  // namespace
}  // namespace etalon
