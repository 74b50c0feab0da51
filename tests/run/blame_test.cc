// Whom a run blames: the device cpu follows the program strictly, so that only the method and its
// rounding can be at fault; the null device gives x back whatever the program is.

#include "run/blame.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run/case_run.h"
#include "run/devices.h"
#include "run/fit.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class BlameTest : public testing::Test {
  protected:
    // A case of `f(x)` for a body of f; `judgement` is the rest of the case.
    Record Run(const std::string& device, const std::string& body, const std::string& judgement,
               const std::string& type = "float") {
        folder_.Write("f.glsl", type + " f(" + type + " x) { return " + body + "; }\n");
        return RunCall(device, "f(x)", judgement);
    }
    Record RunCall(const std::string& device, const std::string& call,
                   const std::string& judgement) {
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\ncall = \"" + call + "\"\n" + judgement);
        const Result<Case> read = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(read.ok()) << read.error().message;
        const Result<PreparedCase> prepared = Prepare(*read);
        EXPECT_TRUE(prepared.ok()) << prepared.error().message;
        DeviceChoice choice;
        choice.patterns = {device};
        Result<DeviceSet> devices = OpenDevices(choice);
        EXPECT_TRUE(devices.ok()) << devices.error().message;
        Runner& runner = *devices->runners.front();
        Recipe recipe = DefaultRecipe(runner.info());
        recipe.stage = prepared->signature.stage;
        Evaluations evaluations(devices->programs);
        return RunCase(*prepared, runner, recipe, evaluations, {});
    }
    static std::string Judged(const std::string& oracle, const std::string& accept,
                              const std::string& values = "1.5") {
        return "oracle = \"" + oracle + "\"\n" + Accepted(accept, values);
    }
    static std::string Accepted(const std::string& accept, const std::string& values) {
        return "accept = { " + accept + " }\n[domain]\nx = { values = [" + values + "] }\n";
    }
    static std::string Culprit(const Record& record) {
        const Observation* shown = record.Shown();
        return shown == nullptr || !shown->budget ? "nobody" : shown->budget->culprit;
    }

    Folder folder_;
};

TEST_F(BlameTest, TheMethodWhereTheFormulaIsAnother) {
    const Record record = Run("cpu", "2.0 * x", Judged("x", "ulp = 4", "1.5, 0"));
    EXPECT_EQ(record.verdict, Verdict::kFail);
    EXPECT_EQ(Culprit(record), "method");
    EXPECT_THAT(record.culprits, ElementsAre(Pair("method", 1)));
    EXPECT_EQ(record.worst->budget->method->absolute, 1.5);
    EXPECT_EQ(record.worst->budget->rounding.ulp, 0);
    EXPECT_EQ(record.worst->budget->driver.ulp, 0);
}

TEST_F(BlameTest, TheRoundingWhereDigitsAreLost) {
    const Record record = Run("cpu", "(x + 1e6) - 1e6", Judged("x", "ulp = 4", "1.51"));
    EXPECT_EQ(Culprit(record), "rounding");
    EXPECT_EQ(record.worst->budget->method->ulp, 0);
    EXPECT_GT(record.worst->budget->rounding.ulp, 1000);
}

// Binary64 loses the digits too; the method is taken at 128 bits.
TEST_F(BlameTest, TheRoundingWhereBinary64LosesThemAsWell) {
    const Record record = Run("cpu", "(x + 1e20) - 1e20", Judged("x", "ulp = 4"));
    EXPECT_EQ(Culprit(record), "rounding");
    EXPECT_EQ(record.worst->budget->method->ulp, 0);
}

TEST_F(BlameTest, TheDriverOutsideOfWhatIsAllowed) {
    const Record record = Run("null:echo", "x * 2.0", Judged("2 * x", "ulp = 4"));
    EXPECT_EQ(record.verdict, Verdict::kFail);
    EXPECT_EQ(Culprit(record), "driver");
    EXPECT_EQ(record.outside, 1u);
    EXPECT_EQ(record.worst->budget->driver.absolute, 1.5);
    EXPECT_THAT(record.failed, ElementsAre("result"));
}

// A sine may be off by 2^-11, and nothing is said of arguments beyond pi.
TEST_F(BlameTest, TheDriverWithinTheSpecificationOrWhereItIsSilent) {
    const std::string exact = "ulp = 1";
    EXPECT_EQ(Culprit(Run("null:echo", "sin(x)", Judged("sin(x)", exact, "0.1"))),
              "driver, within the specification");
    const Record silent = Run("null:echo", "sin(x)", Judged("sin(x)", exact, "4.0"));
    EXPECT_EQ(Culprit(silent), "driver, where the specification is silent");
    EXPECT_EQ(silent.unbounded, 1u);
    EXPECT_EQ(silent.held, 1u);
    EXPECT_EQ(silent.outside, 0u);
}

