// What an explanation tells of an input, on the device that is the strict reading itself.
#include "run/explain.h"

#include <gmock/gmock.h>

#include "run/explain_device.h"
#include "spirv/read.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;

Result<Explanation> ExplainOn(const std::string& device, const std::filesystem::path& root,
                              const std::string& pattern, const std::string& at,
                              const std::string& output = "") {
    ExplainChoice choice;
    choice.root = root;
    choice.pattern = pattern;
    choice.at = at;
    choice.output = output;
    choice.devices.patterns = {device};
    return Explain(choice);
}

TEST(Explain, MarksTheDifferenceOfNearlyEqualNumbers) {
    const auto explained =
        ExplainOn("cpu", "tests/readme", "lens/sagitta", "radius=50,aperture=0x1.a1d89ap-4");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    ASSERT_EQ(explained->steps.size(), 5u);
    EXPECT_EQ(explained->worst_step, 5u);
    const ExplainedStep& worst = explained->steps[4];
    EXPECT_EQ(worst.operation, "radius - #4");
    EXPECT_EQ(worst.file, "tests/readme/shaders/lens.glsl");
    EXPECT_EQ(worst.line, 4u);
    EXPECT_EQ(worst.text, "return radius - sqrt(radius * radius - aperture * aperture);");
    EXPECT_NEAR(worst.values[0].lost_bits, 19, 0.5);
    EXPECT_NEAR(worst.values[0].error_ulp, 3.77e5, 1e3);
    EXPECT_EQ(explained->strict.decimal, "0.00010681152");
    ASSERT_EQ(explained->devices.size(), 1u);
    const Record& record = explained->devices[0].record;
    EXPECT_EQ(record.verdict, Verdict::kFail);
    ASSERT_EQ(record.culprits.size(), 1u);
    EXPECT_EQ(record.culprits[0].first, "rounding");
    EXPECT_FALSE(explained->devices[0].parting.happens);
    const std::string text = ExplanationText(*explained, false);
    EXPECT_THAT(text, HasSubstr("<- 19 bits are lost here"));
    EXPECT_THAT(text, HasSubstr("fail: rounding"));
}

TEST(Explain, HasNothingToMarkWhereNothingIsLost) {
    const auto explained =
        ExplainOn("cpu", "tests/readme", "lens/sagitta_stable", "radius=50,aperture=0.1");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    EXPECT_EQ(explained->worst_step, 0u);
    EXPECT_THAT(ExplanationText(*explained, false), Not(HasSubstr("lost here")));
}

TEST(Explain, TakesTheWorstInputWhereNoneIsGiven) {
    const auto explained = ExplainOn("cpu", "tests/readme", "lens/sagitta", "");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    EXPECT_EQ(explained->chosen, "the worst input on cpu (spirv)");
    EXPECT_EQ(explained->devices[0].record.verdict, Verdict::kFail);
}

class ExplainCaseTest : public testing::Test {
  protected:
    Result<Explanation> ExplainOf(const std::string& glsl, const std::string& toml,
                                  const std::string& at, const std::string& output = "") {
        folder_.Write("f.glsl", glsl);
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\n" + toml);
        return ExplainOn("cpu", folder_.path(), "c", at, output);
    }
    Folder folder_;
};

constexpr const char* kDomain = "[domain]\nx = { values = [1.0, 2.0] }\n";

