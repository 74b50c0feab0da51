#include "chart/pareto.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace etalon {
namespace {

using testing::ElementsAre;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

bool IsKnown(const CostAndError& point) {
    return std::isfinite(point.cost) && std::isfinite(point.error);
}

std::vector<CostAndError> Exact(const std::vector<std::pair<double, double>>& costs_and_errors) {
    std::vector<CostAndError> points;
    for (const auto& [cost, error] : costs_and_errors) {
        points.push_back(CostAndError::Exact(cost, error));
    }
    return points;
}

// The definition, word for word.
bool Dominates(const CostAndError& a, const CostAndError& b) {
    return IsKnown(a) && a.cost <= b.cost && a.error <= b.error &&
           (a.cost < b.cost || a.error < b.error);
}

TEST(ParetoTest, IsWhatItsDefinitionSays) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 3000; ++trial) {
        // Few different numbers make many ties.
        const int different = trial % 3 == 0 ? 3 : trial % 3 == 1 ? 12 : 100000;
        std::uniform_int_distribution<int> draw(-3, different);
        const auto number = [&] {
            const int drawn = draw(random);
            return drawn == -3   ? kNan
                   : drawn == -2 ? kInfinity
                   : drawn == -1 ? 0
                                 : static_cast<double>(drawn);
        };
        std::vector<CostAndError> points(random() % 20);
        for (CostAndError& point : points) {
            point = CostAndError::Exact(number(), number());
        }
        const std::vector<bool> front = ParetoFront(points);
        ASSERT_EQ(front.size(), points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            bool wanted = IsKnown(points[i]);
            for (const CostAndError& other : points) {
                wanted = wanted && !Dominates(other, points[i]);
            }
            ASSERT_EQ(front[i], wanted) << "trial " << trial << ", point " << i;
        }
    }
}

// What beats another where costs have spreads.
bool Beats(const CostAndError& a, const CostAndError& b) {
    const bool alike = a.low <= b.high && b.low <= a.high;
    const bool less = a.cost < b.cost && !alike;
    return (a.error < b.error && (less || alike)) || (a.error == b.error && less);
}

TEST(ParetoTest, WhatBeatsAPointIsOnTheFrontAndNothingOnItIsBeatenThere) {
    std::mt19937 random(8);
    for (int trial = 0; trial < 3000; ++trial) {
        std::uniform_int_distribution<int> draw(0, trial % 2 == 0 ? 5 : 1000);
        std::vector<CostAndError> points(random() % 20);
        for (CostAndError& point : points) {
            const double numbers[] = {static_cast<double>(draw(random)), 0.3 * draw(random),
                                      0.3 * draw(random)};
            point = {numbers[0], static_cast<double>(draw(random)),
                     std::max(0.0, numbers[0] - numbers[1]), numbers[0] + numbers[2]};
        }
        const std::vector<bool> front = ParetoFront(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            bool is_beaten = false;
            for (std::size_t k = 0; k < points.size(); ++k) {
                is_beaten = is_beaten || (front[k] && Beats(points[k], points[i]));
            }
            ASSERT_EQ(front[i], !is_beaten) << "trial " << trial << ", point " << i;
        }
    }
}

TEST(ParetoTest, CostsWithinTheirSpreadAreAlike) {
    const CostAndError points[] = {{10, 3, 9, 11}, {10.5, 2, 10, 11}, {10.4, 2, 10, 11},
                                   {8, 4, 8, 8.5}, {12, 1, 11.5, 13}, {12.5, 2, 12, 13}};
    EXPECT_THAT(ParetoFront(points), ElementsAre(false, true, true, true, true, false));
    EXPECT_EQ(CheapestWithin(points, 3), 1u);
    EXPECT_EQ(CheapestWithin(points, 4), 3u);
    EXPECT_EQ(CheapestWithin(points, 1), 4u);
}

TEST(ParetoTest, EqualPointsAreOnItTogether) {
    const auto points = Exact({{1, 2}, {1, 2}, {1, 3}, {2, 2}, {2, 1}});
    EXPECT_THAT(ParetoFront(points), ElementsAre(true, true, false, false, true));
}

TEST(ParetoTest, WhatIsNotKnownIsNotOnIt) {
    const auto points = Exact({{kNan, 0}, {0, kNan}, {0, kInfinity}, {kInfinity, 0}, {5, 5}});
    EXPECT_THAT(ParetoFront(points), ElementsAre(false, false, false, false, true));
    EXPECT_TRUE(ParetoFront({}).empty());
}

TEST(ParetoTest, TheCheapestWithinABound) {
    const auto points = Exact(
        {{kNan, 0}, {3, 0.1}, {2, 0.5}, {2, 0.25}, {kInfinity, 0}, {1, 2}, {0, kNan}, {2, 0.25}});
    EXPECT_EQ(CheapestWithin(points, 2), 5u);
    EXPECT_EQ(CheapestWithin(points, 1), 3u);
    EXPECT_EQ(CheapestWithin(points, 0.25), 3u);
    EXPECT_EQ(CheapestWithin(points, 0.2), 1u);
    EXPECT_EQ(CheapestWithin(points, 0.01), std::nullopt);
}

}  // namespace
}  // namespace etalon
