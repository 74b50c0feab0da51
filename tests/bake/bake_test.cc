#include "bake/bake.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

namespace etalon::bake {
namespace {

using testing::HasSubstr;

Image HeightImage(std::uint32_t width, std::uint32_t height) {
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.resize(std::size_t{4} * width * height, 9.0f);
    for (std::size_t texel = 0; texel < std::size_t{width} * height; ++texel) {
        image.rgba[4 * texel] = 0.25f * std::sin(1.7f * static_cast<float>(texel));
    }
    return image;
}

float Red(const Image& image, std::uint32_t column, std::uint32_t row) {
    return image.rgba[4 * (std::size_t{row} * image.width + column)];
}

Image BakeWell(const Image& heights, const Plan& plan) {
    Result<Image> map = Bake(heights, plan);
    EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().message);
    EXPECT_TRUE(IsWhole(*map));
    for (std::size_t k = 0; k < map->rgba.size(); k += 4) {
        EXPECT_EQ(map->rgba[k], map->rgba[k + 1]);
        EXPECT_EQ(map->rgba[k], map->rgba[k + 2]);
        EXPECT_EQ(map->rgba[k + 3], 1.0f);
    }
    return *map;
}

std::string Refused(const Image& heights, const Plan& plan) {
    const Result<Image> map = Bake(heights, plan);
    EXPECT_FALSE(map.ok());
    return map.ok() ? "" : map.error().message;
}

TEST(Bake, EveryKindHasAName) {
    ASSERT_EQ(KindNames().size(), 5u);
    for (const std::string_view name : KindNames()) {
        ASSERT_TRUE(KindNamed(name));
        EXPECT_EQ(KindNames()[static_cast<std::size_t>(*KindNamed(name))], name);
    }
    EXPECT_FALSE(KindNamed("distances"));
}

TEST(Bake, SlicesAreTiles) {
    const Image heights = HeightImage(16, 8);
    const Image map = BakeWell(heights, {.kind = Kind::kDistance, .slices = 5});
    EXPECT_EQ(TileColumns(5), 3u);
    EXPECT_EQ(map.width, 3u * 16);
    EXPECT_EQ(map.height, 2u * 8);
    // From slice 3, the first of the second row, to slice 4: a fifth of the box, at most.
    for (std::uint32_t i = 0; i < 16; ++i) {
        const float rise = Red(map, 16 + i, 8) - Red(map, i, 8);
        EXPECT_GE(rise, 0.0f);
        EXPECT_LE(rise, 0.2001f);
    }
    EXPECT_EQ(Red(map, 2 * 16, 8), 0.0f);  // no tile
}

// Distances are in box heights: above a plane, whatever the texels are.
TEST(Bake, DistancesAreInBoxHeights) {
    Image plane = HeightImage(8, 8);
    for (float& value : plane.rgba) {
        value = -0.25f;
    }
    Plan plan = {.kind = Kind::kDistance, .slices = 4, .published = true};
    for (const double texels : {1.0, 20.0}) {
        plan.texels_per_height = texels;
        const Image map = BakeWell(plane, plan);
        EXPECT_NEAR(Red(map, 8, 8), 0.625f, 1e-6f);  // slice 3, at z = 0.375
        EXPECT_EQ(Red(map, 0, 0), 0.0f);
    }
}

TEST(Bake, LevelsStandBesideEachOther) {
    const Image heights = HeightImage(8, 8);
    const Image map = BakeWell(heights, {.kind = Kind::kMaxMip});
    EXPECT_EQ(map.width, 12u);
    EXPECT_EQ(map.height, 8u);
    float most = -1;
    for (std::uint32_t j = 0; j < 8; ++j) {
        for (std::uint32_t i = 0; i < 8; ++i) {
            const float cell = std::max(
                std::max(Red(heights, i, j), Red(heights, (i + 1) % 8, j)),
                std::max(Red(heights, i, (j + 1) % 8), Red(heights, (i + 1) % 8, (j + 1) % 8)));
            EXPECT_EQ(Red(map, i, j), cell);  // to the last bit
            most = std::max(most, cell);
        }
    }
    EXPECT_EQ(Red(map, 8, 4 + 2), most);  // level 3
    EXPECT_EQ(BakeWell(HeightImage(8, 1), {.kind = Kind::kMaxMip}).height, 3u);
    EXPECT_EQ(BakeWell(HeightImage(1, 1), {.kind = Kind::kMaxMip}).width, 1u);
}

TEST(Bake, ScaleAndLevelMakeTheHeight) {
    const Image heights = HeightImage(4, 4);
    const Image map = BakeWell(heights, {.kind = Kind::kMaxMip, .scale = 0.5, .level = 0.125});
    const Image plain = BakeWell(heights, {.kind = Kind::kMaxMip});
    EXPECT_EQ(Red(map, 1, 2), 0.5f * Red(plain, 1, 2) + 0.125f);
}

TEST(Bake, WhatDoesNotFitIsRefused) {
    Image heights = HeightImage(12, 8);
    EXPECT_THAT(Refused(heights, {.kind = Kind::kMaxMip}), HasSubstr("powers of two, not 12 x 8"));
    EXPECT_THAT(Refused(heights, {.kind = Kind::kCone, .slices = 4}), HasSubstr("no slices"));
    EXPECT_THAT(Refused(heights, {.kind = Kind::kCone, .bearings = 4}), HasSubstr("no bearings"));
    EXPECT_THAT(Refused(heights, {.kind = Kind::kHorizon, .published = true}),
                HasSubstr("published"));
    EXPECT_THAT(Refused(heights, {.kind = Kind::kDistance, .slices = 0}), HasSubstr("1 to 4096"));
    EXPECT_THAT(Refused(HeightImage(2048, 2), {.kind = Kind::kDistance, .slices = 4096}),
                HasSubstr("too many"));
    for (const double texels : {0.0, -1.0, 1e30, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THAT(Refused(heights, {.kind = Kind::kCone, .texels_per_height = texels}),
                    HasSubstr("texels per height"));
    }
    heights.rgba[4 * (12 * 3 + 5)] = 0.75f;
    EXPECT_THAT(Refused(heights, {.kind = Kind::kCone}),
                HasSubstr("the height 0.75 at column 5 of row 3 is beyond the box"));
    heights.rgba[4 * (12 * 3 + 5)] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THAT(Refused(heights, {.kind = Kind::kCone}), HasSubstr("beyond the box"));
}

}  // namespace
}  // namespace etalon::bake
