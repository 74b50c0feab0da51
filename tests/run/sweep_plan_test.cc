#include "run/sweep_plan.h"

#include <gmock/gmock.h>

#include "numeric/ulp.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SweepPlanTest : public testing::Test {
  protected:
    SweepPlanTest() {
        folder_.Write("f.glsl",
                      "float f(float a, float b, float x) { return a + b + x; }\n"
                      "float g(vec2 v, int n, float x) { return v.x + v.y + float(n) + x; }\n");
    }

    Result<SweepPlan> Plan(const std::string& keys, const SweepScope& scope) {
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\n" + keys);
        const auto source = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(source) << source.error().message;
        return PlanSweep(*source, scope);
    }
    std::string Why(const std::string& keys, const SweepScope& scope) {
        const auto plan = Plan(keys, scope);
        return plan ? "" : plan.error().message;
    }
    // A column of the settings.
    static std::vector<float> Settings(const SweepPlan& plan, std::size_t column) {
        std::vector<float> values;
        for (std::uint64_t row = 0; row < plan.settings.rows; ++row) {
            values.push_back(FromBits(plan.settings.At(row, column)));
        }
        return values;
    }

    static constexpr const char* kPlain =
        "call = \"f(a, b, x)\"\noracle = \"a + b + x\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { values = [1.0, 2.0] }\n"
        "b = { range = [1.0, 4.0], sample = \"log\", count = 50, edges = [\"a\"] }\n"
        "x = { range = [0.0, 1.0], count = 50, edges = [\"a\"] }\n";

    Folder folder_;
};

