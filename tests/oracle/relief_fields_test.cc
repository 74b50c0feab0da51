#include "oracle/relief_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "relief_rays.h"

namespace etalon::oracle {
namespace {

double SteepestOf(const HeightField& field) {
    double steepest = 0;
    for (int j = 0; j < field.size(); ++j) {
        for (int i = 0; i < field.size(); ++i) {
            const double low = field.Texel(i, j);
            const double x = field.Texel(i + 1, j) - low;
            const double y = field.Texel(i, j + 1) - low;
            const double far_x = field.Texel(i + 1, j + 1) - field.Texel(i, j + 1);
            const double far_y = field.Texel(i + 1, j + 1) - field.Texel(i + 1, j);
            steepest = std::max({steepest, std::hypot(x, y), std::hypot(far_x, y),
                                 std::hypot(x, far_y), std::hypot(far_x, far_y)});
        }
    }
    return steepest;
}

TEST(ReliefFields, HoldMultiplesOfTheUnitWithinTheBox) {
    for (const HeightField& field : HeightFields()) {
        for (int j = 0; j < field.size(); ++j) {
            for (int i = 0; i < field.size(); ++i) {
                const double height = field.Texel(i, j);
                ASSERT_EQ(std::floor(height * 4096), height * 4096) << field.name();
                ASSERT_LE(std::fabs(height), 0.5) << field.name();
                ASSERT_EQ(field.Texel(i - field.size(), j + 3 * field.size()), height);
            }
        }
    }
}

TEST(ReliefFields, AreAsSteepAsStated) {
    const std::map<std::string_view, double> stated = {
        {"smooth", 0.066},   {"bricks", 0.53},     {"noise", 0.13},        {"ridges", 1.13},
        {"steps", 0.11},     {"flat", 0},          {"plane", 0},           {"ramp", 0.013},
        {"sine_one", 0.020}, {"sine_four", 0.078}, {"sine_sixteen", 0.28}, {"cap", 0.075},
        {"ripples", 0.004}};
    for (const HeightField& field : HeightFields()) {
        const auto found = stated.find(field.name());
        if (found != stated.end()) {
            EXPECT_NEAR(SteepestOf(field), found->second, 0.005) << field.name();
        }
    }
}

TEST(ReliefFields, LevelsLieBetweenTheSamplesOfEqualSteps) {
    for (const HeightField& field : HeightFields()) {
        if (field.name() == "bricks" || field.name() == "ridges" || field.name() == "steps" ||
            field.name() == "plane") {
            for (int i = 0; i < field.size(); ++i) {
                for (const int steps : {8, 16, 24, 32}) {
                    const double sample = (0.5 - field.Texel(i, 4)) * steps;
                    EXPECT_GT(std::fabs(sample - std::round(sample)), 0.01) << field.name();
                }
            }
        }
    }
}

TEST(ReliefFields, AreCalledByName) {
    EXPECT_EQ(EvaluateOne("relief.texel_spike", {64, 64}), 0.5);
    EXPECT_EQ(EvaluateOne("relief.texel_spike", {64 - 128, 64 + 256}), 0.5);
    EXPECT_EQ(EvaluateOne("relief.texel_spike", {64, 63}), -1761.0 / 4096);
    EXPECT_EQ(EvaluateOne("relief.texel_flat", {1e9, -1e9}), -0.125);
    EXPECT_TRUE(std::isnan(EvaluateOne("relief.texel_flat", {1e30, 0})));
    EXPECT_TRUE(std::isnan(EvaluateOne("relief.texel_flat", {0, std::nan("")})));
}

TEST(ReliefFields, TheFilmIsSaturatedInTwoFifthsOfItsTexels) {
    double saturated = 0;
    for (int j = 0; j < 128; ++j) {
        for (int i = 0; i < 128; ++i) {
            saturated += EvaluateOne("relief.texel_film", {double(i), double(j)}) == 0.5 ? 1 : 0;
        }
    }
    EXPECT_NEAR(saturated / (128 * 128), 0.4, 0.02);
}

}  // namespace
}  // namespace etalon::oracle
