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
            point = {number(), number()};
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

TEST(ParetoTest, EqualPointsAreOnItTogether) {
    const CostAndError points[] = {{1, 2}, {1, 2}, {1, 3}, {2, 2}, {2, 1}};
    EXPECT_THAT(ParetoFront(points), ElementsAre(true, true, false, false, true));
}

TEST(ParetoTest, WhatIsNotKnownIsNotOnIt) {
    const CostAndError points[] = {{kNan, 0}, {0, kNan}, {0, kInfinity}, {kInfinity, 0}, {5, 5}};
    EXPECT_THAT(ParetoFront(points), ElementsAre(false, false, false, false, true));
    EXPECT_TRUE(ParetoFront({}).empty());
}

TEST(ParetoTest, TheCheapestWithinABound) {
    const CostAndError points[] = {{kNan, 0},      {3, 0.1}, {2, 0.5},  {2, 0.25},
                                   {kInfinity, 0}, {1, 2},   {0, kNan}, {2, 0.25}};
    EXPECT_EQ(CheapestWithin(points, 2), 5u);
    EXPECT_EQ(CheapestWithin(points, 1), 3u);
    EXPECT_EQ(CheapestWithin(points, 0.25), 3u);
    EXPECT_EQ(CheapestWithin(points, 0.2), 1u);
    EXPECT_EQ(CheapestWithin(points, 0.01), std::nullopt);
}

}  // namespace
}  // namespace etalon
