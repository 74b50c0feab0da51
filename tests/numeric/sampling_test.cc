#include "numeric/sampling.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/ulp.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
constexpr float kNormal = std::numeric_limits<float>::min();

std::vector<std::uint32_t> Bits(const std::vector<float>& values) {
    std::vector<std::uint32_t> bits;
    for (const float value : values) {
        bits.push_back(ToBits(value));
    }
    return bits;
}

TEST(Mix, IsSplitmix64) {
    EXPECT_EQ(Mix(0, std::uint64_t{0}), 0xe220a8397b1dcdafu);
    EXPECT_EQ(Mix(0, std::uint64_t{1}), 0x6e789e6aa1b965f4u);
    EXPECT_NE(Mix(1, "x"), Mix(1, "y"));
    EXPECT_NE(Mix(1, "x"), Mix(2, "x"));
}

TEST(Strata, TakeOneSampleOutOfEach) {
    for (const Spacing spacing : {Spacing::kBits, Spacing::kLinear}) {
        const auto samples = Strata(spacing, -1, 3, 64, 5);
        ASSERT_EQ(samples.size(), 64u);
        const std::int64_t first = OrderedBits(-1);
        const double floats = static_cast<double>(OrderedBits(3) - first + 1);
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const double place = spacing == Spacing::kBits
                                     ? static_cast<double>(OrderedBits(samples[k]) - first) / floats
                                     : (samples[k] + 1.0) / 4;
            EXPECT_NEAR(place * 64, static_cast<double>(k) + 0.5, 0.5001);
        }
    }
    const auto logarithmic = Strata(Spacing::kLog, -1e6f, -1e-6f, 12, 5);
    for (std::size_t k = 0; k < 12; ++k) {
        EXPECT_NEAR(6 - std::log10(-logarithmic[k]), static_cast<double>(k) + 0.5, 0.5001);
    }
}

TEST(Strata, DependOnTheSeedAlone) {
    EXPECT_EQ(Strata(Spacing::kBits, 0, 1, 100, 3), Strata(Spacing::kBits, 0, 1, 100, 3));
    EXPECT_NE(Strata(Spacing::kBits, 0, 1, 100, 3), Strata(Spacing::kBits, 0, 1, 100, 4));
}

TEST(Strata, OfARangeWithFewFloatsStayInside) {
    const float next = std::nextafter(1.0f, 2.0f);
    for (const Spacing spacing : {Spacing::kBits, Spacing::kLinear, Spacing::kLog}) {
        for (const float sample : Strata(spacing, 1, next, 10, 1)) {
            EXPECT_TRUE(sample == 1 || sample == next);
        }
        EXPECT_THAT(Strata(spacing, 2, 2, 2, 1), ElementsAre(2, 2));
    }
}

TEST(Landmarks, AreTheEndsAndTheHardValues) {
    const float below = std::nextafter(kNormal, 0.0f);
    EXPECT_EQ(Bits(Landmarks(Spacing::kBits, 0, 1)),
              Bits({0, kSmallest, below, kNormal, std::nextafter(1.0f, 0.0f), 1}));
    EXPECT_EQ(Bits(Landmarks(Spacing::kBits, -2, 2)),
              Bits({-2, -kNormal, -below, -kSmallest, -0.0f, 0, kSmallest, below, kNormal,
                    std::nextafter(1.0f, 0.0f), 1, std::nextafter(1.0f, 2.0f), 2}));
    EXPECT_EQ(Bits(Landmarks(Spacing::kBits, -0.0f, 0)), Bits({-0.0f, 0}));
    EXPECT_EQ(Bits(Landmarks(Spacing::kBits, 1.5f, 1.5f)), Bits({1.5f}));
    EXPECT_EQ(Bits(Landmarks(Spacing::kLinear, -2, 2)), Bits({-2, 2}));
}

TEST(Neighbourhood, HasTwoFloatsOnEitherSide) {
    const float one_down = std::nextafter(1.0f, 0.0f);
    const float one_up = std::nextafter(1.0f, 2.0f);
    EXPECT_THAT(Neighbourhood(1.0 + 1e-12, 0, 4),
                ElementsAre(std::nextafter(one_down, 0.0f), one_down, 1, one_up,
                            std::nextafter(one_up, 2.0f)));
    EXPECT_THAT(Neighbourhood(1, 0, 1), ElementsAre(std::nextafter(one_down, 0.0f), one_down, 1));
    EXPECT_THAT(Neighbourhood(0, 0, 1), ElementsAre(0, kSmallest, 2 * kSmallest));
    EXPECT_THAT(Neighbourhood(5, 0, 1), IsEmpty());
    EXPECT_THAT(Neighbourhood(std::nan(""), 0, 1), IsEmpty());
    EXPECT_THAT(Neighbourhood(std::numeric_limits<double>::infinity(), 0, 1), IsEmpty());
}

TEST(Shuffle, KeepsTheValues) {
    std::vector<float> values = {1, 2, 3, 4, 5, 6, 7, 8};
    const auto before = values;
    Shuffle(values, 1);
    EXPECT_NE(values, before);
    EXPECT_THAT(values, testing::UnorderedElementsAreArray(before));
}

TEST(Direction, IsAUnitVectorAndSpreadsEvenly) {
    for (const std::size_t components : {2u, 3u}) {
        double sum[3] = {};
        const std::uint64_t count = 1000;
        for (std::uint64_t k = 0; k < count; ++k) {
            float v[3] = {};
            Direction(k, count, 7, {v, components});
            EXPECT_NEAR(std::hypot(v[0], v[1], v[2]), 1, 2e-7);
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += v[c];
            }
        }
        EXPECT_LT(std::hypot(sum[0], sum[1], sum[2]) / static_cast<double>(count), 0.01);
    }
}

TEST(OpposedDirection, NeverLooksTheSameWay) {
    for (std::uint64_t v_index = 0; v_index < 200; ++v_index) {
        float v[3];
        Direction(v_index, 200, 3, v);
        for (std::uint64_t k = 0; k < 20; ++k) {
            float n[3];
            OpposedDirection(v, k, 20, v_index, n);
            // 106 bits hold the sum of these products exactly.
            __extension__ const __float128 dot = static_cast<__float128>(v[0]) * n[0] +
                                                 static_cast<__float128>(v[1]) * n[1] +
                                                 static_cast<__float128>(v[2]) * n[2];
            EXPECT_LE(static_cast<double>(dot), 0);
            EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 2e-7);
            if (k == 0) {
                EXPECT_NEAR(static_cast<double>(dot), -1, 3e-7);
            } else if (k < kOpposedLandmarks) {
                EXPECT_NEAR(static_cast<double>(dot), k == 1 ? -1e-7 : (k == 2 ? -1e-4 : -1e-2),
                            3e-7);
            }
        }
    }
}

TEST(OpposedDirection, WorksInThePlaneAndAgainstNothing) {
    const float v[2] = {0.6f, -0.8f};
    const float zero[2] = {0, 0};
    for (std::uint64_t k = 0; k < 10; ++k) {
        float n[2];
        OpposedDirection(v, k, 10, 1, n);
        EXPECT_LE(static_cast<double>(v[0]) * n[0] + static_cast<double>(v[1]) * n[1], 0);
        OpposedDirection(zero, k, 10, 1, n);
        EXPECT_NEAR(std::hypot(n[0], n[1]), 1, 2e-7);
    }
}

}  // namespace
}  // namespace etalon