TEST_F(BlameTest, NobodyWhereTheProgramCannotBeEvaluated) {
    const Record record = Run("null:echo", "dFdx(x) + x", Judged("x", "ulp = 1", "1.5, 2.5"));
    EXPECT_EQ(record.verdict, Verdict::kPass);
    EXPECT_EQ(record.unevaluated, "its sources compile for fragment shaders only");
    EXPECT_EQ(record.held, 0u);
    EXPECT_FALSE(record.worst->budget);
    EXPECT_EQ(Culprit(Run("null:echo", "dFdx(x) + x", Judged("x + 1", "ulp = 1"))), "nobody");
}

TEST_F(BlameTest, KeepsTheWorstPartsOfWhatPasses) {
    const Record record =
        Run("null:echo", "x + 0.0001 * x * x", Judged("x + 0.00005", "absolute = 1", "0.5, 1.5"));
    ASSERT_EQ(record.parts.size(), 3u);
    EXPECT_EQ(record.parts[0].part, "method");
    EXPECT_EQ(record.parts[0].inputs[0].second.decimal, "1.5");
    EXPECT_NEAR(record.parts[0].seen.absolute, 1.75e-4, 1e-10);
    EXPECT_EQ(record.parts[1].part, "rounding");
    EXPECT_GT(record.parts[1].seen.ulp, 0);
    EXPECT_LT(record.parts[1].seen.ulp, 1);
    EXPECT_EQ(record.parts[2].part, "driver");
    EXPECT_NEAR(record.parts[2].seen.absolute, 2.25e-4, 1e-6);
}

TEST_F(BlameTest, HoldsNoDriverToSubnormalInputs) {
    const Record record = Run("null:echo", "x", Judged("x", "ulp = 1", "1e-40, 1.5"));
    EXPECT_EQ(record.verdict, Verdict::kPass);
    EXPECT_THAT(record.parts, IsEmpty());
}

TEST_F(BlameTest, NonconformingIsWhatTheTolerancesWouldHaveLetPass) {
    const std::string judged = Judged("x * 1.00001", "relative = 0.001", "1.5, 0");
    const Record record = Run("null:echo", "x * 1.00001", judged);
    EXPECT_EQ(record.verdict, Verdict::kNonconforming);
    EXPECT_FALSE(record.Good());
    EXPECT_EQ(record.refused, 0u);
    EXPECT_EQ(record.outside, 1u);
    EXPECT_THAT(record.failed, ElementsAre("result"));
    EXPECT_EQ(Culprit(record), "driver");
    ASSERT_TRUE(record.worst_outside);
    EXPECT_EQ(record.worst_outside->inputs[0].second.decimal, "1.5");
    EXPECT_GT(record.worst_outside->allowed->excess, 50);
    EXPECT_THAT(record.repeat, HasSubstr("--at x=0x1.8p+0"));
    EXPECT_EQ(Run("cpu", "x * 1.00001", judged).verdict, Verdict::kPass);
}

TEST_F(BlameTest, NonconformingCanBeExpected) {
    const std::string judged = Judged("x * 1.00001", "relative = 0.001");
    const auto expected = [](const std::string& verdict) {
        return "[[expected_failure]]\nstatus = \"bug\"\ncause = \"it echoes\"\nverdict = \"" +
               verdict + "\"\n";
    };
    const Record known = Run("null:echo", "x * 1.00001", judged + expected("nonconforming"));
    EXPECT_EQ(known.verdict, Verdict::kNonconforming);
    EXPECT_TRUE(known.Good());
    EXPECT_EQ(known.known_cause, "bug: it echoes");
    EXPECT_FALSE(Run("null:echo", "x * 1.00001", judged + expected("fail")).Good());
    EXPECT_FALSE(Run("cpu", "x * 1.00001", judged + expected("nonconforming")).Good());
}

