// Condition numbers against closed forms.
#include "map/condition.h"

#include <gmock/gmock.h>

#include <cmath>

#include "map/planned.h"

namespace etalon {
namespace {

using testing::DoubleNear;
using testing::Each;

class ConditionTest : public PlannedTest {
  protected:
    std::vector<double> Of(const std::string& oracle, const std::string& more = "") {
        const auto plan =
            Plan("call = \"f(a, b)\"\noracle = \"" + oracle +
                     "\"\naccept = { ulp = 1 }\n[domain]\na = { range = [0.0, 2.0], count = 9 }\n"
                     "b = { range = [0.5, 4.0], count = 9 }\n" +
                     more,
                 {.over = "a,b", .size = "8x7"});
        EXPECT_TRUE(plan) << plan.error().message;
        a_ = Cells(*plan, "a");
        b_ = Cells(*plan, "b");
        return ConditionNumbers(*plan);
    }

    std::vector<float> a_;
    std::vector<float> b_;
};

TEST_F(ConditionTest, OfPowers) {
    EXPECT_THAT(Of("a^3 / b^2"), Each(DoubleNear(5, 1e-9)));
    EXPECT_THAT(Of("7"), Each(0.0));
}

// An integer is not rounded.
TEST_F(ConditionTest, OfFloatsAlone) {
    const std::string text =
        "call = \"f(float(n), b)\"\noracle = \"n^5 * b^3 * m\"\naccept = { ulp = 1 }\n[domain]\n"
        "n = { type = \"int\", range = [1, 9], count = 9 }\n"
        "m = { type = \"int\", range = [1, 9], count = 9 }\n"
        "b = { range = [0.5, 4.0], count = 9 }\n";
    const auto one = Plan(text, {.over = "n,b", .size = "3x2"});
    ASSERT_TRUE(one) << one.error().message;
    EXPECT_THAT(ConditionNumbers(*one), Each(DoubleNear(3, 1e-9)));
    const auto none = Plan(text, {.over = "n,m"});
    ASSERT_TRUE(none) << none.error().message;
    EXPECT_TRUE(ConditionNumbers(*none).empty());
}

TEST_F(ConditionTest, OfADifference) {
    const std::vector<double> condition = Of("a - b * 1.0931");
    for (std::size_t cell = 0; cell < condition.size(); ++cell) {
        const double a = a_[cell];
        const double b = 1.0931 * b_[cell];
        const double expected = (a + b) / std::fabs(a - b);
        EXPECT_NEAR(condition[cell] / expected, 1, 1e-8) << a << " " << b;
    }
}

TEST_F(ConditionTest, OfACosineNearItsZero) {
    const std::vector<double> condition = Of("cos(a)");
    for (std::size_t cell = 0; cell < condition.size(); ++cell) {
        const double a = a_[cell];
        EXPECT_NEAR(condition[cell], std::fabs(a * std::tan(a)), 1e-6 * condition[cell]);
    }
}

TEST_F(ConditionTest, InputsFollow) {
    EXPECT_THAT(Of("a * c", "c = { expr = \"a^2 * b\" }\n"), Each(DoubleNear(4, 1e-9)));
}

TEST_F(ConditionTest, OneSidedAtTheEndOfTheOracle) {
    // Beyond a = 1 there is no value: 0.5 / sqrt from one side, NaN where there is none.
    const std::vector<double> condition = Of("sqrt(1 - a) * 1");
    for (std::size_t cell = 0; cell < condition.size(); ++cell) {
        const double a = a_[cell];
        if (a < 1) {
            EXPECT_NEAR(condition[cell], 0.5 * a / (1 - a), 1e-5);
        } else {
            EXPECT_TRUE(std::isnan(condition[cell]));
        }
    }
}

TEST_F(ConditionTest, InfiniteAtAZero) {
    EXPECT_THAT(Of("floor(a * 0) * b"), Each(0.0));
    const std::vector<double> condition = Of("a - 0.125");
    EXPECT_EQ(a_[0], 0.125f);
    EXPECT_EQ(condition[0], INFINITY);
}

TEST_F(ConditionTest, NoneWithoutAnOracle) {
    const auto plan = Plan(
        "call = \"f(a, b)\"\n[domain]\na = { range = [0.0, 2.0], count = 9 }\n"
        "b = { range = [0.5, 4.0], count = 9 }\n[[law]]\nname = \"l\"\nholds = \"a < b\"\n",
        {.over = "a,b", .size = "8x7"});
    ASSERT_TRUE(plan) << plan.error().message;
    EXPECT_TRUE(ConditionNumbers(*plan).empty());
}

}  // namespace
}  // namespace etalon
