// What becomes of results that no device has computed.
#include "map/cells.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "map/planned.h"

namespace etalon {
namespace {

using testing::ElementsAre;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

class CellsTest : public PlannedTest {
  protected:
    // Cells along a: 0.5, 1.5, 2.5, ... as many as there are results.
    MappedDevice Judge(const std::string& keys, const std::vector<float>& results,
                       const std::vector<std::uint32_t>& spent = {}) {
        const std::string count = std::to_string(results.size());
        const auto plan =
            Plan("call = \"f(a, b)\"\n" + keys + "\n[domain]\na = { range = [0.0, " + count +
                     ".0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n",
                 {.over = "a,b", .size = count + "x1"});
        EXPECT_TRUE(plan) << plan.error().message;
        measure_ = MeasureOf(*plan);
        MapResults seen;
        seen.outputs = {Words(results)};
        seen.spent = spent;
        MappedDevice device;
        JudgeCells(*plan, seen, device);
        return device;
    }

    std::string measure_;
};

TEST_F(CellsTest, MarksNumbers) {
    const MappedDevice device = Judge("oracle = \"a\"\naccept = { absolute = 0.125 }",
                                      {0.5f, 1.5625f, 2.75f, kNan, kInfinity, -kInfinity});
    EXPECT_THAT(device.mark, ElementsAre(MapMark::kHolds, MapMark::kHolds, MapMark::kRefused,
                                         MapMark::kNan, MapMark::kInfinity, MapMark::kInfinity));
    EXPECT_EQ(measure_, "absolute");
    EXPECT_THAT(device.error, ElementsAre(0, 0.0625, 0.25, INFINITY, INFINITY, INFINITY));
    // The first of those that are infinitely far from what is allowed.
    EXPECT_EQ(device.worst->inputs.at(0).second.decimal, "3.5");
}

TEST_F(CellsTest, MeasuresAsTheCaseDoes) {
    EXPECT_EQ(
        Judge("oracle = \"a\"\naccept = { ulp = 2, absolute = 1e-9 }", {0.5f, 1.5f + 0x1p-22f})
            .error[1],
        2);
    EXPECT_EQ(measure_, "ulp");
    EXPECT_EQ(Judge("oracle = \"a\"\naccept = { relative = 0.1 }", {0.5f, 2.25f}).error[1], 0.5);
    EXPECT_EQ(measure_, "relative");
    EXPECT_EQ(Judge("oracle = \"a\"\naccept = { exact = true }", {0.5f, 2.5f}).error[1], 1);
    EXPECT_EQ(measure_, "absolute");
}

TEST_F(CellsTest, MarksSearches) {
    // The truth: a way, none from 3 on, and not known from 5 on.
    const std::string truth =
        "oracle = \"a * (1 - 2 * step(3, a)) + 0 * sqrt(5 - a)\"\n"
        "accept = { absolute = 0.25, missed = 0, wrong = 0, beyond = 1 }";
    EXPECT_THAT(Judge(truth, {0.625f, -1.0f, 3.0f, -1.0f, 2.0f, 2.0f}).mark,
                ElementsAre(MapMark::kHolds, MapMark::kMissed, MapMark::kRefused, MapMark::kHolds,
                            MapMark::kWrong, MapMark::kUndecided));
    EXPECT_THAT(Judge(truth, {kNan, 7.0f, 2.5f, kInfinity, -1.0f, kNan}).mark,
                ElementsAre(MapMark::kNan, MapMark::kWrong, MapMark::kHolds, MapMark::kInfinity,
                            MapMark::kHolds, MapMark::kUndecided));
}

TEST_F(CellsTest, TellsSpentBudgetsOfWhatIsNotAccepted) {
    const MappedDevice device = Judge("oracle = \"a\"\naccept = { absolute = 0.125 }",
                                      {0.5f, 9.0f, 9.0f, kNan}, {1, 1, 0, 1});
    EXPECT_THAT(device.mark,
                ElementsAre(MapMark::kHolds, MapMark::kSpent, MapMark::kRefused, MapMark::kNan));
}

TEST_F(CellsTest, ACellHasTheWorstOfItsOutputs) {
    const auto plan = Plan(
        "call = \"both(a, b)\"\noracle = \"vec2(a, b)\"\naccept = { absolute = 0.25 }\n[domain]\n"
        "a = { range = [0.0, 2.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n"
        "where = \"a < 2\"\n",
        {.over = "a,b", .ranges = {"a=0:3"}, .size = "3x1"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(OutputOf(*plan), "result.x, result.y");
    EXPECT_EQ(ToleranceOf(*plan), "absolute 0.25");
    MapResults results;
    results.outputs = {Words({0.5f, kNan, 0.0f}), Words({4.5f, 0.5f, 0.5f})};
    MappedDevice device;
    JudgeCells(*plan, results, device);
    EXPECT_THAT(device.mark, ElementsAre(MapMark::kRefused, MapMark::kNan, MapMark::kUndecided));
    EXPECT_EQ(device.error[0], 4);
    EXPECT_EQ(device.error[1], INFINITY);
    EXPECT_TRUE(std::isnan(device.error[2]));
    EXPECT_THAT(UndecidedCells(*plan), ElementsAre(false, false, true));
}

TEST_F(CellsTest, LawsTellByHowMuchTheyAreBroken) {
    const auto plan = Plan(
        "call = \"f(a, b)\"\n[domain]\n"
        "a = { range = [0.0, 4.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n"
        "[[law]]\nname = \"below\"\nholds = \"f(a, b) <= 1.0\"\nwithin = { absolute = 0.25 }\n",
        {.over = "a,b", .size = "4x1"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(OutputOf(*plan), "law 'below'");
    EXPECT_EQ(MeasureOf(*plan), "absolute");
    MapResults results;
    results.laws = {{Words({0.5f, 1.25f, 1.5f, kNan}), Words({1.0f, 1.0f, 1.0f, 1.0f})}};
    MappedDevice device;
    JudgeCells(*plan, results, device);
    EXPECT_THAT(device.mark,
                ElementsAre(MapMark::kHolds, MapMark::kHolds, MapMark::kRefused, MapMark::kNan));
    EXPECT_THAT(device.error, ElementsAre(0, 0.25, 0.5, INFINITY));
}

TEST_F(CellsTest, DevicesDisagree) {
    const auto plan = Plan(
        "call = \"f(a, b)\"\noracle = \"a\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { range = [0.0, 4.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n",
        {.over = "a,b", .size = "4x1"});
    ASSERT_TRUE(plan) << plan.error().message;
    std::vector<MapResults> results(3);
    results[0].outputs = {Words({1.5f, kNan, 2.0f, kNan})};
    results[1].outputs = {Words({1.5f + 0x1p-22f, kNan, 2.0f, 3.0f})};
    results[2].outputs = {Words({1.5f - 0x1p-23f, kNan, 2.0f, 3.0f})};
    EXPECT_THAT(Disagreement(*plan, {results.data(), &results[1], &results[2]}),
                ElementsAre(3, 0, 0, INFINITY));
    EXPECT_THAT(Disagreement(*plan, {results.data(), &results[2]}), ElementsAre(1, 0, 0, INFINITY));
}

}  // namespace
}  // namespace etalon
