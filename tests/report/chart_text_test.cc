#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "report/chart_record.h"

namespace etalon {
namespace {

using testing::HasSubstr;

ChartPoint PointOf(const std::string& label, const std::string& scene, double nanoseconds,
                   double worst) {
    ChartPoint point;
    point.member = point.label = label;
    point.scene = scene;
    point.device = "vulkan:d";
    point.recipe = "spirv";
    ChartCost cost;
    cost.nanoseconds = nanoseconds;
    cost.ratio = ChartCost::Ratio{nanoseconds / 2, nanoseconds / 2 - 0.01, nanoseconds / 2 + 0.25};
    point.cost = cost;
    ChartAccuracy accuracy;
    accuracy.rows = accuracy.judged = 100;
    accuracy.worst = worst;
    accuracy.p999 = worst / 2;
    accuracy.rms = worst / 4;
    accuracy.bits = 3.25;
    point.accuracy = accuracy;
    point.mean.emplace().total = 12.5;
    point.mean->fetch = 2;
    point.worst = point.mean;
    return point;
}

ChartRecord ChartOfThree() {
    ChartRecord chart;
    chart.family = "optics/x";
    chart.quantity = "light";
    chart.measure = "absolute";
    chart.unit = "texels";
    chart.reference = "exact";
    chart.cost_by = "time";
    chart.scenes = {{"", ""}};
    chart.devices.emplace_back().name = "vulkan:d";
    chart.points = {PointOf("exact", "all", 2, 1e-7), PointOf("rough", "all", 1, 0.25),
                    PointOf("broken", "all", 0.5, 3)};
    chart.points[0].front = chart.points[1].front = true;
    chart.points[0].accuracy->bits = std::numeric_limits<double>::infinity();
    chart.points[2].refused = true;
    chart.points[2].accuracy->refused = 7;
    chart.points[2].accuracy->not_finite = 3;
    chart.points[1].published_ratio = 0.75;
    ChartPoint absent = PointOf("absent", "all", 0, 0);
    absent.accuracy.reset();
    absent.cost.reset();
    absent.mean.reset();
    absent.reason = "crashed";
    chart.points.insert(chart.points.begin(), absent);
    chart.bounds = {{"vulkan:d", "all", 1, "1", "worst", 2},
                    {"vulkan:d", "all", 1, "1", "p999", 2},
                    {"vulkan:d", "all", 1e-6, "1e-6", "worst", 1},
                    {"vulkan:d", "all", 1e-6, "1e-6", "p999", std::nullopt}};
    return chart;
}

TEST(ChartTextTest, ALineForEachPointByCost) {
    EXPECT_EQ(ChartText(ChartOfThree(), false),
              R"(optics/x: light
  errors    absolute, texels
  times     over that of 'exact'
  marks     * on the front of cost and worst error, ! refused by the family's 'accept'

vulkan:d (spirv)
                time  operations  fetches  worst  99.9 %      rms   bits  published  member
!  0.25 (0.24..0.50)        12.5        2      3     1.5     0.75    3.2          -  broken  (3 of 100 rows not finite; 7 values refused)
*  0.50 (0.49..0.75)        12.5        2   0.25   0.125   0.0625    3.2       0.75  rough
*  1.00 (0.99..1.25)        12.5        2  1e-07   5e-08  2.5e-08  exact          -  exact
                   -           -        -      -       -        -      -          -  absent  (crashed)

error up to  cheapest by its worst  cheapest by 99.9 % of the rows
          1  0.50  rough            0.50  rough
       1e-6  1.00  exact            none
)");
}

TEST(ChartTextTest, WhatIsNotToldFromNothingIsABound) {
    ChartRecord chart = ChartOfThree();
    chart.points[2].cost->ratio = ChartCost::Ratio{0, 0, 0.034};
    chart.points[2].accuracy->bits = -0.01;
    chart.points[3].cost->ratio = ChartCost::Ratio{0, 0, 0};
    const std::string text = ChartText(chart, false);
    EXPECT_THAT(text, HasSubstr("!         under 0.01 "));
    EXPECT_THAT(text, HasSubstr("*         under 0.04 "));
    EXPECT_THAT(text, HasSubstr("  under 0.04  rough "));
    EXPECT_THAT(text, HasSubstr("  0.0       0.75  rough\n")) << "no -0.0";
}

TEST(ChartTextTest, WithoutATimeOfTheReferenceTimesAreNanoseconds) {
    ChartRecord chart = ChartOfThree();
    chart.points[2].cost = ChartCost{3.25, 3, 4, std::nullopt, 4, "processor time"};
    EXPECT_THAT(ChartText(chart, false), HasSubstr("  3.25 (3.00..4.00) ns  "));
}

TEST(ChartTextTest, ScenesStandBeforeAllWhereTheyAreAskedFor) {
    ChartRecord chart = ChartOfThree();
    chart.search = true;
    chart.points[2].accuracy->missed = 0.005;
    chart.points[2].accuracy->wrong = 0.03;
    chart.scenes = {{"sine", "four periods"}, {"plane", ""}};
    chart.points.push_back(PointOf("exact", "sine", 2, 1));
    const std::string compact = ChartText(chart, false);
    EXPECT_THAT(compact, HasSubstr("\nvulkan:d (spirv), all 2 scenes\n"));
    EXPECT_THAT(compact, testing::Not(HasSubstr("sine")));
    EXPECT_THAT(compact, HasSubstr("  missed  wrong  published  member\n"));
    EXPECT_THAT(compact, HasSubstr("  errors    absolute, texels, of right hits\n"));
    EXPECT_THAT(compact, HasSubstr("cheapest by 99.9 % of its right hits\n"));
    EXPECT_THAT(compact, HasSubstr("  0.50  rough (0.5 % missed, 3 % wrong)  "));
    const std::string full = ChartText(chart, true);
    EXPECT_THAT(full, HasSubstr("\nvulkan:d (spirv), scene 'sine'\n"));
    EXPECT_LT(full.find("scene 'sine'"), full.find("all 2 scenes"));
}

TEST(ChartTextTest, WithoutTimesCostIsOperations) {
    ChartRecord chart = ChartOfThree();
    chart.cost_by = "operations";
    chart.points[2].mean->total = 10;
    const std::string text = ChartText(chart, false);
    EXPECT_THAT(text, HasSubstr("  cost      operations of a call\n"));
    EXPECT_THAT(text, testing::Not(HasSubstr("time")));
    EXPECT_LT(text.find(" rough\n"), text.find(" exact\n"));
    EXPECT_THAT(text, HasSubstr("          1  10  rough "));
}

TEST(ChartTextTest, AtOneInputItTellsTheValues) {
    ChartRecord chart = ChartOfThree();
    chart.at = "x=1";
    Observation& shown = chart.points[1].accuracy->shown.emplace();
    shown.output = "result";
    shown.actual = {"0.5", "0x1p-1"};
    shown.expected = Value{"0.25", "0x1p-2"};
    const std::string text = ChartText(chart, false);
    EXPECT_THAT(text, HasSubstr("  at        x=1\n"));
    EXPECT_THAT(text, HasSubstr("\nexact, result\n  actual    0.5 = 0x1p-1\n"
                                "  expected  0.25 = 0x1p-2\n"));
    EXPECT_THAT(text, testing::Not(HasSubstr("error up to")));
}

TEST(ChartTextTest, WithoutErrorsThereAreNoColumnsForThem) {
    ChartRecord chart = ChartOfThree();
    for (ChartPoint& point : chart.points) {
        point.accuracy.reset();
    }
    chart.bounds.clear();
    const std::string text = ChartText(chart, false);
    EXPECT_THAT(text, testing::Not(HasSubstr("99.9 %  ")));
    EXPECT_THAT(text, testing::Not(HasSubstr("error")));
    EXPECT_LT(text.find(" rough\n"), text.find(" broken\n")) << "in the family's order";
}

}  // namespace
}  // namespace etalon
