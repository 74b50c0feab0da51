#include "image/image.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>

namespace etalon {
namespace {

Image Flat(std::uint32_t width, std::uint32_t height, std::uint32_t levels) {
    Image image{width, height, {}, levels};
    image.rgba.resize(LevelStart(image, levels));
    return image;
}

TEST(Image, HalvesOddSizesDownToOne) {
    const Image image = Flat(13, 5, 4);
    EXPECT_EQ(FullLevels(image), 4u);
    EXPECT_EQ(LevelSize(image, 1).width, 6u);
    EXPECT_EQ(LevelSize(image, 1).height, 2u);
    EXPECT_EQ(LevelSize(image, 3).width, 1u);
    EXPECT_EQ(LevelSize(image, 3).height, 1u);
    EXPECT_EQ(LevelStart(image, 0), 0u);
    EXPECT_EQ(LevelStart(image, 2), 4u * (13 * 5 + 6 * 2));
    EXPECT_EQ(FullLevels(Flat(1, 1, 1)), 1u);
    EXPECT_EQ(FullLevels(Flat(1, 1024, 1)), 11u);
}

TEST(Image, CountsACubesFaces) {
    Image image = Flat(4, 4, 1);
    image.shape = ImageShape::kCube;
    EXPECT_EQ(FaceCount(image), 6u);
    EXPECT_EQ(LevelStart(image, 1), 4u * 6 * 16);
    EXPECT_FALSE(IsWhole(image));
    image.rgba.resize(LevelStart(image, 1));
    EXPECT_TRUE(IsWhole(image));
}

TEST(Image, IsWholeOnlyWithAllItsValues) {
    EXPECT_TRUE(IsWhole(Flat(3, 2, 2)));
    EXPECT_FALSE(IsWhole({}));
    EXPECT_FALSE(IsWhole(Flat(3, 2, 0)));
    EXPECT_FALSE(IsWhole(Flat(3, 2, 3)));
    Image image = Flat(3, 2, 1);
    image.rgba.pop_back();
    EXPECT_FALSE(IsWhole(image));
    image = Flat(3, 2, 1);
    image.levels = std::numeric_limits<std::uint32_t>::max();
    EXPECT_FALSE(IsWhole(image));
    image = Flat(3, 2, 1);
    image.shape = static_cast<ImageShape>(2);
    EXPECT_FALSE(IsWhole(image));
    image = Flat(3, 2, 1);
    image.shape = ImageShape::kCube;
    image.rgba.resize(6 * image.rgba.size());
    EXPECT_FALSE(IsWhole(image)) << "its faces are no squares";
    image = Flat(1, 1, 1);
    image.width = image.height = std::numeric_limits<std::uint32_t>::max();
    EXPECT_FALSE(IsWhole(image));
    image.width = image.height = 1u << 31;
    image.rgba.clear();
    EXPECT_FALSE(IsWhole(image)) << "four times 2^62 values are none in 64 bits";
}

TEST(Image, IsTheSameBitByBit) {
    Image a = Flat(1, 1, 1);
    EXPECT_TRUE(AreSame(a, a));
    Image b = a;
    b.rgba[2] = -0.0f;
    EXPECT_FALSE(AreSame(a, b));
    a.rgba[2] = b.rgba[2] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(AreSame(a, b));
    EXPECT_FALSE(AreSame(Flat(2, 1, 1), Flat(1, 2, 1)));
}

// The APIs' own table, the other way round: from a direction to a face and its s and t.
struct FacePoint {
    std::uint32_t face;
    double s, t;
};
FacePoint FaceOf(const Direction& d) {
    const double x = std::fabs(d.x);
    const double y = std::fabs(d.y);
    const double z = std::fabs(d.z);
    std::uint32_t face = 0;
    double sc = 0;
    double tc = -d.y;
    if (x > y && x > z) {
        face = d.x > 0 ? 0 : 1;
        sc = d.x > 0 ? -d.z : d.z;
    } else if (y > z) {
        face = d.y > 0 ? 2 : 3;
        sc = d.x;
        tc = d.y > 0 ? d.z : -d.z;
    } else {
        face = d.z > 0 ? 4 : 5;
        sc = d.z > 0 ? d.x : -d.x;
    }
    const double major = std::max(x, std::max(y, z));
    return {face, (sc / major + 1) / 2, (tc / major + 1) / 2};
}

TEST(CubeDirection, InvertsTheTableOfBothApis) {
    for (std::uint32_t face = 0; face < 6; ++face) {
        for (const double s : {0.125, 0.5, 0.75}) {
            for (const double t : {0.25, 0.5, 0.875}) {
                const FacePoint back = FaceOf(CubeDirection(face, s, t));
                EXPECT_EQ(back.face, face);
                EXPECT_DOUBLE_EQ(back.s, s) << face;
                EXPECT_DOUBLE_EQ(back.t, t) << face;
            }
        }
    }
}

}  // namespace
}  // namespace etalon
