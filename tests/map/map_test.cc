// Whole maps, with the null devices in a driver's place.
#include "map/map.h"

#include <gmock/gmock.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;

class MapTest : public testing::Test {
  protected:
    MapTest() {
        folder_.Write("f.glsl", "float f(float a, float b) { return a + b; }\n");
        // A null device returns a.
        folder_.Write("cases/c.toml",
                      "source = \"f.glsl\"\ncall = \"f(a, b)\"\noracle = \"a\"\n"
                      "accept = { ulp = 1 }\n[domain]\n"
                      "a = { range = [0.55, 0.85], count = 9 }\n"
                      "b = { range = [0.0, 2.0], count = 9 }\n"
                      "[map]\nover = [\"a\", \"b\"]\nsize = [3, 2]\nsafe = \"b > 1\"\n"
                      "because = \"a is returned\"\n");
    }

    Result<MapRecord> Map(const std::vector<std::string>& devices, const MapScope& scope = {}) {
        MapChoice choice;
        choice.root = folder_.path();
        choice.pattern = "c";
        choice.scope = scope;
        choice.options = " --root R";
        choice.devices.patterns = devices;
        choice.devices.limits.timeout = std::chrono::milliseconds(500);
        return MakeMap(choice);
    }

    Folder folder_;
};

TEST_F(MapTest, TwoDevicesDisagreeInACell) {
    const auto map = Map({"null:echo", "null:flaw"});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(map->output, "result");
    EXPECT_EQ(map->measure, "ulp");
    EXPECT_EQ(map->tolerance, "ulp 1");
    EXPECT_THAT(map->disagreement, ElementsAre(0, 2, 0, 0, 2, 0));
    EXPECT_THAT(map->condition, Each(testing::DoubleNear(1, 1e-9)));
    ASSERT_EQ(map->devices.size(), 2u);
    EXPECT_THAT(map->devices[0].mark, Each(MapMark::kHolds));
    EXPECT_THAT(map->devices[1].mark,
                ElementsAre(MapMark::kHolds, MapMark::kRefused, MapMark::kHolds, MapMark::kHolds,
                            MapMark::kRefused, MapMark::kHolds));
    EXPECT_EQ(map->devices[1].worst->inputs[0].second.hex, "0x1.666666p-1");
    // The flaw lies in the lower row too, of which nothing is predicted.
    ASSERT_TRUE(map->prediction->contradiction);
    EXPECT_EQ(map->prediction->contradiction->repeat,
              "etalon run c --root R --device null:flaw --recipe glsl --at "
              "a=0x1.666666p-1,b=0x1.8p+0");
    EXPECT_FALSE(map->Good());
    EXPECT_THAT(ContradictionText(*map), HasSubstr("predicted to hold, and it is refused"));
    EXPECT_EQ(map->repeat, "etalon map c --root R --device null:echo --device null:flaw");
}

TEST_F(MapTest, ACrashMarksEveryCell) {
    const auto map = Map({"null:echo", "null:crash"}, {.size = "1x2"});
    ASSERT_TRUE(map) << map.error().message;
    ASSERT_EQ(map->devices.size(), 2u);
    const MappedDevice& crashed = map->devices[map->devices[0].device == "null:crash" ? 0 : 1];
    EXPECT_THAT(crashed.mark, Each(MapMark::kCrash));
    EXPECT_NE(crashed.reason, "");
    EXPECT_TRUE(map->disagreement.empty());  // nobody to disagree with
    EXPECT_FALSE(map->Good());
    EXPECT_EQ(map->prediction->agreement.size(), 1u);
    EXPECT_FALSE(map->prediction->contradiction);
}

TEST_F(MapTest, ADeviceThatCannotIsTold) {
    const auto one = Map({"null:unsupported"});
    ASSERT_FALSE(one);
    EXPECT_THAT(one.error().message, HasSubstr("null:unsupported"));
    const auto two = Map({"null:unsupported", "null:echo"});
    ASSERT_TRUE(two) << two.error().message;
    EXPECT_TRUE(two->Good());
    EXPECT_EQ(two->devices.size(), 2u);
}

// A null device returns a for the first output and b for the second, a law's right side.
TEST_F(MapTest, RunsTheBudgetsConditionAndLaws) {
    constexpr const char* kDomain =
        "[domain]\na = { range = [-2.0, 2.0], count = 9 }\nb = { range = [1.0, 3.0], count = 9 }\n";
    constexpr const char* kMap = "[map]\nover = [\"a\", \"b\"]\nsize = [2, 1]\n";
    folder_.Write("cases/c.toml",
                  "source = \"f.glsl\"\ncall = \"f(a, b)\"\noracle = \"b\"\n"
                  "accept = { ulp = 1 }\n" +
                      std::string(kDomain) + kMap + "spent = \"a > 0.0\"\n");
    const auto spent = Map({"null:echo"});
    ASSERT_TRUE(spent) << spent.error().message;
    EXPECT_THAT(spent->devices.at(0).mark, Each(MapMark::kSpent));

    folder_.Write("cases/c.toml",
                  "source = \"f.glsl\"\ncall = \"f(a, b)\"\n" + std::string(kDomain) + kMap +
                      "[[law]]\nname = \"more\"\nholds = \"f(a, b) > 5.0 * f(a, b)\"\n");
    const auto law = Map({"null:echo"});
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_EQ(law->output, "law 'more'");
    EXPECT_TRUE(law->condition.empty());
    EXPECT_THAT(law->devices.at(0).mark, Each(MapMark::kRefused));
    EXPECT_FALSE(law->prediction);
    EXPECT_TRUE(law->Good());  // without a prediction a picture is no verdict
}

TEST_F(MapTest, TheRepeatCommandHasTheScope) {
    const auto map = Map(
        {"null:echo"}, {.over = "b,a", .ranges = {"a=1:2:log"}, .size = "2x2", .output = "result"});
    ASSERT_TRUE(map) << map.error().message;
    EXPECT_EQ(map->repeat,
              "etalon map c --over b,a --range a=1:2:log --size 2x2 --output result --root R "
              "--device null:echo");
    EXPECT_TRUE(map->y.is_log);
}

}  // namespace
}  // namespace etalon
