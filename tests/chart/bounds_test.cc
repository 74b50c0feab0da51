#include "chart/bounds.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace etalon {
namespace {

ChartPoint PointOf(const std::string& device, double cost, double worst, double p999) {
    ChartPoint point;
    point.device = device;
    point.scene = "all";
    point.cost.emplace().nanoseconds = cost;
    point.cost->low = 0.95 * cost;
    point.cost->high = 1.05 * cost;
    point.accuracy.emplace().worst = worst;
    point.accuracy->p999 = p999;
    return point;
}

const ChartBound& BoundOf(const ChartRecord& chart, const std::string& device,
                          const std::string& text, const std::string& by) {
    for (const ChartBound& bound : chart.bounds) {
        if (bound.device == device && bound.text == text && bound.by == by) {
            return bound;
        }
    }
    ADD_FAILURE() << "no bound " << text << " by " << by;
    return chart.bounds.front();
}

TEST(BoundsTest, EachDeviceHasItsOwn) {
    ChartRecord chart;
    chart.cost_by = "time";
    chart.points = {PointOf("a", 5, 1e-7, 1e-7), PointOf("a", 2, 0.5, 1e-3),
                    PointOf("a", 3, 0.6, 0.6), PointOf("b", 9, 0.25, 0.25)};
    AddFrontAndBounds(chart);
    EXPECT_TRUE(chart.points[0].front);
    EXPECT_TRUE(chart.points[1].front);
    EXPECT_FALSE(chart.points[2].front);
    EXPECT_TRUE(chart.points[3].front);
    EXPECT_EQ(chart.bounds.size(), 24u);
    EXPECT_EQ(BoundOf(chart, "a", "1", "worst").point, 1u);
    EXPECT_EQ(BoundOf(chart, "a", "1/4", "worst").point, 0u);
    EXPECT_EQ(BoundOf(chart, "a", "1/255", "p999").point, 1u);
    EXPECT_EQ(BoundOf(chart, "a", "1e-3", "p999").point, 1u);
    EXPECT_EQ(BoundOf(chart, "a", "1e-4", "p999").point, 0u);
    EXPECT_EQ(BoundOf(chart, "b", "1/4", "worst").point, 3u);
    EXPECT_EQ(BoundOf(chart, "b", "1e-6", "worst").point, std::nullopt);
}

TEST(BoundsTest, WhatIsRefusedHoldsNothing) {
    ChartRecord chart;
    chart.cost_by = "time";
    chart.points = {PointOf("a", 1, 0, 0), PointOf("a", 5, 0.5, 0.5)};
    chart.points[0].refused = true;
    AddFrontAndBounds(chart);
    EXPECT_FALSE(chart.points[0].front);
    EXPECT_TRUE(chart.points[1].front);
    EXPECT_EQ(BoundOf(chart, "a", "1", "worst").point, 1u);
}

TEST(BoundsTest, TimesWithinTheirSpreadAreAlike) {
    ChartRecord chart;
    chart.cost_by = "time";
    // Faster by chance, less accurate; then the same twice; then surely faster.
    chart.points = {PointOf("a", 10, 0.9, 0.9), PointOf("a", 10.5, 0.5, 0.5),
                    PointOf("a", 10.4, 0.5, 0.5), PointOf("a", 9, 1, 1)};
    AddFrontAndBounds(chart);
    EXPECT_FALSE(chart.points[0].front);
    EXPECT_TRUE(chart.points[1].front);
    EXPECT_TRUE(chart.points[2].front);
    EXPECT_TRUE(chart.points[3].front);
    EXPECT_EQ(BoundOf(chart, "a", "1", "worst").point, 3u);
    chart.points.pop_back();
    chart.bounds.clear();
    AddFrontAndBounds(chart);
    EXPECT_EQ(BoundOf(chart, "a", "1", "worst").point, 1u);
    chart.cost_by = "operations";
    for (std::size_t i = 0; i < chart.points.size(); ++i) {
        chart.points[i].mean.emplace().total = 10 + static_cast<double>(i);
    }
    AddFrontAndBounds(chart);
    EXPECT_TRUE(chart.points[0].front) << "counts have no spread";
}

TEST(BoundsTest, WithoutErrorsThereAreNone) {
    ChartRecord chart;
    chart.cost_by = "time";
    chart.points = {PointOf("a", 1, 0, 0), PointOf("b", 1, 0, 0)};
    chart.points[0].accuracy.reset();
    AddFrontAndBounds(chart);
    EXPECT_FALSE(chart.points[0].front);
    EXPECT_EQ(chart.bounds.size(), 12u) << "of b alone";
}

TEST(BoundsTest, WithoutTimesTheCostIsOperations) {
    ChartRecord chart;
    chart.cost_by = "operations";
    chart.points = {PointOf("a", 1, 0.5, 0.5), PointOf("a", 5, 0.5, 0.5), PointOf("a", 5, 0, 0)};
    chart.points[0].mean.emplace().total = 20;
    chart.points[1].mean.emplace().total = 10;
    AddFrontAndBounds(chart);
    EXPECT_FALSE(chart.points[0].front);
    EXPECT_TRUE(chart.points[1].front);
    EXPECT_FALSE(chart.points[2].front);  // has no cost
}

}  // namespace
}  // namespace etalon
