// A device through its faults, from the call to the verdict's reason. No driver: the null device
// plays them.
#include "run/runner.h"

#include <gmock/gmock.h>
#include <signal.h>

#include <thread>

#include "base/file.h"
#include "probe/recipe.h"
#include "support/folder.h"
#include "worker/process_table.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using Kind = EvaluationFailure::Kind;

class RunnerTest : public testing::Test {
  protected:
    RunnerTest() {
        call_.source = folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        call_.arguments = {{"x", "float", true, false}};
        call_.wanted = {{"result", "f(x)", "CALL"}};
        signature_ = *Inspect(call_);
    }

    static Runner Open(const std::string& hint, WorkerLimits limits = {}) {
        Candidate candidate;
        candidate.backend = "null";
        candidate.hint = hint;
        auto client = std::make_unique<Client>(ProgramPath(), candidate, limits);
        EXPECT_TRUE(client->Start());
        const auto info = client->Open();
        EXPECT_TRUE(info) << info.error().reason;
        DeviceInfo told = *info;
        told.max_rows = max_rows_;
        return Runner(std::move(client), told, std::make_shared<Programs>());
    }

    // Evaluates `rows` rows of the words 0, 1, 2, ...; the null device gives them back.
    Result<Nothing, EvaluationFailure> Evaluate(Runner& runner, std::uint64_t rows = 3,
                                                const std::string& recipe = "spirv") {
        std::vector<std::uint32_t> words(rows);
        for (std::uint64_t row = 0; row < rows; ++row) {
            words[row] = static_cast<std::uint32_t>(row);
        }
        results_.assign(rows, ~0u);
        dispatches_ = 0;
        return runner.Evaluate(
            call_, signature_, *ParseRecipe(recipe), Rows{words, rows, 1},
            [&](std::uint64_t first, std::uint32_t count, std::span<const std::uint32_t> out) {
                ASSERT_EQ(out.size(), count);
                std::copy(out.begin(), out.end(),
                          results_.begin() + static_cast<std::ptrdiff_t>(first));
                ++dispatches_;
            });
    }

    bool EveryRowCame() const {
        for (std::size_t row = 0; row < results_.size(); ++row) {
            if (results_[row] != row) {
                return false;
            }
        }
        return true;
    }

    static inline std::uint32_t max_rows_ = 1u << 20;
    Folder folder_;
    Call call_;
    Signature signature_;
    std::vector<std::uint32_t> results_;
    int dispatches_ = 0;
};

TEST_F(RunnerTest, GivesEveryRow) {
    Runner runner = Open("echo");
    for (const std::uint64_t rows : {1u, 64u, 1000u}) {
        ASSERT_TRUE(Evaluate(runner, rows));
        EXPECT_TRUE(EveryRowCame());
        EXPECT_EQ(dispatches_, 1);
    }
    EXPECT_EQ(runner.flake(), "");
}

TEST_F(RunnerTest, TimesWhatItIsAskedTo) {
    max_rows_ = 100;
    Runner runner = Open("echo");
    max_rows_ = 1u << 20;
    const std::vector<std::uint32_t> words(350, 1);
    RunTime time{1e9, RunTime::Clock::kDevice, 1e9};
    const Stopwatch stopwatch;
    ASSERT_TRUE(runner.Evaluate(
        call_, signature_, Recipe{}, Rows{words, 350, 1},
        [](std::uint64_t, std::uint32_t, std::span<const std::uint32_t>) {}, &time));
    EXPECT_GT(time.seconds, 0);
    EXPECT_LT(time.seconds, stopwatch.Read().seconds);
    EXPECT_EQ(time.clock, RunTime::Clock::kHost);
}

TEST_F(RunnerTest, KeepsTheDevicesLimitOfRows) {
    max_rows_ = 100;
    Runner runner = Open("echo");
    max_rows_ = 1u << 20;
    ASSERT_TRUE(Evaluate(runner, 350));
    EXPECT_TRUE(EveryRowCame());
    EXPECT_EQ(dispatches_, 4);
}

TEST_F(RunnerTest, EvaluatesBakedRowsInPieces) {
    Runner runner = Open("echo");
    // Baked programs read no input, and the null device answers those with zeros.
    ASSERT_TRUE(Evaluate(runner, 40, "spirv+baked"));
    EXPECT_EQ(dispatches_, 3);
    EXPECT_EQ(results_, std::vector<std::uint32_t>(40, 0));
}

TEST_F(RunnerTest, TriesACrashOnceMoreAndTells) {
    Runner runner = Open("crash-once");
    ASSERT_TRUE(Evaluate(runner));
    EXPECT_TRUE(EveryRowCame());
    EXPECT_EQ(runner.flake(), "ended by signal 11 (Segmentation fault)");
    // The flake is that of the last evaluation only; the worker stays the second one.
    ASSERT_TRUE(Evaluate(runner));
    EXPECT_EQ(runner.flake(), "");
}

