#include "bake/max_mip.h"

#include <algorithm>
#include <bit>

#include "base/check.h"

namespace etalon::bake {

std::vector<MaxLevel> MaxLevels(const Heights& heights) {
    ETALON_CHECK(std::has_single_bit(static_cast<unsigned>(heights.width())) &&
                 std::has_single_bit(static_cast<unsigned>(heights.height())));
    std::vector<MaxLevel> levels;
    MaxLevel cells{heights.width(), heights.height(), {}};
    for (int j = 0; j < cells.height; ++j) {
        for (int i = 0; i < cells.width; ++i) {
            cells.most.push_back(Cell(heights, i, j).highest);
        }
    }
    levels.push_back(std::move(cells));
    while (levels.back().most.size() > 1) {
        const MaxLevel& above = levels.back();
        MaxLevel level{std::max(above.width / 2, 1), std::max(above.height / 2, 1), {}};
        const auto at = [&above](int i, int j) {
            return above.most[static_cast<std::size_t>(std::min(j, above.height - 1)) *
                                  static_cast<std::size_t>(above.width) +
                              static_cast<std::size_t>(std::min(i, above.width - 1))];
        };
        for (int j = 0; j < level.height; ++j) {
            for (int i = 0; i < level.width; ++i) {
                level.most.push_back(std::max({at(2 * i, 2 * j), at(2 * i + 1, 2 * j),
                                               at(2 * i, 2 * j + 1), at(2 * i + 1, 2 * j + 1)}));
            }
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

}  // namespace etalon::bake
