// The explanation as a person reads it.
#include <gmock/gmock.h>

#include "report/explanation.h"
#include "report/records.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::Not;

ExplainedStep Step(std::uint32_t number, double error, double lost) {
    ExplainedStep step;
    step.number = number;
    step.file = "a.glsl";
    step.line = number / 10 + 1;
    step.text = "x = x * y;";
    step.name = "x";
    step.operation = "x * y";
    ExplainedValue value;
    value.strict = {"0.5", "0x1p-1"};
    value.exact = {"0.25", "0x1p-2"};
    value.error_ulp = error;
    value.amplification = 2;
    value.lost_bits = lost;
    value.reaches_output = true;
    step.values.push_back(value);
    return step;
}

Explanation Explained(std::uint32_t steps) {
    Explanation explanation;
    explanation.case_path = "optics/fresnel";
    explanation.inputs = {{"n1", {"1.5", "0x1.8p+0"}}};
    explanation.output = "result.x";
    explanation.rule = "ulp 16";
    explanation.truth = Value{"0.25", "0x1p-2"};
    explanation.method = {"0.25", "0x1p-2"};
    explanation.strict = {"0.5", "0x1p-1"};
    for (std::uint32_t i = 1; i <= steps; ++i) {
        explanation.steps.push_back(Step(i, 1, 0));
    }
    ExplainedDevice device;
    device.record = Refused();
    device.record.culprits = {{"rounding", 1}};
    device.record.profile = "glsl-4.60";
    device.record.worst->allowed = AllowedValue{true, {"0.25", "0x1p-2"}, {"0.5", "0x1p-1"}, 0, {}};
    device.record.worst->budget = Budget{"rounding", false, PartSeen{0, 0}, {0.25, 7}, {0, 0}};
    device.result = {"0.5", "0x1p-1"};
    device.parting.text = "every operation yields what binary32 does";
    explanation.devices.push_back(device);
    return explanation;
}

TEST(ExplanationText, IsOneTable) {
    Explanation explanation = Explained(2);
    explanation.steps[1].values[0].error_ulp = 4096;
    explanation.worst_step = 2;
    explanation.steps[1].values[0].lost_bits = 12;
    EXPECT_EQ(ExplanationText(explanation, false),
              "case      optics/fresnel\n"
              "input     n1=1.5\n"
              "          n1=0x1.8p+0\n"
              "output    result.x, by ulp 16\n"
              "truth     0.25\n"
              "exact     0.25, the program without rounding\n"
              "binary32  0.5, each operation rounded, in source order\n"
              "allowed   0.25 to 0.5, by glsl-4.60\n"
              "\n"
              "device           recipe  result  method  rounding  driver  verdict\n"
              "osmesa:llvmpipe  glsl    0.5     0 ulp   7 ulp     0 ulp   fail: rounding\n"
              "\n"
              "#   operation  binary32  exact  error        amplified\n"
              "a.glsl:1: x = x * y;\n"
              "#1  x = x * y  0.5       0.25   1 ulp        2x\n"
              "#2  x = x * y  0.5       0.25   4.1e+03 ulp  2x         <- 12 bits are lost here\n"
              "\n"
              "osmesa:llvmpipe  glsl  every operation yields what binary32 does\n");
}

TEST(ExplanationText, ComponentsAreRowsOfTheirOwn) {
    Explanation explanation = Explained(1);
    explanation.steps[0].values.push_back(explanation.steps[0].values[0]);
    explanation.steps[0].values[0].part = ".x";
    explanation.steps[0].values[1].part = ".y";
    EXPECT_THAT(ExplanationText(explanation, false), HasSubstr("x.y = x * y"));
    explanation.steps[0].name.clear();
    EXPECT_THAT(ExplanationText(explanation, false), HasSubstr("x * y  .y"));
}

TEST(ExplanationText, MarksWhereADevicePartsAndWhatIsDecidedOtherwise) {
    Explanation explanation = Explained(2);
    explanation.devices[0].parting.happens = true;
    explanation.devices[0].parting.step = 1;
    explanation.steps[1].is_decision = true;
    explanation.steps[1].decides_otherwise = true;
    const std::string text = ExplanationText(explanation, false);
    EXPECT_THAT(text, HasSubstr("2x         <- osmesa:llvmpipe parts here\n"));
    EXPECT_THAT(text, HasSubstr("<- exact operands decide otherwise\n"));
}

TEST(ExplanationText, OfALongPathTheEndsAndWhatIsOfInterest) {
    Explanation explanation = Explained(200);
    explanation.steps[99].values[0].lost_bits = 3;
    explanation.steps[119].decides_otherwise = true;
    explanation.devices[0].parting.happens = true;
    explanation.devices[0].parting.step = 150;
    const std::string text = ExplanationText(explanation, false);
    for (const char* shown :
         {"\n#1 ", "\n#20 ", "\n#100 ", "\n#120 ", "\n#150 ", "\n#181 ", "\n#200 "}) {
        EXPECT_THAT(text, HasSubstr(shown));
    }
    for (const char* left_out : {"\n#90 ", "\n#110 ", "\n#160 "}) {
        EXPECT_THAT(text, Not(HasSubstr(left_out)));
        EXPECT_THAT(ExplanationText(explanation, true), HasSubstr(left_out));
    }
    EXPECT_THAT(text, HasSubstr("   ... 29 operations\n"));
    explanation.is_cut = true;
    EXPECT_THAT(ExplanationText(explanation, true), HasSubstr("the path is longer"));
}

TEST(ExplanationText, WithoutOperationsOnFloatsSaysSo) {
    Explanation explanation = Explained(0);
    explanation.inputs = {{"k", {"3", "3"}}};
    const std::string text = ExplanationText(explanation, false);
    EXPECT_THAT(text, HasSubstr("no operation on floats"));
    EXPECT_THAT(text, Not(HasSubstr("binary32  exact")));
    EXPECT_THAT(text, HasSubstr("input     k=3\noutput"));
}

TEST(ExplanationText, ADeviceWithoutAResultSaysWhy) {
    Explanation explanation = Explained(1);
    ExplainedDevice device;
    device.record.device = "vulkan:silent";
    device.record.recipe = "glsl";
    device.record.verdict = Verdict::kSkip;
    device.record.reason = "takes no GLSL text";
    explanation.devices = {device};
    EXPECT_THAT(ExplanationText(explanation, false),
                HasSubstr("vulkan:silent  glsl    -       -       -         -       skip: takes no "
                          "GLSL text\n"));
}

}  // namespace
}  // namespace etalon
