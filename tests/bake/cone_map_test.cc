#include "bake/cone_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields.h"

namespace etalon::bake {
namespace {

// To be read between the texels.
Heights AsField(const Heights& heights, const std::vector<double>& ratios) {
    return {heights.width(), heights.height(), ratios};
}

struct Place {
    double x;
    double y;
};

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double Share() { return std::uniform_real_distribution<double>(0, 1)(engine_); }
    Place In(const Heights& heights) {
        return {Share() * heights.width(), Share() * heights.height()};
    }

  private:
    std::mt19937 engine_;
};

TEST(ConeMap, SafeConesHoldNoSurface) {
    Random random(3);
    for (const Heights& heights : Fields()) {
        const Heights ratios = AsField(heights, SafeCones(heights));
        for (int k = 0; k < 100000; ++k) {
            const Place tip = random.In(heights);
            const double way = 12 * random.Share() * random.Share() * random.Share();
            const double angle = 6.283185307179586 * random.Share();
            const double rise =
                heights.At(tip.x + way * std::cos(angle), tip.y + way * std::sin(angle)) -
                heights.At(tip.x, tip.y);
            ASSERT_GE(way, ratios.At(tip.x, tip.y) * rise - 1e-9)
                << heights.width() << " at " << tip.x << ' ' << tip.y << " way " << way;
        }
    }
}

// Rays from above the tip are followed to the cone's border: once in the solid they stay there.
TEST(ConeMap, SafeRelaxedConesAreEnteredOnce) {
    Random random(4);
    std::size_t entered = 0;
    for (const Heights& heights : Fields()) {
        const Heights ratios = AsField(heights, SafeRelaxedCones(heights));
        const double span = heights.highest() - heights.lowest() + 0.5;
        for (int k = 0; k < 4000; ++k) {
            const Place tip = random.In(heights);
            const double angle = 6.283185307179586 * random.Share();
            const double ratio = ratios.At(tip.x, tip.y);
            const double above = span * random.Share() * random.Share();
            const double fall = random.Share() < 0.3 ? 0 : random.Share() * random.Share() * 3;
            // way = ratio * (above - fall * way)
            const double border = ratio * above / (1 + ratio * fall);
            const double tip_z = heights.At(tip.x, tip.y);
            bool in_solid = false;
            constexpr int kSamples = 200;
            for (int sample = 1; sample <= kSamples; ++sample) {
                const double way = std::min(border, 20.0) * sample / kSamples;
                const double gap =
                    tip_z + above - fall * way -
                    heights.At(tip.x + way * std::cos(angle), tip.y + way * std::sin(angle));
                ASSERT_FALSE(in_solid && gap > 1e-9) << heights.width() << " way " << way;
                entered += !in_solid && gap < 0 ? 1u : 0u;
                in_solid = gap < 0;
            }
        }
    }
    EXPECT_GT(entered, 100u);
}

TEST(ConeMap, RelaxedConesAreNotNarrower) {
    for (const Heights& heights : Fields()) {
        const std::vector<double> cones = SafeCones(heights);
        const std::vector<double> relaxed = SafeRelaxedCones(heights);
        for (std::size_t k = 0; k < cones.size(); ++k) {
            EXPECT_GE(relaxed[k], cones[k]);
            EXPECT_LE(relaxed[k], kWidestCone);
            EXPECT_GT(cones[k], 0);
        }
    }
}

// Safe cones are not much narrower than they could be, where the field is smooth.
TEST(ConeMap, SafeConesOfWavesAreWide) {
    const Heights heights = WavyField(64, 64, 6);
    const std::vector<double> safe = SafeCones(heights);
    const std::vector<double> sampled = SampledCones(heights);
    double share = 0;
    for (std::size_t k = 0; k < safe.size(); ++k) {
        EXPECT_LE(safe[k], 1.2 * sampled[k]);
        share += std::min(safe[k] / sampled[k], 1.0);
    }
    EXPECT_GT(share / static_cast<double>(safe.size()), 0.6);
}

TEST(ConeMap, SampledConesAreThoseOfBruteForce) {
    for (const Heights& heights : Fields()) {
        const std::vector<double> ratios = SampledCones(heights);
        for (int j = 0; j < heights.height(); ++j) {
            for (int i = 0; i < heights.width(); ++i) {
                double least = kWidestCone;
                for (int dj = -40; dj <= 40; ++dj) {
                    for (int di = -40; di <= 40; ++di) {
                        const double rise = heights.Texel(i + di, j + dj) - heights.Texel(i, j);
                        if (rise > 0) {
                            least = std::min(least, std::hypot(di, dj) / rise);
                        }
                    }
                }
                EXPECT_DOUBLE_EQ(ratios[static_cast<std::size_t>(j * heights.width() + i)], least);
            }
        }
    }
}

// Between the texels the published cones do hold surface.
TEST(ConeMap, SampledConesAreNotSafe) {
    const Heights heights = SpikeField(16, 16, 8);
    const Heights ratios = AsField(heights, SampledCones(heights));
    // Half a texel from the spike's centre the surface rises to it by 4.
    EXPECT_GT(ratios.At(8.5, 8) * (heights.At(8, 8) - heights.At(8.5, 8)), 10 * 0.5);
}

}  // namespace
}  // namespace etalon::bake
