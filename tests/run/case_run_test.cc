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
    Record RunOn(const std::string& device, const std::string& expectations) {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("cases/c.toml", kCase + expectations);
        const Result<Case> read = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(read.ok()) << read.error().message;
        const Result<PreparedCase> prepared = Prepare(*read);
        EXPECT_TRUE(prepared.ok()) << prepared.error().message;
        DeviceChoice choice;
        choice.patterns = {device};
        choice.limits.timeout = std::chrono::milliseconds(500);
        Result<DeviceSet> devices = OpenDevices(choice);
        EXPECT_TRUE(devices.ok()) << devices.error().message;
        Runner& runner = *devices->runners.front();
        return RunCase(*prepared, runner, DefaultRecipe(runner.info()), {});
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
        return RunCase(*prepared, runner, DefaultRecipe(runner.info()), {});
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
