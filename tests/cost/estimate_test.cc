#include "cost/estimate.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace etalon {
namespace {

using testing::DoubleNear;

constexpr double kFull = 5e-3;
constexpr double kLess = 1e-3;

// Rounds on a machine that slows what it runs by `noise` on average, and one in seven runs by ten
// times that much.
LoopTimes Rounds(std::size_t rounds, double noise, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::exponential_distribution<double> slower(1 / noise);
    LoopTimes times;
    for (std::size_t i = 0; i < rounds; ++i) {
        const auto run = [&](double seconds) {
            return seconds * (1 + slower(random) * (random() % 7 == 0 ? 10 : 1));
        };
        times.full.push_back(run(kFull));
        times.less.push_back(run(kLess));
    }
    return times;
}

TEST(Estimate, TakesTheLesserLoopAway) {
    const LoopTimes times{{kFull, kFull, kFull, kFull, kFull}, {kLess, kLess, kLess, kLess, 0}};
    const LoopEstimate found = Estimate(times, 1000);
    EXPECT_DOUBLE_EQ(found.seconds, 4e-6);
    EXPECT_DOUBLE_EQ(found.low, 4e-6);
    EXPECT_DOUBLE_EQ(found.high, 5e-6) << "a part whose lesser run was too short";
    EXPECT_DOUBLE_EQ(found.Spread(), 0.25);
}

TEST(Estimate, HoldsAgainstNoise) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        const LoopEstimate found = Estimate(Rounds(60, 0.02, seed), 1);
        EXPECT_THAT(found.seconds, DoubleNear(kFull - kLess, 0.03 * kFull)) << seed;
        EXPECT_LE(found.low, found.seconds);
        EXPECT_GE(found.high, found.seconds);
    }
}

TEST(Estimate, IsNotLedByASingleRun) {
    LoopTimes times = Rounds(40, 0.001);
    const double before = Estimate(times, 1).seconds;
    times.full[7] = 0;
    times.full[8] = 1e3;
    times.less[9] = 1e3;
    EXPECT_THAT(Estimate(times, 1).seconds, DoubleNear(before, 0.002 * before));
}

TEST(Estimate, TellsNoiseByItsSpread) {
    EXPECT_LT(Estimate(Rounds(60, 0.001), 1).Spread(), 0.01);
    EXPECT_GT(Estimate(Rounds(60, 0.5), 1).Spread(), 0.05);
}

TEST(Estimate, IsNeverNegative) {
    const LoopTimes times{{1, 1, 1, 1}, {2, 2, 2, 2}};
    const LoopEstimate found = Estimate(times, 1);
    EXPECT_EQ(found.seconds, 0);
    EXPECT_EQ(found.low, 0);
    EXPECT_TRUE(std::isinf(found.Spread()));
}

}  // namespace
}  // namespace etalon