TEST_F(SweepPlanTest, HoldsTheOthersOnAGrid) {
    const auto plan = Plan(kPlain, {.over = "x"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->swept, 2u);
    EXPECT_EQ(plan->from, ToBits(0.0f));
    EXPECT_EQ(plan->to, ToBits(1.0f));
    EXPECT_THAT(Settings(*plan, 0), ElementsAre(1, 1, 1, 2, 2, 2));
    EXPECT_THAT(Settings(*plan, 1), ElementsAre(1, 2, 4, 1, 2, 4));
    EXPECT_THAT(Settings(*plan, 2), ElementsAre(0, 0, 0, 0, 0, 0));
    EXPECT_EQ(plan->fixed, "a: 2 values, b: 3 values");
    EXPECT_EQ(plan->oracles.size(), 1u);
    EXPECT_EQ(plan->oracles[0].outputs[0].name, "result");
    const auto wide = Plan(kPlain, {.over = "x", .grid = 1});
    ASSERT_TRUE(wide);
    EXPECT_THAT(Settings(*wide, 1), ElementsAre(1, 1));
}

TEST_F(SweepPlanTest, TakesWhatIsGiven) {
    // What is given has no range any more, so that one input is left to sweep.
    const auto plan = Plan(kPlain, {.from = "-0x1p-1", .to = "2", .at = "a=7,b=0.1"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->swept, 2u);
    EXPECT_EQ(plan->from, ToBits(-0.5f));
    EXPECT_EQ(plan->to, ToBits(2.0f));
    EXPECT_THAT(Settings(*plan, 0), ElementsAre(7));
    EXPECT_THAT(Settings(*plan, 1), ElementsAre(0.1f));
    EXPECT_EQ(plan->fixed, "a=7, b=0.1");
    // An input without a range, over one that is given.
    const auto other = Plan(kPlain, {.over = "a", .from = "1", .to = "1", .grid = 2});
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_EQ(other->swept, 0u);
    EXPECT_THAT(Settings(*other, 1), ElementsAre(1, 1, 4, 4));
}

TEST_F(SweepPlanTest, TakesVectorsIntegersAndTheDomainWithTheRange) {
    const std::string keys =
        "call = \"g(v, n, x)\"\noracle = \"v.x + v.y + n + x\"\naccept = { ulp = 1 }\n"
        "[[domain]]\nv = { type = \"vec2\", values = [[9, 9]] }\n"
        "n = { type = \"int\", values = [9] }\nx = { values = [9] }\n"
        "[[domain]]\nx = { range = [2, 3], count = 4 }\n"
        "n = { type = \"int\", values = [3, 4] }\nv = { type = \"vec2\", values = [[1, 2]] }\n";
    const auto plan = Plan(keys, {});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->settings.columns[plan->swept].name, "x");
    EXPECT_EQ(plan->settings.rows, 2u);
    EXPECT_EQ(plan->from, ToBits(2.0f));
    const auto given = Plan(keys, {.at = "v.y=3,n=-1,v.x=0.5"});
    ASSERT_TRUE(given) << given.error().message;
    EXPECT_THAT(given->fixed, HasSubstr("n=-1"));
    EXPECT_THAT(given->fixed, HasSubstr("v.x=0.5, v.y=3"));
    EXPECT_EQ(Why(keys, {.at = "v.x=1"}), "--at: no value for input 'v.y'");
    EXPECT_EQ(Why(keys, {.over = "n"}), "--over: 'n' is of type int, and floats are swept");
}

TEST_F(SweepPlanTest, SaysWhatIsWrong) {
    EXPECT_EQ(Why(kPlain, {}),
              "c: the inputs 'b', 'x' have a range each; --over NAME says which is swept");
    EXPECT_EQ(Why(kPlain, {.over = "y"}), "--over: the case has no input 'y'");
    EXPECT_EQ(Why(kPlain, {.over = "x", .at = "x=1"}), "--at: 'x' is the input that is swept");
    EXPECT_EQ(Why(kPlain, {.over = "a"}), "c: 'a' has no range; --from and --to give one");
    EXPECT_EQ(Why(kPlain, {.at = "x=1,b=1"}),
              "c: no float input has a range; --over NAME --from A --to B gives one");
    EXPECT_EQ(Why(kPlain, {.over = "x", .from = "2"}), "the range from 2 to 1 of 'x' is empty");
    EXPECT_EQ(Why(kPlain, {.over = "x", .from = "nan"}),
              "--from: a NaN has no place among the floats");
    EXPECT_EQ(Why(kPlain, {.over = "x", .to = "one"}), "--to: 'one' is not a float");
    const std::string head = "call = \"f(a, a, x)\"\n";
    const std::string domain = "[domain]\nx = { range = [0.0, 1.0], count = 9 }\n";
    EXPECT_THAT(Why(head + "oracle = \"x\"\naccept = { exact = true, wrong = 0.1 }\n" + domain +
                        "a = { values = [0] }\n",
                    {}),
                HasSubstr("c.toml:4: a sweep judges every value by itself, not the share"));
    EXPECT_THAT(
        Why(head + "accept = { spec = \"vulkan-1.3\" }\n" + domain + "a = { values = [0] }\n", {}),
        HasSubstr("not by a specification"));
    EXPECT_EQ(Why(head + domain +
                      "a = { values = [0] }\n[[law]]\nname = \"l\"\n"
                      "holds = \"x == x\"\nwithin = { ulp = 1 }\n",
                  {}),
              "c: has no oracle to sweep by, only laws");
    const std::string oracle = "oracle = \"a + a + x\"\naccept = { ulp = 1 }\n";
    EXPECT_EQ(Why(head + oracle + domain + "a = { expr = \"x + 1\" }\n", {}),
              "c: 'a' depends on 'x', so that it cannot be swept alone");
    EXPECT_EQ(Why(head + oracle + domain + "a = { values = [0] }\nwhere = \"x < 0.5\"\n", {}),
              "c: the condition 'where' depends on 'x', so that it cannot be swept alone");
    EXPECT_THAT(Why(head + "oracle = \"x\"\naccept = { absolute = 9 }\n" + domain +
                        "a = { values = [0] }\n",
                    {}),
                HasSubstr("nothing could fail"));
}

}  // namespace
}  // namespace etalon
