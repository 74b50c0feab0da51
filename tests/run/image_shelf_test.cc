#include "run/image_shelf.h"

#include <gmock/gmock.h>

#include "case/read_images.h"
#include "image/write.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;

class ImageShelfTest : public testing::Test {
  protected:
    std::shared_ptr<const Image> Shared(const std::string& text) const {
        const auto sources = ReadImages(text, "t");
        EXPECT_TRUE(sources) << sources.error().message;
        const auto image = SharedImage(sources->front(), folder_.path());
        EXPECT_TRUE(image) << image.error().message;
        return *image;
    }

    Folder folder_;
};

TEST_F(ImageShelfTest, MakesAComputedImageOnce) {
    const auto first = Shared("m = { expr = 'u', size = [4, 4] }");
    EXPECT_EQ(Shared("other = { expr = 'u', size = [4, 4], filter = 'nearest' }"), first);
    EXPECT_NE(Shared("m = { expr = 'v', size = [4, 4] }"), first);
    EXPECT_NE(Shared("m = { expr = ['u', 'v'], size = [4, 4] }"), first);
    EXPECT_NE(Shared("m = { expr = 'u', size = [4, 8] }"), first);
    EXPECT_NE(Shared("m = { expr = 'u', size = [4, 4], levels = true }"), first);
}

TEST_F(ImageShelfTest, TellsMapsApart) {
    const std::string heights = "expr = '0.1 * u', size = [8, 8]";
    const auto cone = Shared("m = { bake = 'cone', " + heights + " }");
    EXPECT_EQ(Shared("m = { bake = 'cone', " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { bake = 'relaxed-cone', " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { bake = 'cone', published = true, " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { bake = 'cone', scale = 0.5, " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { bake = 'cone', level = 0.1, " + heights + " }"), cone);
    EXPECT_NE(Shared("m = { bake = 'cone', texels_per_height = 2.0, " + heights + " }"), cone);
    const auto distance = Shared("m = { bake = 'distance', " + heights + " }");
    EXPECT_NE(Shared("m = { bake = 'distance', slices = 8, " + heights + " }"), distance);
}

TEST_F(ImageShelfTest, ReadsAFileAnew) {
    ASSERT_TRUE(WriteExr(folder_.path() / "x.exr", Image{1, 1, {0, 0, 0, 1}}));
    const auto first = Shared("m = { file = 'x.exr' }");
    ASSERT_TRUE(WriteExr(folder_.path() / "x.exr", Image{1, 1, {1, 0, 0, 1}}));
    EXPECT_EQ(Shared("m = { file = 'x.exr' }")->rgba[0], 1);
    EXPECT_EQ(first->rgba[0], 0);
}

TEST_F(ImageShelfTest, HandsMistakesOn) {
    const auto sources = ReadImages("m = { expr = '1 / (i - 1)', size = [2, 1] }", "t");
    const auto image = SharedImage(sources->front(), folder_.path());
    EXPECT_THAT(image.error().message, HasSubstr("t:1: image 'm': "));
}

}  // namespace
}  // namespace etalon
