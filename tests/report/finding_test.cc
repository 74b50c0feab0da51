#include "report/finding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/records.h"

namespace etalon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

Finding Exp2() {
    Finding finding;
    finding.devices = {"osmesa:llvmpipe", "egl:llvmpipe"};
    finding.case_path = "specification/exp2";
    finding.call = "exp2(x)";
    finding.recipe = "glsl";
    finding.profile = "glsl-4.60";
    finding.output = "result";
    finding.inputs = {{"x", "-0.0625", "-0x1p-4", 0xbd800000u}};
    finding.actual = {"", "3", "0x1.8p+1", 0x40400000u};
    finding.strict = {"", "1.5", "0x1.8p+0", 0x3fc00000u};
    finding.low = {"", "1", "0x1p+0", 0x3f800000u};
    finding.high = {"", "2", "0x1p+1", 0x40000000u};
    finding.excess = 4;
    finding.outside = 7;
    finding.held = 100;
    finding.cause = "bug: a polynomial";
    finding.reproducer = "osmesa-llvmpipe-exp2.shader_test";
    return finding;
}

TEST(FindingsMarkdown, TellsAllThatAFindingIs) {
    RunRecord run;
    run.devices = {Llvmpipe()};
    run.findings = {Exp2()};
    EXPECT_THAT(FindingsMarkdown(run, "reproducers"),
                HasSubstr("## What stands\n\n"
                          "### `exp2(x)` on osmesa:llvmpipe, egl:llvmpipe\n\n"
                          "- case: specification/exp2, recipe glsl\n"
                          "- worst input: x = -0.0625 = -0x1p-4 (0xbd800000)\n"
                          "- result: 3 = 0x1.8p+1 (0x40400000)\n"
                          "- glsl-4.60 allows: 1 = 0x1p+0 (0x3f800000) to 2 = 0x1p+1 (0x40000000)\n"
                          "- strict binary32: 1.5 = 0x1.8p+0 (0x3fc00000)\n"
                          "- outside by: 4 ulp; 7 of 100 values are outside\n"
                          "- cause: bug: a polynomial\n"
                          "- reproducer: [osmesa-llvmpipe-exp2.shader_test]"
                          "(reproducers/osmesa-llvmpipe-exp2.shader_test)\n\n"
                          "## What does not stand\n\nNothing.\n"));
}

TEST(FindingsMarkdown, KeepsWhatDoesNotStandApart) {
    RunRecord run;
    run.devices = {Llvmpipe()};
    run.findings = {Exp2()};
    run.findings[0].doubt = "the strict evaluation lies outside too";
    run.findings[0].reproducer.clear();
    run.findings[0].high = run.findings[0].low;
    const std::string text = FindingsMarkdown(run, "reproducers");
    EXPECT_THAT(text, HasSubstr("## What stands\n\nNothing.\n\n## What does not stand\n\n### `"));
    EXPECT_THAT(text, HasSubstr("- glsl-4.60 allows: 1 = 0x1p+0 (0x3f800000)\n"));
    EXPECT_THAT(text, HasSubstr("- does not stand: the strict evaluation lies outside too\n"));
    EXPECT_THAT(text, Not(HasSubstr("reproducers/")));
}

TEST(FindingsMarkdown, CountsWhatEachDeviceWasHeldTo) {
    RunRecord run;
    run.devices = {Llvmpipe(), Silent()};
    Record record = Passed();
    record.profile = "glsl-4.60";
    record.held = 10;
    record.unbounded = 3;
    run.records = {record, record};
    run.records[1].recipe = "spirv";
    run.records[1].outside = 2;
    const std::string text = FindingsMarkdown(run, "reproducers");
    EXPECT_THAT(text, HasSubstr("; held to glsl-4.60, cases 1, values 20: outside 2, in cases 1; "
                                "without a bound 6\n"));
    EXPECT_THAT(text, HasSubstr("- vulkan:silent@new: "));
    EXPECT_THAT(text, HasSubstr("; held to nothing\n"));
}

}  // namespace
}  // namespace etalon
