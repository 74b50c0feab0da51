// What conforming implementations return lies within the bound, and the bound is not much wider.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>

#include "evaluate/bound.h"
#include "evaluate/probed.h"
#include "evaluate/rearranged.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr std::size_t kRows = 40;
constexpr int kImplementations = 100;

float SomeInput(std::mt19937& random) {
    std::uniform_real_distribution<float> unit(-2.0f, 2.0f);
    switch (random() % 9) {
        case 0:
            return static_cast<float>(static_cast<int>(random() % 17) - 8) / 4;
        case 1:
            return std::ldexp(unit(random), static_cast<int>(random() % 60) - 30);
        case 2:
            return std::ldexp(unit(random), -120 - static_cast<int>(random() % 29));
        case 3:
            // Products of which underflow or overflow in some orders alone.
            return std::ldexp(unit(random), static_cast<int>(random() % 240) - 120);
        case 4:
            return 1 + unit(random) * 0x1p-20f;
        default:
            return unit(random);
    }
}

struct Widths {
    std::vector<double> bounds;  // in ulp
    std::vector<double> ratios;  // of the bound's width to the spread of what came
    std::uint64_t trials = 0;
    std::uint64_t unbounded = 0;

    static double Median(std::vector<double> values) {
        if (values.empty()) {
            return 0;
        }
        std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
        return values[values.size() / 2];
    }
};

void Try(const Expression& expression, std::mt19937& random, const std::string& recipe,
         Widths& widths) {
    const Probed probed(Expression::Functions(), expression.Text(),
                        {"float a", "float b", "float c", "float d"}, recipe);
    ASSERT_EQ(probed.error(), "") << expression.Text();
    std::vector<std::vector<float>> rows(kRows, std::vector<float>(Expression::kInputs));
    std::vector<std::uint32_t> words(kRows * Expression::kInputs);
    for (std::size_t row = 0; row < kRows; ++row) {
        for (std::size_t i = 0; i < Expression::kInputs; ++i) {
            rows[row][i] = i > 0 && random() % 8 == 0 ? rows[row][i - 1] : SomeInput(random);
            words[i * kRows + row] = std::bit_cast<std::uint32_t>(rows[row][i]);
        }
    }
    const auto bounds = evaluate::BoundOutputs(
        probed.plan(), {}, *evaluate::FindProfile("vulkan-1.3"), kRows, words, 1);
    for (std::size_t row = 0; row < kRows; ++row) {
        const evaluate::Bound& bound = bounds[row];
        if (bound.kind == evaluate::Bound::Kind::kUnbounded) {
            ++widths.unbounded;
            continue;
        }
        float least = INFINITY;
        float greatest = -INFINITY;
        for (int i = 0; i < kImplementations; ++i) {
            const float value =
                Implementation(random, expression, rows[row], recipe == "spirv").Run();
            ++widths.trials;
            least = std::min(least, value);
            greatest = std::max(greatest, value);
            ASSERT_TRUE(bound.Holds(std::bit_cast<std::uint32_t>(value)))
                << expression.Text() << std::hexfloat << " at " << rows[row][0] << ", "
                << rows[row][1] << ", " << rows[row][2] << ", " << rows[row][3] << ": " << value
                << " is not in [" << bound.low << ", " << bound.high << "]";
        }
        const double width = static_cast<double>(bound.high) - static_cast<double>(bound.low);
        const double spread = static_cast<double>(greatest) - static_cast<double>(least);
        widths.bounds.push_back(width / Ulp(static_cast<double>(bound.high)));
        if (spread > 0) {
            widths.ratios.push_back(width / spread);
        }
    }
}

// `trials` at least.
void TryAll(const std::string& recipe, std::uint64_t trials) {
    // The same trials each time; others by --gtest_shuffle --gtest_random_seed=N.
    const bool is_other = GTEST_FLAG_GET(shuffle);
    const int seed = is_other ? testing::UnitTest::GetInstance()->random_seed() : 0;
    std::mt19937 random(20 + static_cast<std::uint32_t>(seed));
    Widths widths;
    for (int depth = 1; depth <= 5 && !testing::Test::HasFatalFailure(); ++depth) {
        Widths here;
        while (here.trials < trials / 5 && !testing::Test::HasFatalFailure()) {
            const Expression expression(random, depth);
            Try(expression, random, recipe, here);
        }
        std::printf("depth %d: median width %.3g ulp, %.3g times the spread; %zu unbounded\n",
                    depth, Widths::Median(here.bounds), Widths::Median(here.ratios),
                    static_cast<std::size_t>(here.unbounded));
        widths.trials += here.trials;
        widths.ratios.insert(widths.ratios.end(), here.ratios.begin(), here.ratios.end());
    }
    std::printf("%llu trials, median %.3g times the spread\n",
                static_cast<unsigned long long>(widths.trials), Widths::Median(widths.ratios));
    // Four times the spread is what the bound is meant to keep to; some seeds come to a little
    // more.
    EXPECT_LT(Widths::Median(widths.ratios), is_other ? 5 : 4);
}

TEST(Soundness, HoldsAMillionRearrangedResults) {
    TryAll("spirv", 1'000'000);
}

TEST(Soundness, HoldsResultsInTheOrderOfTheSource) {
    TryAll("spirv+precise", 300'000);
}

}  // namespace
}  // namespace etalon
