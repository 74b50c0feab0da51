#include "map/map_plan.h"

#include <gmock/gmock.h>

#include <cmath>

#include "map/planned.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class MapPlanTest : public PlannedTest {
  protected:
    static constexpr const char* kPlain =
        "call = \"f(a, b)\"\noracle = \"a + b\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { range = [0.0, 1.0], count = 9 }\n"
        "b = { range = [1.0, 16.0], sample = \"log\", count = 9 }\n";
    static constexpr const char* kMany =
        "call = \"three(v, a, b)\"\noracle = \"v.x + a + b\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { range = [1.0, 2.0], count = 9, edges = [\"c\"] }\n"
        "v = { type = \"vec3\", values = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]] }\n"
        "b = { expr = \"2 * a + c\" }\n"
        "c = { range = [4.0, 5.0], count = 9 }\n"
        "n = { sample = \"hemisphere\", against = \"v\", count = 9 }\n"
        "where = \"a < 1.7\"\n"
        "[map]\nover = [\"c\", \"a\"]\nsize = [2, 4]\n";
};

TEST_F(MapPlanTest, CentresCellsBetweenTheirEdges) {
    const MapAxis linear = MakeMapAxis("x", {-1.0, 3.0, false}, 4);
    EXPECT_THAT(linear.edges, ElementsAre(-1, 0, 1, 2, 3));
    EXPECT_THAT(linear.values, ElementsAre(-0.5, 0.5, 1.5, 2.5));
    const MapAxis log = MakeMapAxis("x", {1.0, 16.0, true}, 2);
    EXPECT_THAT(log.edges, ElementsAre(1, 4, 16));
    EXPECT_THAT(log.values, ElementsAre(2, 8));
    // What a device sees is a float, and so is what is told.
    const MapAxis third = MakeMapAxis("x", {0.0, 1.0, false}, 3);
    EXPECT_EQ(third.values[0], static_cast<double>(static_cast<float>(1.0 / 6)));
}

TEST_F(MapPlanTest, WholeNumbersHaveACellEach) {
    const MapAxis few = MakeWholeMapAxis("n", {-1.0, 2.5, false}, 96);
    EXPECT_THAT(few.values, ElementsAre(-1, 0, 1, 2));
    EXPECT_THAT(few.edges, ElementsAre(-1.5, -0.5, 0.5, 1.5, 2.5));
    const MapAxis many = MakeWholeMapAxis("n", {1.0, 100.0, false}, 4);
    EXPECT_THAT(many.values, ElementsAre(13, 38, 63, 88));
    EXPECT_THAT(many.edges, ElementsAre(0.5, 25.5, 50.5, 75.5, 100.5));
    const MapAxis log = MakeWholeMapAxis("n", {1.0, 1024.0, true}, 12);
    EXPECT_EQ(log.values[0], 1);
    EXPECT_EQ(log.edges.size(), log.values.size() + 1);
    for (std::size_t k = 0; k < log.values.size(); ++k) {
        EXPECT_LT(log.edges[k], log.values[k]);
        EXPECT_LT(log.values[k], log.edges[k + 1]);
        EXPECT_EQ(log.values[k], std::round(log.values[k]));
    }
}

