#include "case/expression.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::vector<Symbol> kSymbols = {{"x", 1}, {"y", 1}, {"v", 3}, {"w", 3}, {"q", 2}};
// x = 3, y = -0.5, v = (1, 2, 2), w = (0, 3, -4), q = (5, 12)
const double kColumns[] = {3, -0.5, 1, 2, 2, 0, 3, -4, 5, 12};

std::vector<Expression::Value> Values(const std::string& text) {
    auto expression = Expression::Parse(text);
    EXPECT_TRUE(expression) << text << ": " << expression.error().message;
    const auto components = expression->Bind(kSymbols);
    EXPECT_TRUE(components) << text << ": " << components.error().message;
    std::vector<const double*> columns;
    for (const double& value : kColumns) {
        columns.push_back(&value);
    }
    std::vector<Expression::Value> values;
    expression->Evaluate(columns, 1, values);
    EXPECT_EQ(values.size(), *components);
    return values;
}

double Value(const std::string& text) {
    const auto values = Values(text);
    EXPECT_EQ(values.size(), 1u) << text;
    return values[0].value;
}

std::vector<double> Vector(const std::string& text) {
    std::vector<double> vector;
    for (const Expression::Value& value : Values(text)) {
        vector.push_back(value.value);
    }
    return vector;
}

std::string Complaint(const std::string& text) {
    auto expression = Expression::Parse(text);
    if (!expression) {
        return expression.error().message;
    }
    const auto bound = expression->Bind(kSymbols);
    return bound ? "" : bound.error().message;
}

TEST(Expression, KnowsPrecedence) {
    EXPECT_EQ(Value("1 + 2 * 3"), 7);
    EXPECT_EQ(Value("(1 + 2) * 3"), 9);
    EXPECT_EQ(Value("8 - 3 - 2"), 3);
    EXPECT_EQ(Value("8 / 4 / 2"), 1);
    EXPECT_EQ(Value("-2^2"), -4);
    EXPECT_EQ(Value("2^3^2"), 512);
    EXPECT_EQ(Value("2^-2"), 0.25);
    EXPECT_EQ(Value("2^-22"), 0x1p-22);
    EXPECT_EQ(Value("-x - -x"), 0);
    EXPECT_EQ(Value("2 * -x^2"), -18);
    EXPECT_EQ(Value("(-2)^3"), -8);
    EXPECT_EQ(Value("1 < 2 && 3 >= 3 || 0"), 1);
    EXPECT_EQ(Value("0 && 0 || 1"), 1);
    EXPECT_EQ(Value("1 || 0 && 0"), 1);
    EXPECT_EQ(Value("!(x < y) && !0"), 1);
    EXPECT_EQ(Value("1 + 1 == 2"), 1);
    EXPECT_EQ(Value("x != 3"), 0);
    EXPECT_EQ(Value("+x"), 3);
}

TEST(Expression, ReadsNumbers) {
    EXPECT_EQ(Value("1.5e3"), 1500);
    EXPECT_EQ(Value(".25"), 0.25);
    EXPECT_EQ(Value("2."), 2);
    EXPECT_EQ(Value("0x1.8p-3"), 0.1875);
    EXPECT_EQ(Value("1e-5"), 1e-5);
    EXPECT_EQ(Values("0.5")[0].error, 0);
    EXPECT_EQ(Values("1e20")[0].error, 0);
    EXPECT_EQ(Values("1234.0625e-2 * 0 + 12.340625e2")[0].error, 0);
    EXPECT_GE(Values("0.1")[0].error, std::fabs(0.1L - static_cast<long double>(0.1)));
    EXPECT_LE(Values("0.1")[0].error, 1e-17);
    EXPECT_EQ(Value("infinity"), std::numeric_limits<double>::infinity());
    EXPECT_EQ(Value("pi"), 3.14159265358979323846);
    EXPECT_EQ(Value("e"), 2.71828182845904523536);
}

