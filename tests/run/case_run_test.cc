// What an expected failure covers, and what it does not.

#include "run/case_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/record.h"
#include "run/devices.h"
#include "run/fit.h"
#include "support/folder.h"

namespace etalon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// x is echoed by the null device, so that law "a" and law "b" fail and nothing else does.
constexpr const char* kCase = R"toml(source = "f.glsl"
call = "f(x)"
[domain]
x = { values = [1.0] }
[[law]]
name = "a"
holds = "x + 1.0 < x"
[[law]]
name = "b"
holds = "x + 2.0 < x"
)toml";

class ExpectedFailureTest : public ::testing::Test {
  protected:
    Record RunOn(const std::string& device, const std::string& expectations,
                 Extent extent = Extent::kAll) {
        return Run(device, kCase + expectations, extent);
    }
    Record Run(const std::string& device, const std::string& text, Extent extent = Extent::kAll) {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("cases/c.toml", text);
        const Result<Case> read = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(read.ok()) << read.error().message;
        Result<PreparedCase> prepared = Prepare(*read);
        EXPECT_TRUE(prepared.ok()) << prepared.error().message;
        prepared->extent = extent;
        DeviceChoice choice;
        choice.patterns = {device};
        choice.limits.timeout = std::chrono::milliseconds(500);
        Result<DeviceSet> devices = OpenDevices(choice);
        EXPECT_TRUE(devices.ok()) << devices.error().message;
        Runner& runner = *devices->runners.front();
        Evaluations evaluations(devices->programs);
        return RunCase(*prepared, runner, DefaultRecipe(runner.info()), evaluations, {});
    }
    static std::string Entry(const std::string& keys) {
        return "[[expected_failure]]\ndevice = \"*\"\nstatus = \"bug\"\n" + keys;
    }

    Folder folder_;
};

// x is echoed, and is the truth from 2 on; below, there is none.
class SharesTest : public ::testing::Test {
  protected:
    Record RunAt(const std::string& at) {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("cases/c.toml", R"toml(source = "f.glsl"
call = "f(x)"
oracle = "x + 0 * sqrt(x - 2)"
accept = { absolute = 0.1, missed = 0.1, beyond = 1 }
[domain]
x = { values = [1, 2, 3] }
)toml");
        const Result<Case> read = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(read.ok()) << read.error().message;
        const Result<PreparedCase> prepared = at.empty() ? Prepare(*read) : PrepareAt(*read, at);
        EXPECT_TRUE(prepared.ok()) << prepared.error().message;
        DeviceChoice choice;
        choice.patterns = {"null:echo"};
        Result<DeviceSet> devices = OpenDevices(choice);
        EXPECT_TRUE(devices.ok()) << devices.error().message;
        Runner& runner = *devices->runners.front();
        Evaluations evaluations(devices->programs);
        return RunCase(*prepared, runner, DefaultRecipe(runner.info()), evaluations, {});
    }

    Folder folder_;
};

TEST_F(ExpectedFailureTest, EveryThingThatFailsMustBeNamed) {
    const std::string a = Entry("law = \"a\"\ncause = \"first\"\n");
    const std::string b = Entry("law = \"b\"\ncause = \"second\"\n");
    EXPECT_FALSE(RunOn("null:echo", "").Good());
    EXPECT_FALSE(RunOn("null:echo", a).Good());
    EXPECT_FALSE(RunOn("null:echo", b).Good());
    const Record both = RunOn("null:echo", a + b);
    EXPECT_TRUE(both.Good());
    EXPECT_THAT(both.known_cause, HasSubstr("first"));
    EXPECT_THAT(both.known_cause, HasSubstr("second"));
    EXPECT_TRUE(RunOn("null:echo", Entry("cause = \"all\"\n")).Good());
}

// The null device gives x back: at the one of four rows where 2 is due it returns 1.
constexpr const char* kBelowTwo = R"toml(source = "f.glsl"
call = "f(x)"
oracle = "max(x, 2)"
accept = { ulp = 1 }
[domain]
x = { values = [1.0, 3.0, 5.0, 7.0] }
)toml";

