// The evaluator as a device: what it cannot evaluate, and what it stops, is told with its place.
#include <gmock/gmock.h>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

constexpr const char* kShader = R"(
float endless(float x)
{
    float y = x;
    while (y > 0.0) {
        y += 1.0;
    }
    return y;
}

float chosen(int i)
{
    float all[3] = float[3](1.0, 2.0, 4.0);
    return all[i];
}

double twice(float x)
{
    return double(x) * 2.0;
}
)";

class Cpu : public testing::Test {
  protected:
    Cpu() {
        folder_.Write("f.glsl", kShader);
        options_.folder = folder_.path();
    }
    Finished Probe(const std::string& call, const std::string& at,
                   const std::string& recipe = "spirv") {
        return RunEtalon({"probe", "f.glsl", call, "--at", at, "-d", "cpu", "--recipe", recipe},
                         options_);
    }
    Finished Run(const std::string& call, const std::string& domain) {
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\ncall = \"" + call +
                                          "\"\noracle = \"0\"\naccept = { ulp = 1 }\n[domain]\n" +
                                          domain + "\n");
        return RunEtalon({"run", "-d", "cpu", "--recipe", "spirv"}, options_);
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(Cpu, ALoopWithoutEndIsStopped) {
    const Finished probe = Probe("endless(x)", "x=1");
    EXPECT_EQ(probe.status, 1);
    EXPECT_EQ(probe.out, "");
    EXPECT_THAT(probe.err, MatchesRegex("fail: cpu \\(spirv\\): row 0: (.*: )?in endless: a loop "
                                        "does not end within [0-9]+ steps\n"));
    EXPECT_EQ(Probe("endless(x)", "x=-1").status, 0);
    const Finished run = Run("endless(x)", "x = { values = [-1.0, 0.0, 2.0] }");
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.out, HasSubstr("c on cpu (spirv): fail\n  reason    row 2: "));
    EXPECT_THAT(run.out, HasSubstr("in endless: a loop does not end within "));
}

TEST_F(Cpu, AnIndexOutOfRangeIsStopped) {
    const Finished probe = Probe("chosen(i)", "i:int=3");
    EXPECT_EQ(probe.status, 1);
    EXPECT_THAT(probe.err,
                MatchesRegex("fail: cpu \\(spirv\\): row 0: (.*: )?in chosen: index 3 is "
                             "outside of 3 elements\n"));
    EXPECT_EQ(Probe("chosen(i)", "i:int=2").status, 0);
}

TEST_F(Cpu, WhatItDoesNotKnowIsSkippedByName) {
    const Finished wide = Probe("float(twice(x))", "x=1");
    EXPECT_EQ(wide.status, 2);
    EXPECT_EQ(wide.err,
              "skipped: cpu (spirv): function 'twice': 64-bit floats are not supported\n"
              "etalon: no device can run this probe\n");
    const std::string none = "\netalon: no device can run this probe\n";
    EXPECT_EQ(Probe("endless(x)", "x=-1", "spirv+fragment").err,
              "skipped: cpu has no fragment stage for probes" + none);
    EXPECT_EQ(Probe("endless(x)", "x=-1", "glsl").err, "skipped: cpu takes no GLSL text" + none);
}

}  // namespace
}  // namespace etalon