TEST(Expression, HasTheFunctionsOfGlsl) {
    EXPECT_EQ(Value("abs(y) + min(x, y) + max(x, y)"), 3);
    EXPECT_EQ(Value("clamp(x, 0, 1) + mix(2, 4, 0.25)"), 3.5);
    EXPECT_EQ(Value("sqrt(16) + inversesqrt(4)"), 4.5);
    EXPECT_EQ(Value("exp(0) + exp2(3) + log(1) + log2(8)"), 12);
    EXPECT_EQ(Value("pow(2, 10)"), 1024);
    EXPECT_NEAR(Value("sin(pi / 6) + cos(pi / 3) + tan(pi / 4)"), 2, 1e-15);
    EXPECT_NEAR(Value("asin(1) + acos(0) - 2 * atan(infinity)"), 0, 1e-15);
    EXPECT_NEAR(Value("atan(1, -1)"), 3 * std::atan(1), 1e-15);
    EXPECT_NEAR(Value("cosh(1) - sinh(1) - exp(-1) + tanh(0)"), 0, 1e-18);
    EXPECT_EQ(Value("floor(y) + ceil(y) + round(2.6) + fract(-0.25)"), -1 + 0 + 3 + 0.75);
    EXPECT_EQ(Value("mod(-1, 3) + mod(5.5, 2) + mod(7, -4)"), 2 + 1.5 - 1);
    EXPECT_EQ(Value("sign(y) + sign(0) + sign(x)"), 0);
    EXPECT_EQ(Value("step(1, x) + step(4, x)"), 1);
    EXPECT_EQ(Value("smoothstep(0, 2, 1)"), 0.5);
    EXPECT_EQ(Value("smoothstep(0, 2, 9)"), 1);
    EXPECT_EQ(Value("isnan(0 / 0) + isinf(1 / 0) + isnan(x)"), 2);
    EXPECT_EQ(Value("not(0)"), 1);
}

TEST(Expression, KnowsVectors) {
    EXPECT_EQ(Value("v.x + v.y * v.b"), 5);
    EXPECT_THAT(Vector("v.zyx"), ElementsAre(2, 2, 1));
    EXPECT_EQ(Value("v[1]"), 2);
    EXPECT_THAT(Vector("2 * v + w"), ElementsAre(2, 7, 0));
    EXPECT_THAT(Vector("-v"), ElementsAre(-1, -2, -2));
    EXPECT_EQ(Value("dot(v, w)"), -2);
    EXPECT_EQ(Value("length(v) + length(w) + length(y)"), 8.5);
    EXPECT_EQ(Value("distance(q, vec2(5, 0))"), 12);
    EXPECT_THAT(Vector("cross(vec3(1, 0, 0), vec3(0, 1, 0))"), ElementsAre(0, 0, 1));
    EXPECT_THAT(Vector("normalize(w) * 5"), ElementsAre(0, 3, -4));
    EXPECT_THAT(Vector("reflect(vec3(1, -1, 0), vec3(0, 1, 0))"), ElementsAre(1, 1, 0));
    EXPECT_THAT(Vector("vec4(q, v.xy)"), ElementsAre(5, 12, 1, 2));
    EXPECT_THAT(Vector("vec3(7)"), ElementsAre(7, 7, 7));
    EXPECT_THAT(Vector("vec3(q, 1)"), ElementsAre(5, 12, 1));
    EXPECT_EQ(Value("any(v == w)"), 0);
    EXPECT_EQ(Value("all(v >= 1) && any(v > 1)"), 1);
    EXPECT_THAT(Vector("max(v, 1.5)"), ElementsAre(1.5, 2, 2));
    EXPECT_EQ(Value("(v + w).y"), 5);
}