TEST_F(ExpectedFailureTest, AFigureMustBeWhatWasSeen) {
    const auto with = [&](const std::string& figure) {
        return Run("null:echo", kBelowTwo + Entry("cause = \"c\"\nfigure = { " + figure + " }\n"));
    };
    for (const char* right : {"absolute = 1", "absolute = 1.009", "relative = 0.5", "value = 1",
                              "ulp = 8388608", "refused = 0.25"}) {
        const Record record = with(right);
        EXPECT_TRUE(record.Good()) << right << record.reason;
        ASSERT_EQ(record.figures.size(), 1u);
        EXPECT_TRUE(record.figures[0].agrees);
    }
    for (const char* wrong : {"absolute = 1.02", "absolute = 1.001, within = 1e-4", "relative = 1",
                              "value = -1", "value = \"nan\"", "ulp = 1", "refused = 0.5"}) {
        const Record record = with(wrong);
        EXPECT_FALSE(record.Good()) << wrong;
        ASSERT_EQ(record.figures.size(), 1u);
        EXPECT_EQ(record.reason, "expected figure " + record.figures[0].expected + ", saw " +
                                     record.figures[0].seen);
        EXPECT_THAT(record.repeat, Not(HasSubstr("--at")));
    }
    EXPECT_EQ(with("value = \"nan\"").figures[0].expected, "value nan within 0.01");
    EXPECT_EQ(with("value = \"nan\"").figures[0].seen, "1");
    EXPECT_EQ(with("relative = 3").figures[0].seen, "0.5");
}

TEST_F(ExpectedFailureTest, AFigureOfSeveralIsEnough) {
    const auto figure = [](const std::string& text) {
        return Entry("cause = \"c\"\nfigure = { " + text + " }\n");
    };
    EXPECT_TRUE(Run("null:echo", kBelowTwo + figure("value = 7") + figure("value = 1")).Good());
    EXPECT_FALSE(Run("null:echo", kBelowTwo + figure("value = 7") + figure("value = 8")).Good());
}

TEST_F(ExpectedFailureTest, AFigureIsOfTheLawThatItNames) {
    const std::string b = Entry("law = \"b\"\ncause = \"second\"\n");
    const auto a = [&](const std::string& figure) {
        return RunOn("null:echo",
                     b + Entry("law = \"a\"\ncause = \"c\"\nfigure = { " + figure + " }\n"));
    };
    EXPECT_TRUE(a("refused = 1").Good());
    EXPECT_FALSE(a("refused = 0.5").Good());
}

TEST_F(ExpectedFailureTest, FiguresAreOfAllRows) {
    const std::string wrong = Entry("law = \"*\"\ncause = \"first\"\nfigure = { value = 7 }\n");
    EXPECT_FALSE(RunOn("null:echo", wrong).Good());
    EXPECT_TRUE(RunOn("null:echo", wrong, Extent::kSome).Good());
    EXPECT_TRUE(RunOn("null:echo", wrong, Extent::kGiven).Good());
}

TEST_F(ExpectedFailureTest, ACrashOrAHangIsCoveredOnlyByItsName) {
    const std::string any = Entry("cause = \"numbers\"\n");
    for (const char* device : {"null:crash", "null:lost", "null:hang"}) {
        EXPECT_FALSE(RunOn(device, any).Good()) << device;
    }
    EXPECT_TRUE(RunOn("null:crash", Entry("verdict = \"crash\"\ncause = \"c\"\n")).Good());
    EXPECT_TRUE(RunOn("null:hang", Entry("verdict = \"timeout\"\ncause = \"c\"\n")).Good());
    EXPECT_FALSE(RunOn("null:hang", Entry("verdict = \"crash\"\ncause = \"c\"\n")).Good());
}

TEST_F(SharesTest, AreCountedInTheRecord) {
    const Record record = RunAt("");
    EXPECT_EQ(record.verdict, Verdict::kPass) << record.reason;
    ASSERT_EQ(record.shares.size(), 1u);
    EXPECT_EQ(record.shares[0].output, "result");
    EXPECT_EQ(record.shares[0].rows, 2u);
    EXPECT_EQ(record.shares[0].undecided, 1u);
    EXPECT_EQ(record.shares[0].hits, 2u);
    EXPECT_EQ(record.judged, 2u);
}

TEST_F(SharesTest, AreNothingWhereTheOracleIsUndecided) {
    const Record record = RunAt("x=0x1p+0");
    EXPECT_EQ(record.verdict, Verdict::kSkip);
    EXPECT_EQ(record.reason, "the oracle is undecided at every row");
}

}  // namespace
}  // namespace etalon
