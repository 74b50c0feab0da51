#include "image/write.h"

#include <gmock/gmock.h>

#include <limits>

#include "image/levels.h"
#include "image/read.h"
#include "support/folder.h"

namespace etalon {
namespace {

TEST(WriteExr, LosesNoBit) {
    const Folder folder;
    const float least = std::numeric_limits<float>::denorm_min();
    const float most = std::numeric_limits<float>::max();
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const Image image{
        3, 2, {0,    -0.0f, 1, 0.1f, least,  most, -most, 1e-30f,    nan,      -1,   2, infinity,
               0.5f, 3,     4, 5,    -least, 7,    8,     -infinity, 1.0f / 3, 1e9f, 1, 0}};
    const auto file = folder.path() / "baked.exr";
    ASSERT_TRUE(WriteExr(file, image));
    const auto back = ReadImage(file);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(AreSame(*back, image));
}

TEST(WriteExr, WritesTheFirstLevel) {
    const Folder folder;
    Image image{2, 2, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}};
    const Image first = image;
    AddLevels(image);
    const auto file = folder.path() / "baked.exr";
    ASSERT_TRUE(WriteExr(file, image));
    const auto back = ReadImage(file);
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_TRUE(AreSame(*back, first));
}

TEST(WriteExr, SaysWhereItCannot) {
    const auto written = WriteExr("/no/such/folder/x.exr", Image{1, 1, {0, 0, 0, 0}});
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, testing::StartsWith("/no/such/folder/x.exr: "));
}

}  // namespace
}  // namespace etalon