TEST(Expression, NamesTheColumnOfAMistake) {
    EXPECT_EQ(Complaint(""), "column 1: the expression is empty");
    EXPECT_EQ(Complaint("1 +"), "column 4: a value is missing at the end");
    EXPECT_EQ(Complaint("(1 + 2"), "column 7: ')' is missing");
    EXPECT_EQ(Complaint("1 2"), "column 3: '2' is not expected here");
    EXPECT_EQ(Complaint("1 + * 2"), "column 5: a value is missing before '*'");
    EXPECT_EQ(Complaint("1.0f"), "column 1: '1.0f' is not a number");
    EXPECT_EQ(Complaint("1 + 1.2.3"), "column 5: '1.2.3' is not a number");
    EXPECT_EQ(Complaint("0 < x < 1"), "column 7: comparisons cannot be chained; join them with &&");
    EXPECT_EQ(Complaint("x + unknown"), "column 5: 'unknown' is no input");
    EXPECT_EQ(Complaint("sqqrt(x)"),
              "column 1: there is no function 'sqqrt'; did you mean 'sqrt'?");
    EXPECT_EQ(Complaint("sqrt(x, y)"), "column 1: 'sqrt' takes 1 argument, not 2");
    EXPECT_EQ(Complaint("x + v * q"), "column 7: '*' cannot join values of 2 and 3 components");
    EXPECT_EQ(Complaint("q.z"), "column 2: 'z' does not fit a value of 2 components");
    EXPECT_EQ(Complaint("v.k"), "column 2: '.k' names no components");
    EXPECT_EQ(Complaint("v[3]"), "column 2: '3' does not fit a value of 3 components");
    EXPECT_EQ(Complaint("v[x]"), "column 2: an index is a number in [ ]");
    EXPECT_EQ(Complaint("v."), "column 2: components such as .x are missing after '.'");
    EXPECT_EQ(Complaint("cross(q, q)"), "column 1: 'cross' takes vectors of 3 components");
    EXPECT_EQ(Complaint("vec3(q)"), "column 1: 'vec3' takes 3 components, not 2");
    EXPECT_THAT(Complaint("nothing.known(x)"), StartsWith("column 1: there is no oracle 'nothing"));
    EXPECT_THAT(Complaint(std::string(5000, '(') + "1"), HasSubstr("nested too deeply"));
    EXPECT_THAT(Complaint(std::string(5000, '-') + "1"), HasSubstr("nested too deeply"));
}

TEST(Expression, ListsItsNames) {
    EXPECT_THAT(Expression::Parse("x + sin(v.y) * x - pi")->Names(), ElementsAre("x", "v"));
    EXPECT_THAT(Expression::Parse("some.oracle(a, b.x)")->Names(), ElementsAre("a", "b"));
}

