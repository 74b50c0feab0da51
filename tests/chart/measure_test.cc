#include "chart/measure.h"

#include <gtest/gtest.h>

namespace etalon {
namespace {

Found FoundOf(double seconds, double operations, double worst_operations, double error) {
    Found found;
    found.recipe = "spirv";
    found.time = TimeEstimate{seconds, seconds - 1, seconds + 3, 10, "host clock"};
    CountedCall counts;
    counts.mean.arithmetic = operations;
    counts.worst.arithmetic = worst_operations;
    found.counts = counts;
    found.errors.emplace();
    found.errors->rows = 1;
    found.errors->of_rows = {error};
    found.errors->worst = error;
    return found;
}

TEST(MeasureTest, ScenesTogetherHaveTheMeanOfTheirCosts) {
    const Found all = Together({FoundOf(4, 10, 30, 0.5), FoundOf(8, 30, 20, 0.25)});
    EXPECT_EQ(all.time->seconds, 6);
    EXPECT_EQ(all.time->low, 5);
    EXPECT_EQ(all.time->high, 9);
    EXPECT_EQ(all.time->rounds, 20u);
    EXPECT_EQ(all.time->clock, "host clock");
    EXPECT_EQ(all.counts->mean.Total(), 20);
    EXPECT_EQ(all.counts->worst.Total(), 30);
    EXPECT_EQ(all.errors->rows, 2u);
    EXPECT_EQ(all.errors->worst, 0.5);
    EXPECT_EQ(all.recipe, "spirv");
    EXPECT_EQ(all.reason, "");
    EXPECT_FALSE(all.failed);
}

TEST(MeasureTest, WhatASceneLacksIsLacking) {
    Found broken = FoundOf(4, 10, 30, 0.5);
    broken.errors.reset();
    broken.time.reset();
    broken.failed = true;
    broken.AddReason("crashed");
    broken.AddReason("no time");
    const Found all = Together({FoundOf(1, 1, 1, 1), broken, FoundOf(1, 1, 1, 1)});
    EXPECT_FALSE(all.errors.has_value());
    EXPECT_FALSE(all.time.has_value());
    EXPECT_TRUE(all.counts.has_value());
    EXPECT_TRUE(all.failed);
    EXPECT_EQ(all.reason, "crashed; no time");
}

}  // namespace
}  // namespace etalon
