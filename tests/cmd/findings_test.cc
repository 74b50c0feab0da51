// `etalon run --findings` on null:echo, which gives x back whatever is asked of it.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class FindingsTest : public testing::Test {
  protected:
    FindingsTest() {
        folder_.Write("f.glsl", "\n");
        folder_.Write("cases/right.toml", Case("x"));
        folder_.Write("cases/wrong.toml", Case("x + 1.0"));
        options_.folder = folder_.path();
    }
    static std::string Case(const std::string& call, const std::string& spec = "device") {
        return "source = \"f.glsl\"\ncall = \"" + call + "\"\naccept = { spec = \"" + spec +
               "\" }\nrecipes = [\"spirv\"]\n[domain]\nx = { values = [1.5, 64.0, 0.25] }\n";
    }
    Finished Run(std::vector<std::string> more) {
        more.insert(more.begin(), {"run", "-d", "null:echo"});
        return RunEtalon(more, options_);
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(FindingsTest, WhatNoOtherToolCanShowDoesNotStand) {
    const Finished finished = Run({"--findings", "found/all.md", "--json", "r.json"});
    EXPECT_EQ(finished.status, 1) << finished.err << finished.out;
    const std::string text = folder_.Read("found/all.md");
    EXPECT_THAT(text, HasSubstr("held to vulkan-1.3, cases 2, values 6: outside 3, in cases 1; "
                                "without a bound 0\n"));
    EXPECT_THAT(text, HasSubstr("## What stands\n\nNothing.\n\n## What does not stand\n\n"
                                "### `x + 1.0` on null:echo\n\n- case: wrong, recipe spirv\n"
                                "- worst input: x = 0.25 = 0x1p-2 (0x3e800000)\n"
                                "- result: 0.25 = 0x1p-2 (0x3e800000)\n"
                                "- vulkan-1.3 allows: 1.25 = 0x1.4p+0 (0x3fa00000)\n"
                                "- strict binary32: 1.25 = 0x1.4p+0 (0x3fa00000)\n"));
    EXPECT_THAT(text, HasSubstr("3 of 3 values are outside\n"
                                "- does not stand: no other tool runs this device\n"));
    const json run = json::parse(folder_.Read("r.json"));
    ASSERT_EQ(run["findings"].size(), 1u);
    const json& finding = run["findings"][0];
    EXPECT_EQ(finding["devices"], json({"null:echo"}));
    EXPECT_EQ(finding["case"], "wrong");
    EXPECT_EQ(finding["inputs"][0]["word"], 0x3e800000u);
    EXPECT_EQ(finding["strict"]["hex"], "0x1.4p+0");
    EXPECT_EQ(finding["doubt"], "no other tool runs this device");
    EXPECT_EQ(finding["reproducer"], "");
}

TEST_F(FindingsTest, WhatIsAllowedIsNone) {
    const Finished finished = Run({"right", "--findings", "all.md"});
    EXPECT_EQ(finished.status, 0) << finished.err << finished.out;
    EXPECT_THAT(folder_.Read("all.md"), Not(HasSubstr("###")));
}

TEST_F(FindingsTest, OnlyReproducersOfEarlierRunsAreTakenAway) {
    folder_.Write("reproducers/old.c", "// Written by `etalon run --findings`.\n//\n");
    folder_.Write("reproducers/own.c", "int main(void) { return 0; }\n");
    EXPECT_EQ(Run({"right", "--findings", "all.md"}).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "reproducers/old.c"));
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "reproducers/own.c"));
}

TEST_F(FindingsTest, BadInput) {
    EXPECT_THAT(Run({"right", "--findings", "f.glsl/all.md"}).err,
                HasSubstr("etalon: --findings: f.glsl/reproducers: "));
    folder_.Write("cases/unknown.toml", Case("x", "mine"));
    EXPECT_THAT(Run({"unknown"}).err,
                AllOf(HasSubstr("cases/unknown.toml:3: "), HasSubstr("there is no 'mine'"),
                      HasSubstr("'device' for the device's own")));
}

}  // namespace
}  // namespace etalon
