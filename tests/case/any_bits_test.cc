#include "case/any_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr TypeShape kFloat{Scalar::kFloat, 1, 1};
constexpr TypeShape kVector{Scalar::kFloat, 3, 1};

double Share(const ValueList& list, const std::function<bool(std::uint32_t)>& is) {
    return static_cast<double>(std::count_if(list.words.begin(), list.words.end(), is)) /
           static_cast<double>(list.words.size());
}

TEST(AnyBits, BeginsWithTheSpecialValues) {
    const ValueList list = AnyBits(kFloat, 0, 1, false);
    for (const std::uint32_t word :
         {0x00000000u, 0x80000000u, 0x00000001u, 0x007fffffu, 0x00800000u, 0x3f800000u, 0x7f7fffffu,
          0xff7fffffu, 0x7f800000u, 0xff800000u, 0x7fc00000u, 0xffc00000u, 0x7f800001u,
          0xffbfffffu}) {
        EXPECT_EQ(std::count(list.words.begin(), list.words.end(), word), 1) << std::hex << word;
    }
    EXPECT_EQ(list.size(), 14u);
    const ValueList vectors = AnyBits(kVector, 0, 1, false);
    ASSERT_EQ(vectors.size(), 14u);
    for (std::size_t k = 0; k < vectors.size(); ++k) {
        for (unsigned c = 0; c < 3; ++c) {
            EXPECT_EQ(vectors.words[3 * k + c], list.words[k]);
        }
    }
}

TEST(AnyBits, IsHalfOrdinaryAndSpreadOverAllExponents) {
    const ValueList list = AnyBits(kVector, 20000, 1, true);
    ASSERT_EQ(list.size(), 20000u);
    const auto value = [](std::uint32_t word) { return FromBits(word); };
    // Of the patterns two exponents in 256 are ordinary, 0.25 < |x| < 1, and one is not finite; of
    // the special values six of fourteen are not.
    EXPECT_NEAR(
        Share(list,
              [&](auto w) { return std::fabs(value(w)) >= 0.25f && std::fabs(value(w)) < 1; }),
        0.5 * 0.375 + 0.375 * 2 / 256, 0.01);
    EXPECT_NEAR(Share(list, [&](auto w) { return std::isnan(value(w)); }),
                0.125 * 4 / 14 + 0.375 / 256, 0.005);
    EXPECT_NEAR(Share(list, [&](auto w) { return std::fabs(value(w)) > 4; }),
                0.375 * 126 / 256 + 0.125 * 4 / 14, 0.01);
    EXPECT_NEAR(Share(list, [&](auto w) { return std::fabs(value(w)) < 0x1p-30f; }),
                0.375 * 97 / 256 + 0.125 * 5 / 14, 0.01);
    // Single bad components stand among good ones, at each place.
    for (unsigned c = 0; c < 3; ++c) {
        int single = 0;
        for (std::size_t k = 0; k < list.size(); ++k) {
            int bad = 0;
            for (unsigned other = 0; other < 3; ++other) {
                bad += std::isfinite(value(list.words[3 * k + other])) ? 0 : 1;
            }
            single += bad == 1 && !std::isfinite(value(list.words[3 * k + c])) ? 1 : 0;
        }
        EXPECT_NEAR(single / 20000.0, 0.053 * 0.897, 0.01) << c;
    }
}

TEST(AnyBits, DrawsExactlyTheCountSideBySideInRandomOrder) {
    const ValueList list = AnyBits(kFloat, 100, 1, true);
    EXPECT_EQ(list.size(), 100u);
    for (const std::uint32_t special : AnyBits(kFloat, 0, 1, false).words) {
        EXPECT_NE(std::find(list.words.begin(), list.words.end(), special), list.words.end());
    }
    const ValueList other = AnyBits(kFloat, 100, 2, true);
    EXPECT_EQ(list.words, AnyBits(kFloat, 100, 1, true).words);
    int same = 0;
    for (std::size_t k = 0; k < 100; ++k) {
        same += list.words[k] == other.words[k] ? 1 : 0;
    }
    EXPECT_LT(same, 10) << "two inputs meet their special values in the same rows";
    EXPECT_EQ(AnyBits(kFloat, 27, 1, true).size(), 27u);
    EXPECT_EQ(AnyBits(kVector, 0, 1, true).size(), 0u);
}

TEST(AnyBits, TakesIntegersAndBools) {
    const ValueList ints = AnyBits({Scalar::kInt, 1, 1}, 4000, 1, false);
    EXPECT_EQ(ints.size(), 4005u);
    EXPECT_EQ(ints.words[3], 0x7fffffffu);
    EXPECT_EQ(ints.words[4], 0x80000000u);
    EXPECT_NEAR(Share(ints,
                      [](auto w) {
                          return static_cast<std::int32_t>(w) >= -32 &&
                                 static_cast<std::int32_t>(w) < 32;
                      }),
                0.5 + 0.125 * 3 / 5, 0.03);
    const ValueList bools = AnyBits({Scalar::kBool, 2, 1}, 1000, 1, false);
    EXPECT_NEAR(Share(bools, [](auto w) { return w == 1; }), 0.5, 0.05);
    EXPECT_EQ(Share(bools, [](auto w) { return w > 1; }), 0);
}

}  // namespace
}  // namespace etalon