TEST_F(ExplainCaseTest, SpeaksTheSourcesWords) {
    const auto explained = ExplainOf(
        "struct Ray { vec3 start; float t; };\n"
        "float f(float x) {\n"
        "  Ray ray; ray.start = vec3(x, 2.0, 3.0) * x;\n"
        "  ray.t = dot(ray.start.zyx, vec3(1.0));\n"
        "  float sum = 0.0;\n"
        "  for (int i = 0; i < 2; ++i) { sum += ray.start[i]; }\n"
        "  if (sum > ray.t) { return 0.0; }\n"
        "  return mix(sum, ray.t, 0.25); }\n",
        std::string("call = \"f(x) + x\"\noracle = \"x\"\naccept = { ulp = 4 }\n") + kDomain,
        "x=1.5");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    std::vector<std::string> operations;
    for (const ExplainedStep& step : explained->steps) {
        operations.push_back((step.name.empty() ? "" : step.name + " = ") + step.operation);
    }
    EXPECT_THAT(operations,
                testing::ElementsAre("ray.start = vec3(x, 2.0, 3.0) * x",
                                     "ray.t = dot(ray.start.zyx, vec3(1.0))",
                                     "sum = sum + ray.start[i]", "sum = sum + ray.start[i]",
                                     "sum > ray.t", "mix(sum, ray.t, 0.25)", "#6 + x"));
    EXPECT_EQ(explained->steps[5].line, 8u);
    EXPECT_TRUE(explained->steps[4].is_decision);
    EXPECT_EQ(explained->steps[4].values[0].strict.decimal, "false");
    // The call stands in the case's own file.
    EXPECT_THAT(explained->steps[6].file, HasSubstr("cases/c.toml"));
    EXPECT_EQ(explained->steps[6].line, 2u);
    EXPECT_EQ(explained->steps[6].text, "f(x) + x");
}

TEST_F(ExplainCaseTest, TellsADecisionThatExactOperandsTakeOtherwise) {
    const auto explained = ExplainOf(
        "float f(float x) { float y = (x + 1.0) - 1.0; return y > 0.0 ? 2.0 * x : 3.0 * x; }\n",
        std::string("call = \"f(x)\"\noracle = \"2 * x\"\naccept = { ulp = 4 }\n") + kDomain,
        "x=1e-12");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    EXPECT_TRUE(explained->steps[2].decides_otherwise);
    EXPECT_THAT(ExplanationText(*explained, false),
                HasSubstr("<- exact operands decide otherwise"));
}

TEST_F(ExplainCaseTest, ALongPathIsShortened) {
    const auto explained = ExplainOf(
        "float f(float x) { for (int i = 0; i < 100; ++i) { x *= 1.01; } return x - 2.7; }\n",
        std::string("call = \"f(x)\"\noracle = \"x\"\naccept = { ulp = 4 }\n") + kDomain, "x=1");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    EXPECT_EQ(explained->steps.size(), 101u);
    EXPECT_EQ(explained->worst_step, 101u);
    const auto lines = [&](bool all) {
        const std::string text = ExplanationText(*explained, all);
        return std::count(text.begin(), text.end(), '\n');
    };
    EXPECT_LT(lines(false), 75);
    EXPECT_GT(lines(true), 101);
    EXPECT_THAT(ExplanationText(*explained, false), HasSubstr(" operations\n"));
}

TEST_F(ExplainCaseTest, ALawsLeftSideIsExplained) {
    const auto explained = ExplainOf(
        "float f(float x) { return 1.0 / x; }\n",
        std::string("call = \"f(x)\"\n[[law]]\nname = \"inverse\"\nholds = \"f(f(x)) == x\"\n"
                    "within = { ulp = 0.1 }\n") +
            kDomain,
        "x=7");
    ASSERT_TRUE(explained.ok()) << explained.error().message;
    EXPECT_EQ(explained->output, "left side of law 'inverse'");
    EXPECT_EQ(explained->steps.size(), 2u);
    EXPECT_EQ(explained->devices[0].record.verdict, Verdict::kFail);
}

TEST_F(ExplainCaseTest, ASpecificationIsNamedAsTheRule) {
    const auto rule = [&](const std::string& spec) {
        const auto explained =
            ExplainOf("float f(float x) { return x * x; }\n",
                      "call = \"f(x)\"\naccept = { spec = \"" + spec + "\" }\n" + kDomain, "x=1.5");
        return explained.ok() ? explained->rule : explained.error().message;
    };
    EXPECT_EQ(rule("vulkan-1.3"), "spec vulkan-1.3");
    EXPECT_EQ(rule("device"), "the device's own specification");
}