TEST_F(MapPlanTest, AnIntegerCanBeAnAxis) {
    const std::string text =
        "call = \"f(a, float(n))\"\noracle = \"a + n\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { range = [1.0, 2.0], count = 9 }\n"
        "n = { type = \"int\", range = [1, 3], count = 3 }\n"
        "u = { type = \"uint\", range = [0, 3], count = 3 }\n";
    const auto plan = Plan(text, {.over = "a,n", .size = "2x64"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->cells(), 6u);
    const Table& table = plan->prepared.table;
    EXPECT_EQ(table.columns[1].name, "n");
    EXPECT_EQ(table.At(4, 1), 3u);
    EXPECT_EQ(plan->prepared.judged.at(0).truth.values[4], 1.25 + 3);
    EXPECT_THAT(Why(text, {.over = "a,u", .ranges = {"u=-1:3"}}),
                EndsWith("'u': the range is not one of type uint"));
    EXPECT_THAT(Why(text, {.over = "a,n", .ranges = {"n=1.25:1.5"}}),
                EndsWith("'n': the range holds no whole number"));
}

TEST_F(MapPlanTest, ACellIsARow) {
    const auto plan = Plan(kPlain, {.over = "b,a", .size = "2x3"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->cells(), 6u);
    EXPECT_THAT(Cells(*plan, "b"), ElementsAre(2, 8, 2, 8, 2, 8));
    const std::vector<float> a = Cells(*plan, "a");
    EXPECT_EQ(a[0], a[1]);
    EXPECT_LT(a[1], a[2]);
    EXPECT_EQ(plan->fixed, "");
    EXPECT_EQ(plan->prepared.judged.at(0).truth.values[0], 2.0 + a[0]);
}

TEST_F(MapPlanTest, OthersAreHeldOrFollow) {
    const auto plan = Plan(kMany);
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_THAT(Cells(*plan, "c"), ElementsAre(4.25, 4.75, 4.25, 4.75, 4.25, 4.75, 4.25, 4.75));
    EXPECT_THAT(Cells(*plan, "a"),
                ElementsAre(1.125, 1.125, 1.375, 1.375, 1.625, 1.625, 1.875, 1.875));
    EXPECT_THAT(Cells(*plan, "b"), ElementsAre(6.5, 7, 7, 7.5, 7.5, 8, 8, 8.5));
    EXPECT_THAT(Cells(*plan, "v.z"), testing::Each(3.0f));
    EXPECT_THAT(Cells(*plan, "n.x"), testing::Each(testing::FloatNear(-0.26726f, 1e-5f)));
    EXPECT_EQ(plan->fixed, "v.x=1, v.y=2, v.z=3");
    // `where` leaves cells out, and no row.
    EXPECT_THAT(plan->left_out, ElementsAre(false, false, false, false, false, false, true, true));
}

TEST_F(MapPlanTest, TheUserGoesBeforeTheCase) {
    const std::string text = std::string(kMany) + "at = \"v.x=7,v.z=8\"\n";
    const auto plan = Plan(text, {.ranges = {"a=1:2"}, .at = "v.z=9,b=3", .size = "1x1"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_EQ(plan->fixed, "v.x=7, v.y=2, v.z=9, b=3");
    EXPECT_THAT(Cells(*plan, "b"), ElementsAre(3));
    EXPECT_THAT(plan->y.edges, ElementsAre(1, 2));
}

TEST_F(MapPlanTest, TakesTheDomainThatHasBothRanges) {
    const std::string text =
        "call = \"f(a, b)\"\noracle = \"a + b\"\naccept = { ulp = 1 }\n[[domain]]\n"
        "a = { range = [0.0, 1.0], count = 9 }\nb = { values = [1.0] }\n[[domain]]\n"
        "b = { range = [2.0, 4.0], count = 9 }\na = { range = [5.0, 6.0], count = 9 }\n";
    const auto plan = Plan(text, {.over = "a,b", .size = "1x1"});
    ASSERT_TRUE(plan) << plan.error().message;
    // The range of an axis is the first that the input has.
    EXPECT_THAT(Cells(*plan, "a"), ElementsAre(0.5));
    EXPECT_THAT(Cells(*plan, "b"), ElementsAre(3));
}

TEST_F(MapPlanTest, KeepsWhatIsMapped) {
    const std::string both =
        "call = \"both(a, b)\"\noracle = \"vec2(a, b)\"\naccept = { ulp = 1 }\n[domain]\n"
        "a = { range = [0.0, 1.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n"
        "[[law]]\nname = \"order\"\nholds = \"a < b\"\n"
        "[map]\nover = [\"a\", \"b\"]\nsize = [2, 2]\n";
    const auto all = Plan(both);
    ASSERT_TRUE(all) << all.error().message;
    EXPECT_EQ(all->prepared.judged.size(), 2u);
    EXPECT_TRUE(all->prepared.laws.empty());
    EXPECT_THAT(all->oracles.at(0).components, ElementsAre(0, 1));

    const auto second = Plan(both, {.output = "result.y"});
    ASSERT_TRUE(second) << second.error().message;
    EXPECT_EQ(second->prepared.judged.at(0).column, 1u);
    EXPECT_THAT(second->oracles.at(0).components, ElementsAre(1));

    const auto law = Plan(both + "output = \"order\"\n");
    ASSERT_TRUE(law) << law.error().message;
    EXPECT_TRUE(law->prepared.judged.empty());
    EXPECT_EQ(law->prepared.laws.size(), 1u);
    EXPECT_TRUE(law->oracles.empty());

    EXPECT_EQ(Why(both, {.output = "z"}),
              "--output: the case judges no 'z'; it judges 'result.x', 'result.y', 'order'");
    EXPECT_THAT(Why(both + "output = \"z\"\n"), EndsWith("c.toml:14: 'output': the case judges no "
                                                         "'z'; it judges 'result.x', 'result.y', "
                                                         "'order'"));
}

TEST_F(MapPlanTest, ReadsTheBudgetsCondition) {
    const std::string map = std::string(kPlain) + "[map]\nover = [\"a\", \"b\"]\n";
    const auto plan = Plan(map + "spent = \"f(a, b) > 3.0\"\n");
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_TRUE(plan->spent);
    EXPECT_THAT(Why(map + "spent = \"f(a, b)\"\n"), EndsWith("c.toml:10: spent: the value is no "
                                                             "bool"));
    EXPECT_THAT(Why(map + "spent = \"g(a)\"\n"), HasSubstr("c.toml:10"));
}

TEST_F(MapPlanTest, SaysWhatIsWrong) {
    EXPECT_EQ(Why(kPlain), "c: has no [map]; --over X,Y names the two inputs of one");
    EXPECT_EQ(Why(kPlain, {.over = "a"}), "--over 'a': it reads X,Y, two inputs");
    EXPECT_EQ(Why(kPlain, {.over = "a,a"}), "--over 'a,a': it reads X,Y, two inputs");
    EXPECT_THAT(Why(kPlain, {.over = "a,z"}), HasSubstr("--over: the case has no input 'z'"));
    EXPECT_EQ(Why(kMany, {.over = "a,v"}),
              "--over: 'v' is of type vec3, and a map is over floats or integers");
    EXPECT_EQ(Why(kMany, {.over = "a,b"}), "c: 'b' has no range; --range 'b=LOW:HIGH' gives one");
    for (const char* size : {"3", "3x", "x3", "0x3", "3x1025", "3x3x3", "-3x3"}) {
        EXPECT_THAT(Why(kPlain, {.over = "a,b", .size = size}), HasSubstr("it reads WIDTHxHEIGHT"));
    }
    const auto range = [&](const char* text) {
        return Why(kPlain, {.over = "a,b", .ranges = {text}});
    };
    EXPECT_THAT(range("a=1"), HasSubstr("--range 'a=1': it reads NAME=LOW:HIGH"));
    EXPECT_THAT(range("a"), HasSubstr("it reads NAME=LOW:HIGH"));
    EXPECT_THAT(range("a=1:x"), HasSubstr("'x' is not a float"));
    EXPECT_THAT(range("a=2:1"), HasSubstr("the range's ends are not in order"));
    EXPECT_THAT(range("a=0:1:log"), HasSubstr("a logarithmic range must be positive"));
    EXPECT_THAT(range("a=0:1:cube"), HasSubstr("the scale is linear or log"));
    EXPECT_THAT(range("a=0:inf"), HasSubstr("must be finite floats"));
    EXPECT_THAT(range("c=0:1"), HasSubstr("the map is over 'a' and 'b'"));
    EXPECT_EQ(Why(kPlain, {.over = "a,b", .at = "a=1"}), "--at: the map is over 'a'");
    EXPECT_EQ(Why(kMany, {.at = "n.x=1"}),
              "at: 'n' follows other inputs; give all of its components or none");
    EXPECT_THAT(Why(std::string(kMany) + "at = \"a=1\"\n"),
                EndsWith("c.toml:15: 'at': the map is over 'a'"));
    EXPECT_THAT(Why(std::string(kMany) + "at = \"q=1\"\n"),
                EndsWith("c.toml:15: 'at': the case has no input 'q'"));
    EXPECT_EQ(Why(kMany, {.ranges = {"a=1.8:1.9"}}), "c: 'where' refuses every cell of the map");
    const std::string spec =
        "call = \"f(a, b)\"\naccept = { spec = \"vulkan-1.3\" }\n[domain]\n"
        "a = { range = [0.0, 1.0], count = 9 }\nb = { range = [0.0, 1.0], count = 9 }\n";
    EXPECT_THAT(Why(spec, {.over = "a,b"}), HasSubstr("not by a specification"));
}

}  // namespace
}  // namespace etalon
