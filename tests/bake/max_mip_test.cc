#include "bake/max_mip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields.h"

namespace etalon::bake {
namespace {

TEST(MaxMip, LevelsAreTheGreatestOfTheirCells) {
    for (const Heights& heights : {RandomField(8, 8, 1, 1), RandomField(16, 4, 1, 2),
                                   RandomField(1, 8, 1, 3), RandomField(1, 1, 1, 4)}) {
        const std::vector<MaxLevel> levels = MaxLevels(heights);
        ASSERT_EQ(levels.size(), 1 + std::log2(std::max(heights.width(), heights.height())));
        for (std::size_t level = 0; level < levels.size(); ++level) {
            const int side = 1 << level;
            EXPECT_EQ(levels[level].width, std::max(heights.width() >> level, 1));
            EXPECT_EQ(levels[level].height, std::max(heights.height() >> level, 1));
            for (int j = 0; j < levels[level].height; ++j) {
                for (int i = 0; i < levels[level].width; ++i) {
                    double most = heights.Texel(i * side, j * side);
                    for (int y = j * side; y <= (j + 1) * side; ++y) {
                        for (int x = i * side; x <= (i + 1) * side; ++x) {
                            most = std::max(most, heights.Texel(x, y));
                        }
                    }
                    EXPECT_EQ(
                        levels[level].most[static_cast<std::size_t>(j * levels[level].width + i)],
                        most);
                }
            }
        }
    }
}

TEST(MaxMip, NothingInACellIsHigher) {
    const Heights heights = RandomField(8, 8, 1, 5);
    const MaxLevel cells = MaxLevels(heights)[0];
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(0, 8);
    for (int k = 0; k < 10000; ++k) {
        const double x = place(random);
        const double y = place(random);
        EXPECT_LE(heights.At(x, y),
                  cells.most[static_cast<std::size_t>(8 * std::floor(y) + std::floor(x))] + 1e-15);
    }
}

}  // namespace
}  // namespace etalon::bake
