#include "case/read_images.h"

#include <gmock/gmock.h>

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

ImageSource Only(const std::string& text) {
    const auto images = ReadImages(text, "t");
    EXPECT_TRUE(images) << images.error().message;
    return images && images->size() == 1 ? images->front() : ImageSource{};
}

std::string Complaint(const std::string& text) {
    const auto images = ReadImages(text, "t");
    return images ? "" : images.error().message;
}

TEST(ReadImages, OfFiles) {
    const ImageSource flat = Only("map = { file = 'a/b.png' }");
    EXPECT_EQ(flat.name, "map");
    EXPECT_THAT(flat.files, ElementsAre("a/b.png"));
    EXPECT_EQ(flat.shape, ImageShape::kFlat);
    EXPECT_FALSE(flat.levels);
    EXPECT_EQ(flat.sampling, Sampling{});
    EXPECT_EQ(flat.place.Text(), "t:1: ");

    const ImageSource cube =
        Only("sky = { file = ['1', '2', '3', '4', '5', '6'], cube = true, levels = true }");
    EXPECT_EQ(cube.files.size(), 6u);
    EXPECT_EQ(cube.shape, ImageShape::kCube);
    EXPECT_TRUE(cube.levels);
}

TEST(ReadImages, OfExpressions) {
    const ImageSource flat = Only(
        "map = { expr = ['u * v', 'vec2(i, j)', 1], size = [3, 2], filter = 'nearest', wrap = "
        "'clamp' }");
    EXPECT_EQ(flat.channels.size(), 3u);
    EXPECT_EQ(flat.width, 3u);
    EXPECT_EQ(flat.height, 2u);
    EXPECT_EQ(flat.sampling, (Sampling{Filter::kNearest, Wrap::kClamp}));
    EXPECT_EQ(Only("sky = { cube = true, expr = 'x + y + z', size = [4, 4] }").channels.size(), 1u);
}

TEST(ReadImages, InTheirOrder) {
    const auto images = ReadImages("b = { file = 'x' }\na = { file = 'y' }\n", "t");
    ASSERT_TRUE(images && images->size() == 2);
    EXPECT_EQ(images->front().name, "b");
    EXPECT_EQ(images->back().place.Text(), "t:2: ");
}

TEST(ReadImages, SaysWhatIsWrong) {
    EXPECT_THAT(Complaint("map = { file = "), StartsWith("t:1:"));
    EXPECT_EQ(Complaint("map = 'x.png'"), "t:1: image 'map' must be a table");
    EXPECT_EQ(Complaint("'1map' = { file = 'x' }"), "t:1: image '1map': not a GLSL name");
    EXPECT_EQ(Complaint("map = { file = 'x', fliter = 'nearest' }"),
              "t:1: unknown key 'fliter'; did you mean 'filter'?");
    EXPECT_EQ(Complaint("map = {}"), "t:1: image 'map': needs either file or expr");
    EXPECT_EQ(Complaint("map = { file = 'x', expr = 'u', size = [1, 1] }"),
              "t:1: image 'map': needs either file or expr");
    EXPECT_EQ(Complaint("map = { file = 'x', filter = 'cubic' }"),
              "t:1: image 'map': 'filter' must be linear or nearest");
    EXPECT_EQ(Complaint("map = { file = 'x', wrap = 'mirror' }"),
              "t:1: image 'map': 'wrap' must be repeat or clamp");
    EXPECT_EQ(Complaint("map = { file = 'x', levels = 3 }"),
              "t:1: image 'map': 'levels' must be true or false");
    EXPECT_EQ(Complaint("map = { file = 'x', size = [1, 1] }"),
              "t:1: image 'map': 'size' belongs to expr: a file has its own");
    EXPECT_THAT(Complaint("map = { file = ['x'] }"), HasSubstr("must be a text"));
    EXPECT_EQ(Complaint("map = { expr = 'u' }"),
              "t:1: image 'map': 'size' is missing: expr needs it");
    EXPECT_EQ(Complaint("map = { expr = 'u', size = [4] }"),
              "t:1: image 'map': 'size' must be [width, height]");
    for (const char* size : {"[0, 4]", "[16385, 1]", "[16384, 16384]"}) {
        EXPECT_EQ(Complaint("map = { expr = 'u', size = " + std::string(size) + " }"),
                  "t:1: image 'map': 'size' must be 1 to 16384 each way, at most 16777216 texels "
                  "in all");
    }
    EXPECT_THAT(Complaint("map = { expr = 'u', size = [-1, 4] }"), HasSubstr("an integer"));
    EXPECT_EQ(Complaint("map = { expr = 'u + w', size = [4, 4] }"), "t:1:21: 'w' is no input");
    EXPECT_THAT(Complaint("map = { expr = 'u +', size = [4, 4] }"), StartsWith("t:1:"));
    EXPECT_EQ(Complaint("map = { expr = [], size = [4, 4] }"),
              "t:1: image 'map': 'expr' has 0 components; an image has 1 to 4");
    EXPECT_EQ(Complaint("map = { expr = ['vec3(u)', 'vec2(v)'], size = [4, 4] }"),
              "t:1: image 'map': 'expr' has 5 components; an image has 1 to 4");
}

TEST(ReadImages, SaysWhatIsWrongWithACube) {
    EXPECT_THAT(Complaint("sky = { cube = true, file = 'x' }"), HasSubstr("must be a list"));
    EXPECT_EQ(Complaint("sky = { cube = true, file = ['x'] }"),
              "t:1: image 'sky': 'file' of a cube must list its six faces: +x, -x, +y, -y, +z, -z");
    EXPECT_EQ(Complaint("sky = { cube = true, expr = 'x', size = [4, 2] }"),
              "t:1: image 'sky': 'size': a cube's faces are squares");
    EXPECT_EQ(Complaint("sky = { cube = true, expr = 'u', size = [4, 4] }"),
              "t:1:30: 'u' is no input");
    EXPECT_EQ(Complaint("sky = { cube = true, expr = 'x', size = [4, 4], wrap = 'clamp' }"),
              "t:1: image 'sky': 'wrap' has no meaning for a cube");
    EXPECT_THAT(Complaint("sky = { cube = true, expr = 'x', size = [4096, 4096] }"),
                HasSubstr("texels in all"));
}

}  // namespace
}  // namespace etalon
