#include "run/images.h"

#include <gmock/gmock.h>

#include <cmath>

#include "case/read_images.h"
#include "image/write.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class ImagesTest : public testing::Test {
  protected:
    Result<Image> Make(const std::string& text) const {
        const auto sources = ReadImages(text, "t");
        EXPECT_TRUE(sources) << sources.error().message;
        return MakeImage(sources->front(), folder_.path());
    }
    Image Made(const std::string& text) const {
        const auto image = Make(text);
        EXPECT_TRUE(image) << image.error().message;
        EXPECT_TRUE(IsWhole(*image));
        return *image;
    }
    void Write(const std::string& name, const Image& image) const {
        EXPECT_TRUE(WriteExr(folder_.path() / name, image));
    }

    Folder folder_;
};

TEST_F(ImagesTest, AreComputedAtTexelCentres) {
    EXPECT_THAT(Made("m = { expr = ['u', 'v', 'i + 10 * j'], size = [2, 2] }").rgba,
                ElementsAre(0.25f, 0.25f, 0, 1, 0.75f, 0.25f, 1, 1,  //
                            0.25f, 0.75f, 10, 1, 0.75f, 0.75f, 11, 1));
}

TEST_F(ImagesTest, HaveZeroAndOneWhereNothingIsSaid) {
    EXPECT_THAT(Made("m = { expr = 7, size = [1, 1] }").rgba, ElementsAre(7, 0, 0, 1));
    EXPECT_THAT(Made("m = { expr = ['vec3(1, 2, 3)', 4], size = [1, 1] }").rgba,
                ElementsAre(1, 2, 3, 4));
}

TEST_F(ImagesTest, MayCallOracles) {
    EXPECT_FLOAT_EQ(Made("m = { expr = 'fresnel.reflectance(1, 1.5, 1)', size = [1, 1] }").rgba[0],
                    0.04f);
}

TEST_F(ImagesTest, OfCubesAreComputedOverUnitVectors) {
    const Image image = Made("s = { cube = true, expr = ['x', 'y', 'z'], size = [2, 2] }");
    for (std::size_t texel = 0; texel < 24; ++texel) {
        const float* const d = image.rgba.data() + 4 * texel;
        EXPECT_NEAR(std::hypot(d[0], d[1], d[2]), 1, 1e-6);
        // The face's own axis is the longest.
        const std::size_t face = texel / 4;
        EXPECT_NEAR(d[face / 2], (face % 2 == 0 ? 1 : -1) * 0.8164966f, 1e-6) << texel;
    }
    // The first texel of face +x: s and t are a quarter, so that z and y point up.
    EXPECT_GT(image.rgba[1], 0);
    EXPECT_GT(image.rgba[2], 0);
}

TEST_F(ImagesTest, GetTheirLevels) {
    const Image image = Made("m = { expr = 'i', size = [4, 1], levels = true }");
    EXPECT_EQ(image.levels, 3u);
    EXPECT_EQ(image.rgba[LevelStart(image, 1)], 0.5f);
    EXPECT_EQ(image.rgba[LevelStart(image, 2)], 1.5f);
}

TEST_F(ImagesTest, OfFilesMakeACubeFaceByFace) {
    std::string files;
    for (int face = 0; face < 6; ++face) {
        const std::string name = std::to_string(face) + ".exr";
        Write(name, Image{1, 1, {static_cast<float>(face), 0, 0, 1}});
        files += "'" + name + "', ";
    }
    const Image image = Made("s = { cube = true, file = [" + files + "] }");
    for (std::size_t face = 0; face < 6; ++face) {
        EXPECT_EQ(image.rgba[4 * face], static_cast<float>(face));
    }
    Write("5.exr", Image{2, 1, std::vector<float>(8)});
    EXPECT_THAT(Make("s = { cube = true, file = [" + files + "] }").error().message,
                HasSubstr("5.exr: has not the size of the cube's first face"));
    for (int face = 0; face < 6; ++face) {
        Write(std::to_string(face) + ".exr", Image{2, 1, std::vector<float>(8)});
    }
    EXPECT_THAT(Make("s = { cube = true, file = [" + files + "] }").error().message,
                HasSubstr("0.exr: a cube's faces are squares"));
}

TEST_F(ImagesTest, MustBeFinite) {
    EXPECT_EQ(Make("m = { expr = 'sqrt(0.5 - u)', size = [2, 1] }").error().message,
              "t:1: image 'm': 'sqrt(0.5 - u)' is nan at column 1 of row 0: no finite number in "
              "binary32");
    EXPECT_EQ(Make("s = { cube = true, expr = '1e39 * (z > 0.8)', size = [1, 1] }").error().message,
              "t:1: image 's': '1e39 * (z > 0.8)' is 1e+39 at column 0 of row 0 of face 4: no "
              "finite number in binary32");
}

TEST_F(ImagesTest, OneForEachSampler) {
    Write("x.exr", Image{1, 1, {0, 0, 0, 1}});
    Call call;
    ASSERT_TRUE(AddWith({"scene.glsl", "m=x.exr"}, folder_.path(), call));
    EXPECT_THAT(call.with, ElementsAre(folder_.path() / "scene.glsl"));
    const auto again = AddImages(*ReadImages("m = { file = 'x.exr' }", "t"), folder_.path(), call);
    EXPECT_EQ(again.error().message, "t:1: image 'm': the sampler has an image already");
    EXPECT_FALSE(AddWith({"m=x.exr"}, folder_.path(), call));
    const auto missing = AddImages(*ReadImages("n = { file = 'no' }", "t"), folder_.path(), call);
    EXPECT_THAT(missing.error().message, HasSubstr("t:1: image 'n': "));
    EXPECT_THAT(missing.error().message, HasSubstr("no: No such file or directory"));
}

}  // namespace
}  // namespace etalon
