#include "image/levels.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

namespace etalon {
namespace {

Image Counted(std::uint32_t width, std::uint32_t height, ImageShape shape = ImageShape::kFlat) {
    Image image{width, height, {}, 1, shape};
    image.rgba.resize(LevelStart(image, 1));
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
        image.rgba[i] = static_cast<float>((i * 2654435761u) % 1000) / 7.0f;
    }
    return image;
}

const float* Texel(const Image& image, std::uint32_t level, std::uint32_t face, std::uint32_t x,
                   std::uint32_t y) {
    const ImageSize size = LevelSize(image, level);
    return image.rgba.data() + LevelStart(image, level) +
           4 * (face * size.texels() + std::size_t{y} * size.width + x);
}

TEST(Levels, OfAnEvenSizeAreMeansOfFour) {
    Image image = Counted(8, 4);
    AddLevels(image);
    EXPECT_EQ(image.levels, 4u);
    ASSERT_TRUE(IsWhole(image));
    for (std::uint32_t x = 0; x < 4; ++x) {
        for (std::size_t channel = 0; channel < 4; ++channel) {
            double sum = 0;
            for (const std::uint32_t i : {2 * x, 2 * x + 1}) {
                for (const std::uint32_t j : {0u, 1u}) {
                    sum += Texel(image, 0, 0, i, j)[channel];
                }
            }
            EXPECT_EQ(Texel(image, 1, 0, x, 0)[channel], static_cast<float>(sum / 4));
        }
    }
}

// Whatever the sizes, the last level is the mean of all texels: no part of one is lost or counted
// twice.
TEST(Levels, OfAnySizeKeepTheMean) {
    for (const auto& [width, height] : {std::pair(5u, 3u), std::pair(7u, 7u), std::pair(1u, 9u),
                                        std::pair(6u, 11u), std::pair(31u, 2u)}) {
        Image image = Counted(width, height);
        const std::vector<float> first = image.rgba;
        AddLevels(image);
        ASSERT_TRUE(IsWhole(image));
        for (std::size_t channel = 0; channel < 4; ++channel) {
            double sum = 0;
            for (std::size_t i = channel; i < first.size(); i += 4) {
                sum += first[i];
            }
            const double mean = sum / (double{1} * width * height);
            EXPECT_NEAR(Texel(image, image.levels - 1, 0, 0, 0)[channel], mean, 1e-5)
                << width << " x " << height;
        }
    }
}

TEST(Levels, OfAnOddSizeShareTheMiddleTexel) {
    Image image{5, 1, std::vector<float>(20)};
    for (std::size_t i = 0; i < 5; ++i) {
        image.rgba[4 * i] = static_cast<float>(i);
    }
    AddLevels(image);
    EXPECT_FLOAT_EQ(*Texel(image, 1, 0, 0, 0), (0 + 1 + 2 * 0.5f) / 2.5f);
    EXPECT_FLOAT_EQ(*Texel(image, 1, 0, 1, 0), (2 * 0.5f + 3 + 4) / 2.5f);
    EXPECT_EQ(*Texel(image, 2, 0, 0, 0), 2.0f);
}

TEST(Levels, AreRoundedOnce) {
    // Rounded level by level, the mean of the first pair would be 1, and the mean of all too.
    const float next = std::nextafterf(1.0f, 2.0f);
    Image image{4, 1, {1, 0, 0, 0, next, 0, 0, 0, next, 0, 0, 0, next, 0, 0, 0}};
    AddLevels(image);
    EXPECT_EQ(*Texel(image, 2, 0, 0, 0),
              static_cast<float>((1.0 + 3 * static_cast<double>(next)) / 4));
}

TEST(Levels, OfACubeAreEachFacesOwn) {
    Image image = Counted(4, 4, ImageShape::kCube);
    const Image before = image;
    AddLevels(image);
    ASSERT_TRUE(IsWhole(image));
    for (std::uint32_t face = 0; face < 6; ++face) {
        Image alone{4, 4, {}, 1};
        alone.rgba.assign(Texel(before, 0, face, 0, 0), Texel(before, 0, face, 0, 0) + 64);
        AddLevels(alone);
        for (std::uint32_t level = 0; level < 3; ++level) {
            EXPECT_EQ(*Texel(image, level, face, 0, 0), *Texel(alone, level, 0, 0, 0)) << level;
        }
    }
}

}  // namespace
}  // namespace etalon