TEST_F(BlameTest, ALawIsHeldToTheSpecificationToo) {
    folder_.Write("f.glsl", "float f(float x) { return x * 1.00001; }\n");
    const std::string domain = "[domain]\nx = { values = [1.5] }\n";
    const std::string law = "[[law]]\nname = \"l\"\nholds = ";
    const Record outside = RunCall("null:echo", "f(x)", domain + law + "\"f(x) > 0.0 * x\"\n");
    EXPECT_EQ(outside.verdict, Verdict::kFail);  // the device gives x for both sides
    EXPECT_EQ(Culprit(outside), "driver");
    const Record loose = RunCall("null:echo", "f(x)",
                                 domain + law + "\"f(x) == x\"\nwithin = { relative = 0.001 }\n");
    EXPECT_EQ(loose.verdict, Verdict::kNonconforming);
    EXPECT_THAT(loose.failed, ElementsAre("law 'l'"));
    ASSERT_TRUE(loose.worst_outside);
    EXPECT_EQ(loose.worst_outside->output, "law 'l', left side");
    const Record method = RunCall("cpu", "f(x)", domain + law + "\"f(x) < x\"\n");
    EXPECT_EQ(Culprit(method), "method");
    const Record rounding = RunCall("cpu", "f(x)", domain + law + "\"(x + 1e9) - 1e9 == x\"\n");
    EXPECT_EQ(Culprit(rounding), "rounding");
    EXPECT_TRUE(rounding.worst->budget->is_law);
    EXPECT_EQ(rounding.worst->budget->method->ulp, 0);
    EXPECT_GT(rounding.worst->budget->rounding.ulp, 0);
}

TEST_F(BlameTest, ASpecificationAcceptsWhatItAllowsAndNoMore) {
    const std::string spec = "spec = \"vulkan-1.3\"";
    const Record inside = Run("null:echo", "sin(x)", Accepted(spec, "0.01, 0.05"));
    EXPECT_EQ(inside.verdict, Verdict::kPass);
    EXPECT_EQ(inside.judged, 2u);
    ASSERT_TRUE(inside.worst);
    EXPECT_GT(inside.worst->used, 0);
    EXPECT_LE(inside.worst->used, 1);
    EXPECT_FALSE(inside.worst->expected);
    const Record outside = Run("null:echo", "x * 1.00001", Accepted(spec, "1.5"));
    EXPECT_EQ(outside.verdict, Verdict::kFail);
    EXPECT_EQ(Culprit(outside), "driver");
    EXPECT_THAT(outside.culprits, ElementsAre(Pair("driver", 1)));
    EXPECT_EQ(outside.worst->rule, "spec vulkan-1.3");
    ASSERT_TRUE(outside.worst);
    EXPECT_GT(outside.worst->allowed->excess, 50);
    EXPECT_FALSE(outside.worst->budget->method);
    EXPECT_EQ(Run("cpu", "x * 1.00001", Accepted(spec, "1.5")).verdict, Verdict::kPass);
    // With an oracle the parts are told, and it judges nothing.
    const Record told = Run("cpu", "2.0 * x", Judged("x", spec));
    EXPECT_EQ(told.verdict, Verdict::kPass);
    ASSERT_TRUE(told.worst);
    EXPECT_EQ(told.worst->budget->method->absolute, 1.5);
    EXPECT_EQ(told.worst->expected->decimal, "1.5");
}

TEST_F(BlameTest, ASpecificationJudgesOnlyWhatItBounds) {
    const std::string spec = "spec = \"vulkan-1.3\"";
    const Record some = Run("null:echo", "sin(x)", Accepted(spec, "0.01, 0.05, 4.0"));
    EXPECT_EQ(some.verdict, Verdict::kPass);
    EXPECT_EQ(some.judged, 2u);
    EXPECT_EQ(some.unjudged, 1u);
    const Record none = Run("null:echo", "sin(x)", Accepted(spec, "4.0, 5.0"));
    EXPECT_EQ(none.verdict, Verdict::kSkip);
    EXPECT_EQ(none.reason, "the specification bounds no value at any row");
    const Record desktop =
        Run("null:echo", "sin(x)", Accepted("spec = \"glsl-4.60\"", "0.01, 0.05"));
    EXPECT_EQ(desktop.verdict, Verdict::kSkip);
    const Record unknown = Run("null:echo", "dFdx(x) + x", Accepted(spec, "1.5, 2.5"));
    EXPECT_EQ(unknown.verdict, Verdict::kSkip);
    EXPECT_EQ(unknown.reason,
              "there is no bound to judge by: its sources compile for fragment shaders only");
}

TEST_F(BlameTest, ASpecificationAllowsOneInteger) {
    const std::string typed =
        "accept = { spec = \"vulkan-1.3\" }\n[domain]\nx = { type = \"int\", "
        "values = [3] }\n";
    EXPECT_EQ(Run("null:echo", "x * 1", typed, "int").verdict, Verdict::kPass);
    const Record wrong = Run("null:echo", "x + 1", typed, "int");
    EXPECT_EQ(wrong.verdict, Verdict::kFail);
    ASSERT_TRUE(wrong.worst);
    EXPECT_EQ(wrong.worst->allowed->low.decimal, "4");
}

}  // namespace
}  // namespace etalon