TEST_F(RunnerTest, LosesNoRowsToAWorkerThatEndedMeanwhile) {
    Runner runner = Open("echo");
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(Evaluate(runner));
        EXPECT_TRUE(EveryRowCame());
        const std::vector<pid_t> workers = Children();
        ASSERT_EQ(workers.size(), 1u);
        kill(workers[0], SIGKILL);
        while (StateOf(workers[0]).state != 'Z') {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }
}

TEST_F(RunnerTest, TriesAHangOnceMoreAndTells) {
    Runner runner = Open("hang-once", {std::chrono::milliseconds(300), 2ull << 30});
    ASSERT_TRUE(Evaluate(runner));
    EXPECT_TRUE(EveryRowCame());
    EXPECT_EQ(runner.flake(), "no answer within 300 ms");
}

TEST_F(RunnerTest, ResumesAtTheChunkThatFailed) {
    max_rows_ = 100;
    Runner runner = Open("crash-once");
    max_rows_ = 1u << 20;
    ASSERT_TRUE(Evaluate(runner, 250));
    EXPECT_TRUE(EveryRowCame());
    EXPECT_EQ(dispatches_, 3);
    EXPECT_EQ(runner.flake(), "ended by signal 11 (Segmentation fault)");
}

TEST_F(RunnerTest, CallsWhatFailsTwiceACrash) {
    for (const auto& [hint, reason] :
         {std::pair("crash", "ended by signal 11 (Segmentation fault)"),
          std::pair("crash-load", "ended by signal 11 (Segmentation fault)"),
          std::pair("lost", "lost its device: the null device plays a lost device")}) {
        Runner runner = Open(hint);
        // Each evaluation has its own verdict: the one before leaves nothing behind.
        for (int i = 0; i < 3; ++i) {
            const auto evaluated = Evaluate(runner);
            ASSERT_FALSE(evaluated);
            EXPECT_EQ(evaluated.error().kind, Kind::kCrash);
            EXPECT_EQ(evaluated.error().reason, reason);
            EXPECT_EQ(runner.flake(), "");
            EXPECT_EQ(dispatches_, 0);
        }
    }
}

TEST_F(RunnerTest, CallsAHangATimeout) {
    Runner runner = Open("hang", {std::chrono::milliseconds(200), 2ull << 30});
    for (int i = 0; i < 2; ++i) {
        const auto evaluated = Evaluate(runner);
        ASSERT_FALSE(evaluated);
        EXPECT_EQ(evaluated.error().kind, Kind::kTimeout);
        EXPECT_EQ(evaluated.error().reason, "no answer within 200 ms");
    }
}

TEST_F(RunnerTest, CallsTheEndOfMemoryACrash) {
    Runner runner = Open("memory", {std::chrono::seconds(20), 128ull << 20});
    const auto evaluated = Evaluate(runner);
    ASSERT_FALSE(evaluated);
    EXPECT_EQ(evaluated.error().kind, Kind::kCrash);
    EXPECT_EQ(evaluated.error().reason, "used more than 128 MiB of memory");
}

TEST_F(RunnerTest, KeepsTheWorkerThatOnlyRefuses) {
    Runner rejects = Open("rejects");
    const auto rejected = Evaluate(rejects);
    ASSERT_FALSE(rejected);
    EXPECT_EQ(rejected.error().kind, Kind::kRejected);
    EXPECT_EQ(rejected.error().reason,
              "the driver's compiler refused a program that glslang accepts: "
              "the null device rejects every program: 0:1: as it was told");
    Runner unsupported = Open("unsupported");
    const auto declined = Evaluate(unsupported);
    ASSERT_FALSE(declined);
    EXPECT_EQ(declined.error().kind, Kind::kUnsupported);
    EXPECT_EQ(declined.error().reason, "the null device supports no program");
}

TEST_F(RunnerTest, CompilesWhatChangesAnew) {
    Runner runner = Open("echo");
    ASSERT_TRUE(Evaluate(runner));
    call_.wanted[0].text = "f(x) + f(";
    const auto wrong = Evaluate(runner);
    EXPECT_FALSE(wrong);
    call_.wanted[0].text = "vec2(f(x))";
    signature_ = *Inspect(call_);
    std::vector<std::uint32_t> word = {7};
    std::size_t count = 0;
    ASSERT_TRUE(
        runner.Evaluate(call_, signature_, Recipe{}, Rows{word, 1, 1},
                        [&](std::uint64_t, std::uint32_t, auto out) { count = out.size(); }));
    EXPECT_EQ(count, 2u);
}

TEST_F(RunnerTest, ReportsTheUsersMistakeAsOne) {
    Runner runner = Open("echo");
    folder_.Write("f.glsl", "float f(float x) { return y; }\n");
    const auto evaluated = Evaluate(runner);
    ASSERT_FALSE(evaluated);
    EXPECT_THAT(evaluated.error().reason, HasSubstr("f.glsl:1: 'y' : undeclared identifier"));
}

}  // namespace
}  // namespace etalon
