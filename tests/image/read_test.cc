#include "image/read.h"

#include <gmock/gmock.h>

#include "image/exr_file.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::StartsWith;

class ReadImageTest : public testing::Test {
  protected:
    Image Read(const std::string& bytes) {
        const auto image = ReadImage(folder_.Write("image", bytes));
        EXPECT_TRUE(image) << image.error().message;
        return image ? *image : Image{};
    }
    std::string Complaint(const std::string& bytes) {
        const std::string file = folder_.Write("image", bytes);
        const auto image = ReadImage(file);
        if (image) {
            return "";
        }
        EXPECT_THAT(image.error().message, StartsWith(file + ": "));
        EXPECT_EQ(image.error().message.find('\n'), std::string::npos);
        return image.error().message.substr(file.size() + 2);
    }

    Folder folder_;
};

TEST_F(ReadImageTest, TakesBitsAsZeroToOne) {
    const Image image = Read(std::string("P6 2 1 255\n\x00\x33\xff\xff\x00\x00", 17));
    EXPECT_TRUE(IsWhole(image));
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.height, 1u);
    EXPECT_EQ(image.levels, 1u);
    EXPECT_THAT(image.rgba, ElementsAre(0.0f, 0.2f, 1.0f, 1.0f, 1.0f, 0.0f, 0.0f, 1.0f));
}

TEST_F(ReadImageTest, TakesAllSixteenBitsOfAPng) {
    // Two grey texels, 1 and 65535.
    constexpr unsigned char kPng[] = {
        137, 80, 78, 71,  13, 10, 26, 10, 0,   0,   0,   13,  73,  72,  68,  82, 0, 0,  0,
        2,   0,  0,  0,   1,  16, 0,  0,  0,   0,   129, 217, 252, 21,  0,   0,  0, 16, 73,
        68,  65, 84, 120, 1,  1,  5,  0,  250, 255, 0,   0,   1,   255, 255, 3,  5, 2,  0,
        187, 43, 15, 54,  0,  0,  0,  0,  73,  69,  78,  68,  174, 66,  96,  130};
    const Image image = Read(std::string(reinterpret_cast<const char*>(kPng), sizeof kPng));
    const float least = 1 / 65535.0f;
    EXPECT_THAT(image.rgba, ElementsAre(least, least, least, 1, 1, 1, 1, 1));
}

TEST_F(ReadImageTest, TakesAnOpenExrFileAsItIs) {
    ExrFile file;
    file.left = -3;
    file.top = 7;
    file.width = 2;
    file.height = 2;
    file.channels = {{"R", {1e30f, -2, 3, 4}},
                     {"G", {5, 6, 7, 8}},
                     {"B", {9, 10, 11, -0.0f}},
                     {"A", {0.5f, 0.25f, 0, 2}}};
    const Image image = Read(file.Bytes());
    EXPECT_TRUE(IsWhole(image));
    EXPECT_EQ(image.width, 2u);
    EXPECT_EQ(image.height, 2u);
    EXPECT_THAT(image.rgba, ElementsAreArray({1e30f, 5.0f, 9.0f, 0.5f, -2.0f, 6.0f, 10.0f, 0.25f,
                                              3.0f, 7.0f, 11.0f, 0.0f, 4.0f, 8.0f, -0.0f, 2.0f}));
}

TEST_F(ReadImageTest, FillsTheChannelsThatAnOpenExrFileLacks) {
    ExrFile file;
    file.channels = {{"G", {3}}, {"Z", {8}}};
    EXPECT_THAT(Read(file.Bytes()).rgba, ElementsAre(0, 3, 0, 1));
    file.channels = {{"Y", {3}}};
    EXPECT_THAT(Read(file.Bytes()).rgba, ElementsAre(3, 3, 3, 1));
    file.channels = {{"Y", {3}}, {"A", {0.5f}}};
    EXPECT_THAT(Read(file.Bytes()).rgba, ElementsAre(3, 3, 3, 0.5f));
}

TEST_F(ReadImageTest, RefusesWhatIsNoImage) {
    EXPECT_THAT(Complaint("no image"), StartsWith("is not an image ("));
    EXPECT_THAT(Complaint(""), StartsWith("is not an image ("));
    EXPECT_EQ(Complaint("P5 20000 20000 255\n"), "has 20000 x 20000 texels, too many");
    EXPECT_EQ(Complaint("P5 20000 1 255\n"), "has 20000 x 1 texels, too many");
    EXPECT_EQ(Complaint(std::string("P5 1 1 65535\n\x00\x01", 15)),
              "is a PNM file of 16 bits, which cannot be read; PNG and OpenEXR can");

    ExrFile file;
    file.channels = {{"diffuse.R", {3}}};
    EXPECT_EQ(Complaint(file.Bytes()), "has none of the channels R, G, B, A and Y");
    const std::string bytes = ExrFile{.channels = {{"R", {3}}}}.Bytes();
    EXPECT_EQ(Complaint(bytes), "");
    for (std::size_t size = 4; size < bytes.size(); ++size) {
        EXPECT_THAT(Complaint(bytes.substr(0, size)), StartsWith("is not an OpenEXR image ("))
            << size;
    }
    ExrFile coarse{.width = 2, .height = 2, .sampling = 2};
    coarse.channels = {{"Y", {1, 1, 1, 1}}};
    EXPECT_EQ(Complaint(coarse.Bytes()), "has a channel of another resolution than the image's");
    ExrFile wide;
    wide.channels = {{"R", {3}}};
    std::string huge = wide.Bytes();
    // The window's right edge: its least byte follows name, type, size, left and top.
    huge[huge.find("dataWindow") + 11 + 6 + 4 + 8 + 2] = '\x7f';
    EXPECT_EQ(Complaint(huge), "has 8323073 x 1 texels, too many");
    EXPECT_EQ(ReadImage(folder_.path() / "none").error().message,
              (folder_.path() / "none").string() + ": No such file or directory");
}

// No crash and no huge allocation, whatever is wrong.
TEST_F(ReadImageTest, SurvivesAnyBytes) {
    const std::string good =
        ExrFile{.width = 2, .height = 2, .channels = {{"R", {1, 2, 3, 4}}}}.Bytes();
    for (std::size_t at = 4; at < good.size(); ++at) {
        for (const char value : {'\x7f', '\xff', '\x00'}) {
            std::string bad = good;
            bad[at] = value;
            (void)Complaint(bad);
        }
    }
}

}  // namespace
}  // namespace etalon
