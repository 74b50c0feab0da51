#include "numeric/ulp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kLargest = std::numeric_limits<float>::max();

TEST(Ulp, IsTheDistanceOfTheFloatsAround) {
    EXPECT_EQ(Ulp(1.5), 0x1p-23);
    EXPECT_EQ(Ulp(-1.5), 0x1p-23);
    EXPECT_EQ(Ulp(1.0 + 0x1p-40), 0x1p-23);
    EXPECT_EQ(Ulp(1.0 - 0x1p-40), 0x1p-24);
    EXPECT_EQ(Ulp(1e-10), 0x1p-57);
}

TEST(Ulp, TakesTheLesserDistanceAtABinadeEdge) {
    EXPECT_EQ(Ulp(1.0), 0x1p-24);
    EXPECT_EQ(Ulp(std::nextafter(1.0, 0.0)), 0x1p-24);
    EXPECT_EQ(Ulp(0x1p-126), 0x1p-149);
    EXPECT_EQ(Ulp(0x1p-125), 0x1p-149);
    EXPECT_EQ(Ulp(std::nextafter(0x1p-125, 1.0)), 0x1p-148);
    EXPECT_EQ(Ulp(std::nextafter(0x1p-125, 0.0)), 0x1p-149);
}

TEST(Ulp, IsConstantBelowTheNormalAndBeyondTheLargestFloat) {
    for (const double x : {0.0, -0.0, 0x1p-149, 0x1p-200, 5e-324, 0x1.fp-127}) {
        EXPECT_EQ(Ulp(x), 0x1p-149) << x;
    }
    for (const double x : {0x1.000002p127, kLargest, kLargest * 2, 1e300, kInfinity, -kInfinity}) {
        EXPECT_EQ(Ulp(x), 0x1p104) << x;
    }
    EXPECT_TRUE(std::isnan(Ulp(kNan)));
}

TEST(Ulp, AgreesWithNextafterOnEveryBinade) {
    for (int exponent = -149; exponent < 127; ++exponent) {
        const float low = std::ldexp(1.0f, exponent);
        const float next = std::nextafter(low, std::numeric_limits<float>::infinity());
        const float below = std::nextafter(low, 0.0f);
        EXPECT_EQ(Ulp(low), low - static_cast<double>(below)) << exponent;
        EXPECT_EQ(Ulp(0.5 * (static_cast<double>(low) + next)), static_cast<double>(next) - low);
    }
}

TEST(UlpError, CountsFromTheTruth) {
    EXPECT_EQ(UlpError(1.0f, 1.0), 0);
    EXPECT_EQ(UlpError(1.0f + 0x1p-23f, 1.0), 2);
    EXPECT_EQ(UlpError(1.0f - 0x1p-24f, 1.0), 1);
    EXPECT_EQ(UlpError(1.0f, 1.0 + 0x1p-24), 0.5);
    EXPECT_EQ(UlpError(-0.0f, 0.0), 0);
    EXPECT_EQ(UlpError(0x1p-149f, 0.0), 1);
    EXPECT_EQ(UlpError(-1.0f, 1.0), 0x1p25);
}

TEST(UlpError, OfWhatIsNotFinite) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(UlpError(infinity, kInfinity), 0);
    EXPECT_EQ(UlpError(nan, kNan), 0);
    EXPECT_EQ(UlpError(-infinity, kInfinity), kInfinity);
    EXPECT_EQ(UlpError(infinity, kLargest), kInfinity);
    EXPECT_EQ(UlpError(1, kInfinity), kInfinity);
    EXPECT_EQ(UlpError(nan, 1), kInfinity);
    EXPECT_EQ(UlpError(1, kNan), kInfinity);
    EXPECT_EQ(UlpError(nan, kInfinity), kInfinity);
}

TEST(OrderedBits, IsMonotoneAcrossZero) {
    EXPECT_EQ(OrderedBits(0.0f), 0);
    EXPECT_EQ(OrderedBits(-0.0f), -1);
    EXPECT_EQ(OrderedBits(0x1p-149f), 1);
    EXPECT_EQ(OrderedBits(-0x1p-149f), -2);
    EXPECT_EQ(OrderedBits(1.0f) - OrderedBits(std::nextafter(1.0f, 0.0f)), 1);
    EXPECT_EQ(OrderedBits(std::numeric_limits<float>::infinity()), 0x7f800000);
    for (const float x : {0.0f, -0.0f, 1.5f, -1.5f, 0x1p-149f, -0x1p-149f, 3e38f, -3e38f}) {
        EXPECT_EQ(ToBits(FromOrderedBits(OrderedBits(x))), ToBits(x));
    }
}

TEST(Flush, TakesSubnormalsAndKeepsTheSign) {
    const float below = std::nextafter(0x1p-126f, 0.0f);
    EXPECT_EQ(ToBits(Flush(below)), ToBits(0.0f));
    EXPECT_EQ(ToBits(Flush(-below)), ToBits(-0.0f));
    EXPECT_EQ(Flush(0x1p-126f), 0x1p-126f);
    EXPECT_TRUE(std::isnan(Flush(std::numeric_limits<float>::quiet_NaN())));
    EXPECT_EQ(FlushBinary32(0x1.8p-127), 0);
    EXPECT_TRUE(std::signbit(FlushBinary32(-0x1.8p-127)));
    EXPECT_EQ(FlushBinary32(0x1p-126), 0x1p-126);
}

}  // namespace
}  // namespace etalon
