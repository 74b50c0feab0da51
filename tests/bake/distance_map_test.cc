#include "bake/distance_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "fields.h"

namespace etalon::bake {
namespace {

constexpr int kSlices = 6;

std::array<double, 2> Box(const Heights& heights) {
    const double half = std::max({std::fabs(heights.lowest()), std::fabs(heights.highest()), 0.5});
    return {-half, half};
}

double SliceHeight(const Heights& heights, int slice) {
    const auto [floor, top] = Box(heights);
    return floor + (top - floor) * (slice + 0.5) / kSlices;
}

// The distance of a point to the columns under all texels near enough to matter.
double ToColumns(const Heights& heights, int i, int j, double z) {
    double least = std::max(z - heights.Texel(i, j), 0.0);
    const int reach = static_cast<int>(least) + 1;
    for (int dj = -reach; dj <= reach; ++dj) {
        for (int di = -reach; di <= reach; ++di) {
            const double above = std::max(z - heights.Texel(i + di, j + dj), 0.0);
            least = std::min(least, std::hypot(di, dj, above));
        }
    }
    return least;
}

double At(const Heights& heights, const DistanceMap& map, int i, int j, int slice) {
    return map
        .distances[(static_cast<std::size_t>(slice) * static_cast<std::size_t>(heights.height()) +
                    static_cast<std::size_t>(Heights::Wrapped(j, heights.height()))) *
                       static_cast<std::size_t>(heights.width()) +
                   static_cast<std::size_t>(Heights::Wrapped(i, heights.width()))];
}

// As a sampler reads it: trilinear, repeating, and clamped upwards and downwards.
double Trilinear(const Heights& heights, const DistanceMap& map, double x, double y, double z) {
    const auto [floor, top] = Box(heights);
    const double place =
        std::clamp((z - floor) / (top - floor) * kSlices - 0.5, 0.0, kSlices - 1.0);
    const int i = static_cast<int>(std::floor(x));
    const int j = static_cast<int>(std::floor(y));
    const int k = std::min(static_cast<int>(place), kSlices - 2);
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int di = corner & 1;
        const int dj = corner >> 1 & 1;
        const int dk = corner >> 2;
        const auto weight = [](double part, int upper) { return upper == 1 ? part : 1 - part; };
        sum += weight(x - i, di) * weight(y - j, dj) * weight(place - k, dk) *
               At(heights, map, i + di, j + dj, k + dk);
    }
    return sum;
}

TEST(DistanceMap, SampledDistancesAreThoseOfBruteForce) {
    for (const Heights& heights : Fields()) {
        const auto [floor, top] = Box(heights);
        const DistanceMap map = SampledDistances(heights, floor, top, kSlices);
        for (int slice = 0; slice < kSlices; ++slice) {
            for (int j = 0; j < heights.height(); ++j) {
                for (int i = 0; i < heights.width(); ++i) {
                    EXPECT_NEAR(At(heights, map, i, j, slice),
                                ToColumns(heights, i, j, SliceHeight(heights, slice)), 1e-6);
                }
            }
        }
    }
}

// Points of the bilinear surface, and below it, are never within the distance that is read.
TEST(DistanceMap, SafeDistancesAreSafe) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> share(0, 1);
    for (const Heights& heights : Fields()) {
        const auto [floor, top] = Box(heights);
        const DistanceMap map = SafeDistances(heights, floor, top, kSlices);
        std::size_t used = 0;
        for (int k = 0; k < 20000; ++k) {
            const double x = share(random) * heights.width();
            const double y = share(random) * heights.height();
            const double z = floor + share(random) * (top - floor);
            const double read = Trilinear(heights, map, x, y, z);
            if (read <= 0) {
                continue;
            }
            ++used;
            const double angle = 6.283185307179586 * share(random);
            const double down = -1 + share(random) * 1.5;
            const double flat = std::sqrt(std::max(1 - down * down, 0.0));
            const double reach = read * (k % 2 == 0 ? 1 : std::cbrt(share(random)));
            EXPECT_LT(
                heights.At(x + reach * flat * std::cos(angle), y + reach * flat * std::sin(angle)),
                z + reach * down);
        }
        EXPECT_TRUE(used > 100 || heights.highest() == heights.lowest()) << used;
    }
}

// And lose no more than they say: half a diagonal and half a texel.
TEST(DistanceMap, SafeDistancesAreNotMuchLess) {
    for (const Heights& heights : Fields()) {
        const auto [floor, top] = Box(heights);
        const double slice = (top - floor) / kSlices;
        const DistanceMap safe = SafeDistances(heights, floor, top, kSlices);
        const DistanceMap sampled = SampledDistances(heights, floor, top, kSlices);
        for (std::size_t k = 0; k < safe.distances.size(); ++k) {
            EXPECT_LE(safe.distances[k], sampled.distances[k]);
        }
        if (heights.highest() == heights.lowest()) {
            const double lost = 0.5 * std::sqrt(2 + slice * slice) + 0x1p-18 * (top - floor);
            for (std::size_t k = 0; k < safe.distances.size(); ++k) {
                EXPECT_NEAR(safe.distances[k], sampled.distances[k] - lost, 1e-12);
            }
        }
    }
}

// What the published map promises fails: a ball of the stored size, between two voxels, holds a
// part of the surface.
TEST(DistanceMap, SampledDistancesAreNotSafe) {
    const Heights heights = SpikeField(16, 16, 8);
    const auto [floor, top] = Box(heights);
    const DistanceMap map = SampledDistances(heights, floor, top, kSlices);
    EXPECT_GT(Trilinear(heights, map, 8.05, 8.05, 2.5), 0.03);
    EXPECT_GT(heights.At(8.05, 8.05), 2.5 - 0.3);
}

TEST(DistanceMap, TheWorkIsLinear) {
    for (const bool safe : {false, true}) {
        const auto work = [&](int side, int slices) {
            const Heights heights = RandomField(side, side, 12, 9);
            const DistanceMap map = safe ? SafeDistances(heights, -6, 6, slices)
                                         : SampledDistances(heights, -6, 6, slices);
            return static_cast<double>(map.steps) / static_cast<double>(map.distances.size());
        };
        const double once = work(16, 8);
        EXPECT_LE(once, safe ? 100 : 12);
        EXPECT_LE(work(32, 8), 1.1 * once);
        EXPECT_LE(work(64, 8), 1.1 * once);
        EXPECT_LE(work(128, 8), 1.1 * once);
        EXPECT_LE(work(16, 64), 1.1 * once);
    }
}

}  // namespace
}  // namespace etalon::bake
