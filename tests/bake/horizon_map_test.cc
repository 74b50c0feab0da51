#include "bake/horizon_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fields.h"

namespace etalon::bake {
namespace {

constexpr double kReach = 40;

// A scan in small steps sees no more, and nearly as much.
TEST(HorizonMap, TangentsAreThoseOfAScan) {
    for (const Heights& heights : Fields()) {
        const double steepest = 1.5 * (heights.highest() - heights.lowest());
        for (const int bearings : {1, 8, 12}) {
            const std::vector<double> tangents = HorizonTangents(heights, bearings, kReach);
            std::size_t index = 0;
            for (int k = 0; k < bearings; ++k) {
                const double angle = 2 * std::numbers::pi * k / bearings;
                for (int j = 0; j < heights.height(); ++j) {
                    for (int i = 0; i < heights.width(); ++i, ++index) {
                        double most = 0;
                        constexpr double kStep = 0.01;
                        for (double way = kStep; way < kReach; way += kStep) {
                            most = std::max(most, (heights.At(i + way * std::cos(angle),
                                                              j + way * std::sin(angle)) -
                                                   heights.Texel(i, j)) /
                                                      way);
                        }
                        EXPECT_GE(tangents[index], most - 1e-9);
                        EXPECT_LE(tangents[index], most + 2 * kStep * steepest);
                    }
                }
            }
        }
    }
}

TEST(HorizonMap, AWallIsSeenFromAfar) {
    const Heights heights = SpikeField(16, 16, 8);
    const std::vector<double> tangents = HorizonTangents(heights, 4, kReach);
    // From texel (4, 8) the spike at (8, 8) stands 4 to the right and is 8 high.
    EXPECT_DOUBLE_EQ(tangents[8 * 16 + 4], 2);
    EXPECT_DOUBLE_EQ(tangents[2 * 256 + 8 * 16 + 4], 8.0 / 12);  // around the other way
    EXPECT_EQ(tangents[256 + 8 * 16 + 4], 0);
    EXPECT_EQ(tangents[8 * 16 + 8], 0);  // from the top itself
}

}  // namespace
}  // namespace etalon::bake
