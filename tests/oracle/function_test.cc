#include "oracle/function.h"

#include <gmock/gmock.h>

#include <set>

#include "bound.h"

namespace etalon::oracle {
namespace {

TEST(Functions, HaveDistinctNamesOfATopicAndAQuantity) {
    std::set<std::string_view> names;
    for (const Function& function : Functions()) {
        EXPECT_TRUE(names.insert(function.name).second) << function.name;
        EXPECT_THAT(std::string(function.name), testing::MatchesRegex("[a-z_]+\\.[a-z_]+"));
    }
    EXPECT_GT(names.size(), 0u);
}

TEST(Functions, AreCompleteAndStateABoundThatFloatsCanBeJudgedBy) {
    for (const Function& function : Functions()) {
        EXPECT_NE(function.evaluate, nullptr) << function.name;
        EXPECT_FALSE(function.parameters.empty()) << function.name;
        EXPECT_LT(function.relative_bound, std::ldexp(1, -40)) << function.name;
        EXPECT_LT(function.absolute_bound, std::ldexp(1, -40)) << function.name;
    }
}

TEST(Functions, AreFoundByName) {
    for (const Function& function : Functions()) {
        EXPECT_EQ(FindFunction(function.name), &function);
    }
    EXPECT_EQ(FindFunction("fresnel.reflectanc"), nullptr);
    EXPECT_EQ(FindFunction(""), nullptr);
}

void Half(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = 0.5 * in[0][row];
    }
}

// The comparison itself: it must see an error of twice the bound, a NaN, and a bound of nothing.
TEST(Compare, NoticesWhatItShould) {
    const Function half = {"test.half", {{"x", 1}}, 1, Half, 1e-3, 0};
    const auto truth = [](double factor) {
        return [factor](const Row& row) -> std::vector<Big> { return {Big(row[0]) * factor}; };
    };
    const std::vector<Row> rows = {{1}, {2}, {4}};
    EXPECT_EQ(Compare(half, rows, truth(0.5)).used, 0);
    EXPECT_NEAR(Compare(half, rows, truth(0.5 * 1.002)).used, 2, 0.01);
    EXPECT_EQ(Compare(half, {{std::nan("")}}, truth(0)).used, 0);
    EXPECT_EQ(
        Compare(half, rows, [](const Row&) -> std::vector<Big> { return {Big(0) / Big(0)}; }).used,
        std::numeric_limits<double>::infinity());
    Function exact = half;
    exact.relative_bound = 0;
    EXPECT_EQ(Compare(exact, rows, truth(0.5)).used, 0);
    EXPECT_EQ(Compare(exact, rows, truth(0.5000001)).used, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace etalon::oracle