TEST_F(ExplainCaseTest, AnOutputIsChosenByName) {
    const std::string glsl = "float f(float x, out vec2 v) { v = vec2(x, x * 3.0); return x; }\n";
    const std::string toml = std::string(
                                 "call = \"f(x, v)\"\nout = { v = \"vec2\" }\n"
                                 "oracle = { result = \"x\", v = \"vec2(x, 3 * x)\" }\n"
                                 "accept = { ulp = 4 }\n") +
                             kDomain;
    EXPECT_EQ(ExplainOf(glsl, toml, "x=1")->output, "result");
    EXPECT_EQ(ExplainOf(glsl, toml, "x=1", "v")->output, "v.x");
    EXPECT_EQ(ExplainOf(glsl, toml, "x=1", "v.y")->output, "v.y");
    EXPECT_EQ(ExplainOf(glsl, toml, "x=1", "w").error().message,
              "--output: the case judges no 'w'; it judges 'result', 'v.x', 'v.y'");
}

TEST_F(ExplainCaseTest, WhatCannotBeEvaluatedIsAnError) {
    const auto explained = ExplainOf(
        "float f(float x) { return dFdx(x); }\n",
        std::string("call = \"f(x)\"\noracle = \"x\"\naccept = { ulp = 4 }\n") + kDomain, "x=1");
    EXPECT_EQ(explained.error().message,
              "c: cannot be explained: it compiles in a fragment shader only, and the evaluator "
              "knows no others than compute shaders");
}

TEST(ExplainErrors, AreTold) {
    const auto error = [](const std::string& pattern, const std::string& at) {
        return ExplainOn("cpu", "tests/readme", pattern, at).error().message;
    };
    EXPECT_EQ(error("lens/none", "x=1"), "no case is called 'lens/none'; `etalon list` shows them");
    EXPECT_EQ(error("lens", "x=1"),
              "'lens' names 2 cases, and one is explained; `etalon list` shows them");
    EXPECT_EQ(error("lens/sagitta", "radius=1"), "--at: no value for input 'aperture'");
}

// A device that has contracted: its sum is told from a rounded one.
class PartingTextTest : public testing::Test {
  protected:
    // Of the result of the last operation of f(a, b, c).
    std::string TextOf(const std::string& expression, std::uint32_t word, const char* qualifier) {
        folder_.Write("f.glsl", std::string("float f(float a, float b, float c) { ") + qualifier +
                                    " float r = " + expression + "; return r; }\n");
        folder_.Write("cases/c.toml",
                      "source = \"f.glsl\"\ncall = \"f(a, b, c)\"\noracle = \"a * b + c\"\n"
                      "accept = { ulp = 4 }\n[domain]\na = { values = [1.1] }\n"
                      "b = { values = [1.3] }\nc = { values = [-1.43] }\n");
        const Case source = *ReadCase(folder_.path(), "c");
        Subject subject;
        subject.prepared = *PrepareAt(source, "a=1.1,b=1.3,c=-1.43");
        StrictPath path;
        path.program =
            *Compile(subject.call(), subject.signature(), Recipe{}, Target{}, {}, Lines::kKept);
        path.plan = *evaluate::MakePlan(*spirv::ReadModule(path.program.spirv));
        path.trace = *evaluate::TraceRow(path.plan, {}, subject.rows().words, 1);
        Parting parting;
        parting.kind = Parting::Kind::kOperation;
        parting.step = path.trace.steps.size() - 1;
        parting.word = word;
        const SourceTerms terms(path.plan->module);
        return PartingText(subject, path, terms, *evaluate::FindProfile("vulkan-1.3"), parting)
            .text;
    }
    Folder folder_;
};

TEST_F(PartingTextTest, KnowsAContraction) {
    const auto fused = std::bit_cast<std::uint32_t>(std::fma(1.1f, 1.3f, -1.43f));
    EXPECT_THAT(
        TextOf("a * b + c", fused, ""),
        HasSubstr("contracted with the product #1, which is not rounded; vulkan-1.3 allows"));
    EXPECT_THAT(TextOf("a * b + c", fused, "precise"), HasSubstr("vulkan-1.3 forbids that"));
    EXPECT_THAT(TextOf("-c - a * b", fused ^ 0x80000000u, ""), HasSubstr("allows that"));
    EXPECT_THAT(TextOf("a * b + c", fused + 1, ""), Not(HasSubstr("contracted")));
}

}  // namespace
}  // namespace etalon
