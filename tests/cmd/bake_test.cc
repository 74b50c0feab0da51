// `etalon bake`, and the maps that cases and probes bake for themselves.
#include <gmock/gmock.h>

#include <cstdlib>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class Bake : public testing::Test {
  protected:
    Bake() {
        options_.folder = folder_.path();
        // 4 x 2 heights, 0 to 1.
        folder_.Write("h.pgm", std::string("P5 4 2 255\n\x00\x33\x66\x99\xcc\xff\x33\x00", 19));
        folder_.Write(
            "read.glsl",
            "uniform sampler2D map;\n"
            "float at(float u, float v) { return textureLod(map, vec2(u, v), 0.0).x; }\n");
    }
    Finished Run(std::vector<std::string> words) { return RunEtalon(words, options_); }

    std::string Complaint(const std::vector<std::string>& words) {
        const Finished finished = Run(words);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        EXPECT_EQ(Lines(finished.err).size(), 1u) << finished.err;
        return finished.err;
    }
    // The map's value in the middle of a texel.
    double Read(const std::string& image, const std::string& at) {
        const Finished finished = Run({"probe", "read.glsl", "at(u, v)", "--at", at, "--csv", "-d",
                                       SoftwareDevice(), "--image", "map=" + image});
        EXPECT_EQ(finished.status, 0) << finished.err;
        const std::string line = Lines(finished.out).back();
        return std::atof(line.substr(line.rfind(',') + 1).c_str());
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(Bake, WritesTheMap) {
    for (const std::string kind : {"distance", "cone", "relaxed-cone", "max-mip", "horizon"}) {
        const Finished finished = Run({"bake", kind, "h.pgm", "-o", kind + ".exr"});
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(finished.out + finished.err, "");
        EXPECT_THAT(folder_.Read(kind + ".exr"), StartsWith("\x76\x2f\x31\x01"));
    }
}

TEST_F(Bake, AFileFillsTheBox) {
    ETALON_NEED_DEVICE();
    ASSERT_EQ(Run({"bake", "max-mip", "h.pgm", "-o", "m.exr"}).status, 0);
    // Level 0, cell (0, 0): of the texels 0, 0x33, 0xcc and 0xff.
    const std::string written = "{ file = \"m.exr\", filter = \"nearest\" }";
    EXPECT_EQ(Read(written, "u=0.08,v=0.17"), 0.5);
    const std::string here = "{ bake = \"max-mip\", file = \"h.pgm\", filter = \"nearest\"";
    EXPECT_EQ(Read(here + " }", "u=0.08,v=0.17"), 0.5);
    EXPECT_EQ(Read(here + ", scale = 0.5, level = 0.0 }", "u=0.08,v=0.17"), 0.5);
    // An expression is z itself.
    EXPECT_EQ(Read("{ bake = \"max-mip\", expr = \"0.25\", size = [4, 2], filter = \"nearest\" }",
                   "u=0.08,v=0.17"),
              0.25);
}

TEST_F(Bake, WhatIsWrongTakesOneLine) {
    EXPECT_THAT(Complaint({"bake", "cones", "h.pgm", "-o", "x.exr"}), HasSubstr("cones not in"));
    EXPECT_THAT(Complaint({"bake", "cone", "none.png", "-o", "x.exr"}),
                HasSubstr("none.png: No such file"));
    EXPECT_THAT(Complaint({"bake", "cone", "read.glsl", "-o", "x.exr"}),
                HasSubstr("read.glsl: is not an image"));
    EXPECT_THAT(Complaint({"bake", "cone", "h.pgm"}), HasSubstr("--out is required"));
    EXPECT_THAT(Complaint({"bake", "cone", "h.pgm", "-o", "no/x.exr"}), HasSubstr("no/x.exr"));
    EXPECT_THAT(Complaint({"bake", "cone", "h.pgm", "-o", "x.exr", "--slices", "3"}),
                HasSubstr("h.pgm: a map of kind cone has no slices"));
    EXPECT_THAT(Complaint({"bake", "cone", "h.pgm", "-o", "x.exr", "--level", "0"}),
                HasSubstr("h.pgm: the height 0.6 at column 3 of row 0 is beyond the box"));
}

TEST_F(Bake, WhatIsWrongInACaseStandsAtItsPlace) {
    const auto probe = [this](const std::string& image) {
        return Complaint(
            {"probe", "read.glsl", "at(0.5, 0.5)", "-d", "null:echo", "--image", "map=" + image});
    };
    EXPECT_THAT(probe("{ bake = \"cones\", file = \"h.pgm\" }"),
                HasSubstr("'bake' must be one of distance, cone, relaxed-cone, max-mip, horizon"));
    EXPECT_THAT(probe("{ bake = \"cone\", file = \"h.pgm\", levels = true }"),
                HasSubstr("'levels' has no meaning with bake"));
    EXPECT_THAT(probe("{ file = \"h.pgm\", slices = 3 }"), HasSubstr("'slices' belongs to bake"));
    EXPECT_THAT(probe("{ bake = \"horizon\", file = \"h.pgm\", slices = 3 }"),
                HasSubstr("image 'map': a map of kind horizon has no slices"));
    EXPECT_THAT(probe("{ bake = \"cone\", expr = \"u\", size = [4, 4] }"),
                HasSubstr("beyond the box"));
}

}  // namespace
}  // namespace etalon