TEST(Expression, StatesItsErrors) {
    EXPECT_EQ(Values("x * 2 + y")[0].error, 0) << "exact steps stay exact";
    EXPECT_EQ(Values("x - y")[0].error, 0);
    const auto third = Values("1 / x")[0];
    EXPECT_GE(third.error, std::fabs(static_cast<double>(1.0L / 3 - third.value)));
    EXPECT_LE(third.error, 0x1p-54);
    const auto cancelled = Values("(x + 2^-60 / 3) - x")[0];
    EXPECT_NEAR(cancelled.value, 0x1p-60 / 3, cancelled.error);
    EXPECT_GE(cancelled.error, 0x1p-66);
    // Undecided: 1/3 + 1/3 + 1/3 may be 1 or not.
    EXPECT_NEAR(Values("1/x + 1/x + 1/x < 1")[0].error, 1, 1e-9);
    EXPECT_EQ(Values("1/x < 0.5")[0].error, 0);
    EXPECT_EQ(Values("1 / (1/x + 1/x + 1/x - 1)")[0].error,
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(Values("sqrt(1 - 3 * (1 / x))")[0].value, 0) << "not NaN";
    EXPECT_EQ(Values("floor(x)")[0].error, 0);
    EXPECT_NEAR(Values("floor(3 * (1 / x))")[0].error, 1, 1e-9);
}

TEST(Expression, EvaluatesMoreRowsThanABlock) {
    auto expression = *Expression::Parse("vec2(x, y) * x");
    const Symbol symbols[] = {{"x", 1}, {"y", 1}};
    ASSERT_TRUE(expression.Bind(symbols));
    std::vector<double> x(1000);
    std::vector<double> y(1000);
    for (std::size_t k = 0; k < 1000; ++k) {
        x[k] = static_cast<double>(k);
        y[k] = 0.5;
    }
    const double* columns[] = {x.data(), y.data()};
    std::vector<Expression::Value> values;
    expression.Evaluate(columns, 1000, values);
    ASSERT_EQ(values.size(), 2000u);
    for (std::size_t k = 0; k < 1000; ++k) {
        EXPECT_EQ(values[k].value, x[k] * x[k]);
        EXPECT_EQ(values[1000 + k].value, x[k] * 0.5);
    }
}

TEST(Expression, CallsOracles) {
    const std::string call = "fresnel.reflectance(n, 1.5, c)";
    const Symbol symbols[] = {{"n", 1}, {"c", 1}};
    auto fast = *Expression::Parse(call);
    ASSERT_TRUE(fast.Bind(symbols));
    EXPECT_TRUE(fast.IsFast());
    auto slow = *Expression::Parse("1 * " + call);
    ASSERT_TRUE(slow.Bind(symbols));
    EXPECT_FALSE(slow.IsFast());

    const std::vector<double> n(600, 1.0);
    std::vector<double> c(600);
    for (std::size_t k = 0; k < c.size(); ++k) {
        c[k] = static_cast<double>(k + 1) / 600;
    }
    const double* columns[] = {n.data(), c.data()};
    std::vector<double> plain;
    fast.EvaluateFast(columns, c.size(), plain);
    std::vector<Expression::Value> values;
    fast.Evaluate(columns, c.size(), values);
    std::vector<Expression::Value> same;
    slow.Evaluate(columns, c.size(), same);
    EXPECT_NEAR(plain.back(), 0.04, 1e-15);
    for (std::size_t k = 0; k < c.size(); ++k) {
        EXPECT_EQ(plain[k], values[k].value);
        EXPECT_EQ(plain[k], same[k].value);
        EXPECT_GE(values[k].error, fast.relative_bound() * plain[k] + fast.absolute_bound());
    }
    EXPECT_THAT(Vector("snell.reflect(-v, vec3(0, 1, 0))"), ElementsAre(-1, 2, -2));
}

TEST(Expression, WidensAnOracleOfUncertainArguments) {
    const Symbol symbols[] = {{"n", 1}, {"c", 1}};
    const double n = 1;
    const double c = 0.25;
    const double* columns[] = {&n, &c};
    const auto evaluated = [&](const std::string& text) {
        auto expression = *Expression::Parse(text);
        EXPECT_TRUE(expression.Bind(symbols)) << text;
        std::vector<Expression::Value> values;
        expression.Evaluate(columns, 1, values);
        return std::pair(values[0], expression.IsFast());
    };
    const auto [exact, is_fast] = evaluated("fresnel.reflectance(n, 1.5, c)");
    EXPECT_TRUE(is_fast);
    const auto [moved, moved_fast] =
        evaluated("fresnel.reflectance(n, 1.5, c + (2/3 - 1/3 - 1/3))");
    EXPECT_FALSE(moved_fast);
    EXPECT_GT(moved.error, exact.error);
    EXPECT_LT(moved.error, 1e-13);
    const auto [decimal, decimal_fast] = evaluated("fresnel.reflectance(n, 1.33, c)");
    EXPECT_FALSE(decimal_fast) << "no double holds 1.33";
    EXPECT_GT(decimal.error, 0);
    const auto [wild, wild_fast] = evaluated("fresnel.reflectance(n, 1.5, sin(1e19 * (c + 1/3)))");
    EXPECT_GT(wild.error, 0.01) << "the sine may be anything";
}

TEST(Expression, RefusesWrongCallsOfOracles) {
    EXPECT_EQ(Complaint("fresnel.reflectance(x)"),
              "column 1: 'fresnel.reflectance' takes 3 arguments, not 1");
    EXPECT_EQ(Complaint("fresnel.reflectance(x, v, y)"),
              "column 24: 'fresnel.reflectance' takes 1 component for 'n2', not 3");
    EXPECT_EQ(Complaint("2 * fresnel.reflectence(x, x, y)"),
              "column 5: there is no oracle 'fresnel.reflectence'; did you mean "
              "'fresnel.reflectance'?");
    EXPECT_EQ(Complaint("fresnel.reflectance(x"), "column 22: ')' is missing");
}

TEST(Expression, OfAConstant) {
    auto constant = Expression::Constant(0.1);
    ASSERT_TRUE(constant.Bind({}));
    std::vector<Expression::Value> values;
    constant.Evaluate({}, 2, values);
    EXPECT_EQ(values[1].value, 0.1);
    EXPECT_EQ(values[1].error, 0);
    EXPECT_EQ(constant.text(), "0.1");
}

}  // namespace
}  // namespace etalon
