#include "map/prediction.h"

#include <gmock/gmock.h>

#include "map/planned.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class PredictionTest : public PlannedTest {
  protected:
    Result<MapPlan> PlanWith(const std::string& keys) {
        return Plan(
            "call = \"f(a, b)\"\noracle = \"a + 0 * sqrt(3 - a)\"\n"
            "accept = { absolute = 0.1, missed = 0, wrong = 0, beyond = 1 }\n[domain]\n"
            "a = { range = [0.0, 4.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n[map]\n"
            "over = [\"a\", \"b\"]\nsize = [4, 1]\nbecause = \"theory\"\n" +
            keys);
    }
    std::string WhyNot(const std::string& keys) {
        const auto plan = PlanWith(keys);
        EXPECT_TRUE(plan) << plan.error().message;
        const auto seen = Predict(*plan, true);
        return seen ? "" : seen.error().message;
    }
};

TEST_F(PredictionTest, CoversCells) {
    const auto plan = PlanWith("fails = \"a > 2\"\nsafe = \"a < 1\"\n");
    ASSERT_TRUE(plan) << plan.error().message;
    const auto seen = Predict(*plan, true);
    ASSERT_TRUE(seen) << seen.error().message;
    // The oracle knows nothing of the last cell.
    EXPECT_THAT((*seen)->cells, ElementsAre(MapForecast::kSafe, MapForecast::kOpen,
                                            MapForecast::kFails, MapForecast::kOpen));
    EXPECT_EQ((*seen)->fails, "a > 2");
    EXPECT_EQ((*seen)->because, "theory");
}

TEST_F(PredictionTest, IsOpenWhereItsOwnRoundingDecides) {
    const auto plan = PlanWith("safe = \"sqrt(a) ^ 2 <= 1.5\"\n");
    ASSERT_TRUE(plan) << plan.error().message;
    const auto seen = Predict(*plan, true);
    ASSERT_TRUE(seen) << seen.error().message;
    EXPECT_THAT((*seen)->cells, ElementsAre(MapForecast::kSafe, MapForecast::kOpen,
                                            MapForecast::kOpen, MapForecast::kOpen));
}

TEST_F(PredictionTest, MustSaySomething) {
    EXPECT_THAT(WhyNot("fails = \"a > 5\"\n"),
                EndsWith("c.toml:12: 'fails' is true in no cell of the map"));
    EXPECT_THAT(WhyNot("fails = \"a > 1\"\nsafe = \"a < 0\"\n"),
                EndsWith("c.toml:13: 'safe' is true in no cell of the map"));
    EXPECT_THAT(WhyNot("fails = \"a > 1\"\nsafe = \"a < 2\"\n"),
                HasSubstr("c.toml:12: 'fails' and 'safe' are both true at a=0x1.8p+0,"));
    // What the oracle leaves undecided cannot be predicted.
    EXPECT_THAT(WhyNot("fails = \"a > 3\"\n"), HasSubstr("'fails' is true in no cell"));
    // A part of the picture may lie on one side.
    const auto plan = PlanWith("fails = \"a > 5\"\n");
    EXPECT_TRUE(Predict(*plan, false));
}

TEST_F(PredictionTest, IsHeldAgainstEachDevice) {
    const auto plan = PlanWith("fails = \"a > 2\"\nsafe = \"a < 2\"\n");
    ASSERT_TRUE(plan) << plan.error().message;
    auto seen = Predict(*plan, true);
    ASSERT_TRUE(seen) << seen.error().message;
    PredictionSeen& prediction = **seen;
    MappedDevice device;
    device.device = "d:agrees";
    device.recipe = "spirv";
    device.mark = {MapMark::kHolds, MapMark::kHolds, MapMark::kNan, MapMark::kUndecided};
    Hold(*plan, device, "etalon run c", prediction);
    EXPECT_TRUE(prediction.agreement.at(0).Holds());
    EXPECT_FALSE(prediction.contradiction);

    device.device = "d:fails";
    device.mark = {MapMark::kHolds, MapMark::kMissed, MapMark::kHolds, MapMark::kUndecided};
    Hold(*plan, device, "etalon run c", prediction);
    const MapAgreement& agreement = prediction.agreement.at(1);
    EXPECT_FALSE(agreement.Holds());
    EXPECT_EQ(agreement.safe, 2u);
    EXPECT_EQ(agreement.safe_held, 1u);
    EXPECT_EQ(agreement.fails, 1u);
    EXPECT_EQ(agreement.failed, 0u);
    ASSERT_TRUE(prediction.contradiction);
    EXPECT_EQ(prediction.contradiction->device, "d:fails");
    EXPECT_EQ(prediction.contradiction->what, "predicted to hold, and it is missed");
    EXPECT_EQ(prediction.contradiction->repeat, "etalon run c --at a=0x1.8p+0,b=0x1p-1");

    prediction.contradiction.reset();
    device.mark = {MapMark::kHolds, MapMark::kHolds, MapMark::kHolds, MapMark::kUndecided};
    Hold(*plan, device, "etalon run c", prediction);
    EXPECT_EQ(prediction.contradiction->what, "predicted to fail, and it holds");
}

}  // namespace
}  // namespace etalon
