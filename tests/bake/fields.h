// Fields of heights to bake from.
#pragma once

#include <cmath>
#include <random>
#include <vector>

#include "bake/heights.h"

namespace etalon::bake {

inline Heights RandomField(int width, int height, double range, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> z(-0.5 * range, 0.5 * range);
    std::vector<double> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (double& texel : texels) {
        texel = z(random);
    }
    return {width, height, texels};
}

// Low waves, so that neighbours differ by little.
inline Heights WavyField(int width, int height, double range) {
    std::vector<double> texels;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            texels.push_back(0.25 * range *
                             (std::sin(6.283185307179586 * (2.0 * i / width + 1.0 * j / height)) +
                              std::sin(6.283185307179586 * (3.0 * j / height))));
        }
    }
    return {width, height, texels};
}

// One texel stands out of a plane.
inline Heights SpikeField(int width, int height, double range) {
    std::vector<double> texels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                               -0.5 * range);
    texels[texels.size() / 2 + static_cast<std::size_t>(width) / 2] = 0.5 * range;
    return {width, height, texels};
}

// Plateaus with trenches between them, along y.
inline Heights TrenchField(int width, int height, double range) {
    std::vector<double> texels;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            texels.push_back(i % 16 < 8 ? 0.5 * range : -0.5 * range);
        }
    }
    return {width, height, texels};
}

inline std::vector<Heights> Fields() {
    return {RandomField(8, 8, 4, 1),
            RandomField(16, 4, 2, 2),
            RandomField(7, 5, 10, 3),
            WavyField(16, 16, 6),
            WavyField(32, 8, 3),
            SpikeField(16, 16, 8),
            SpikeField(5, 9, 1),
            TrenchField(32, 16, 3),
            Heights(4, 4, std::vector<double>(16, 0.25)),
            Heights(1, 1, {0.5})};
}

}  // namespace etalon::bake
