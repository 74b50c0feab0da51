// Sweeps as a user starts them, kills them, and shares them out. The null device plays the driver.
#include <gmock/gmock.h>
#include <signal.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class SweepTest : public testing::Test {
  protected:
    SweepTest() {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("cases/c.toml",
                      "source = \"f.glsl\"\ncall = \"f(x)\"\noracle = \"x\"\naccept = { ulp = 1 }\n"
                      "[domain]\nx = { range = [0.5, 1.0], count = 9 }\n");
        options_.folder = folder_.path();
    }

    static std::vector<std::string> Words(const std::vector<std::string>& more) {
        std::vector<std::string> words = {"sweep", "c", "--exhaustive"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    Finished Sweep(const std::vector<std::string>& more) {
        return RunEtalon(Words(more), options_);
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(SweepTest, FindsTheOneFloatThatIsWrong) {
    const Finished finished = Sweep({"-d", "null:flaw"});
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, StartsWith("c on null:flaw (glsl): fail\n"));
    EXPECT_THAT(finished.out, HasSubstr("result, by ulp 1: 1 of 8388609 values refused\n"));
    EXPECT_THAT(finished.out, HasSubstr("    input     x=0.7\n              x=0x1.666666p-1\n"));
    EXPECT_THAT(finished.out, HasSubstr("    0                     8388608"));
    EXPECT_THAT(finished.err, HasSubstr("the device waited for the checker"));
    EXPECT_THAT(finished.err, testing::Not(HasSubstr("\r")));  // no progress without a terminal

    const Finished good = Sweep({"-d", "null:echo", "--json"});
    EXPECT_EQ(good.status, 0);
    const auto json = nlohmann::json::parse(good.out);
    EXPECT_EQ(json["verdict"], "pass");
    EXPECT_EQ(json["rows"], 8388609);
    EXPECT_EQ(json["outputs"][0]["histogram"][0]["count"], 8388609);
}

TEST_F(SweepTest, AFinishedJournalIsTheAnswer) {
    const Finished first = Sweep({"-d", "null:flaw", "--journal", "j"});
    const Finished again = Sweep({"-d", "null:flaw", "--journal", "j"});
    EXPECT_EQ(again.out, first.out);
    EXPECT_EQ(again.status, 1);
    EXPECT_EQ(again.err, "j: 9 of 9 blocks are done\n");
}

// Killed at any time, as often as it takes: the same answer as in one go.
TEST_F(SweepTest, GoesOnAfterAKill) {
    const std::vector<std::string> range = {"-d", "null:flaw", "--from", "0x1p-5", "--journal"};
    const auto with = [&](const char* journal) {
        std::vector<std::string> words = range;
        words.emplace_back(journal);
        return Words(words);
    };
    const Finished whole = RunEtalon(with("whole"), options_);
    EXPECT_EQ(whole.status, 1);
    std::string before;
    int kills = 0;
    for (int pause = 50;; pause += 30) {
        ASSERT_LT(kills, 200);
        RunningProgram program(EtalonWords(with("killed")), options_);
        std::this_thread::sleep_for(std::chrono::milliseconds(pause));
        kill(program.id(), SIGKILL);
        const Finished finished = program.Wait();
        if (finished.signal == 0) {
            EXPECT_EQ(finished.out, whole.out);
            EXPECT_EQ(finished.status, 1);
            break;
        }
        ++kills;
        before = folder_.Read("killed");
    }
    EXPECT_GE(kills, 1);
    EXPECT_THAT(before, HasSubstr("etalon sweep journal"));
    EXPECT_EQ(folder_.Read("killed"), folder_.Read("whole"));
}

TEST_F(SweepTest, RefusesAJournalThatIsBeingWritten) {
    const std::vector<std::string> words =
        Words({"-d", "null:echo", "--from", "0x1p-9", "--journal", "j"});
    RunningProgram first(EtalonWords(words), options_);
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (folder_.Read("j").empty() && std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const Finished second = RunEtalon(words, options_);
    EXPECT_EQ(second.status, 2);
    EXPECT_EQ(second.out, "");
    EXPECT_EQ(second.err, "etalon: j: another process is at work on it\n");
    EXPECT_EQ(first.Wait().status, 0);
    EXPECT_EQ(RunEtalon(words, options_).status, 0);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "j.lock"));
}

TEST_F(SweepTest, ShardsAddUpToOneRun) {
    const Finished whole = Sweep({"-d", "null:flaw"});
    const Finished whole_json = Sweep({"-d", "null:flaw", "--json"});
    std::vector<std::string> merge = {"sweep", "--merge"};
    int failed = 0;
    for (const char* index : {"3", "1", "2"}) {
        const Finished shard = Sweep({"-d", "null:flaw", "--shard", std::string(index) + "/3"});
        failed += shard.status;
        EXPECT_THAT(shard.out, HasSubstr(std::string("  shard     ") + index + "/3\n"));
        merge.push_back(std::string("sweep-c-null-flaw-glsl-") + index + "of3.journal");
    }
    EXPECT_EQ(failed, 1);  // the one with the flaw
    const Finished merged = RunEtalon(merge, options_);
    EXPECT_EQ(merged.status, 1);
    EXPECT_EQ(merged.out, whole.out);
    EXPECT_EQ(merged.err, "");
    merge.emplace_back("--json");
    EXPECT_EQ(RunEtalon(merge, options_).out, whole_json.out);
    const Finished missing = RunEtalon({merge[0], merge[1], merge[2], merge[3]}, options_);
    EXPECT_EQ(missing.status, 2);
    EXPECT_EQ(missing.err, "etalon: --merge: the shard of the blocks 4 to 6 of 9 is missing\n");
}

TEST_F(SweepTest, GivesADevicesFaultItsVerdict) {
    const Finished once = Sweep({"-d", "null:crash-once"});
    EXPECT_EQ(once.status, 0);
    EXPECT_THAT(once.err, StartsWith("null:crash-once (glsl) failed once and not again: "));
    const Finished crash = Sweep({"-d", "null:crash"});
    EXPECT_EQ(crash.status, 1);
    EXPECT_THAT(crash.out, StartsWith("c on null:crash (glsl): crash\n"
                                      "  reason    ended by signal 11 (Segmentation fault); at x "
                                      "from 0x1p-1 to 0x1.1ffffep-1\n"));
    EXPECT_THAT(crash.out, HasSubstr("  done      0 of 8388609 rows\n"));
    const Finished hang = Sweep({"-d", "null:hang", "--timeout", "0.3"});
    EXPECT_EQ(hang.status, 1);
    EXPECT_THAT(hang.out, StartsWith("c on null:hang (glsl): timeout\n"));
    EXPECT_THAT(folder_.Read("sweep-c-null-hang-glsl.journal"), HasSubstr("blocks 0 0 9\n"));
}

// A worker that is killed under way costs the answer nothing.
TEST_F(SweepTest, TriesABlockAgain) {
    const Finished whole = Sweep({"-d", "null:echo", "--from", "0x1p-5", "--journal", "whole"});
    RunningProgram program(
        EtalonWords(Words({"-d", "null:echo", "--from", "0x1p-5", "--journal", "j"})), options_);
    const auto has = [&](const char* text) {
        return folder_.Read("j").find(text) != std::string::npos;
    };
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while ((!has("blocks 0 ") || has("blocks 0 0 ")) &&
           std::chrono::steady_clock::now() < deadline) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    const std::vector<pid_t> workers = WorkersOf(program.id());
    EXPECT_EQ(workers.size(), 1u);
    for (const pid_t worker : workers) {
        kill(worker, SIGKILL);
    }
    const Finished finished = program.Wait();
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, whole.out);
}

TEST_F(SweepTest, RefusesAForeignOrTornJournal) {
    ASSERT_EQ(Sweep({"-d", "null:echo", "--journal", "j"}).status, 0);
    const auto why = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"--journal", "j", "-d"};
        words.insert(words.end(), more.begin(), more.end());
        const Finished finished = Sweep(words);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        return finished.err;
    };
    const std::string head = "etalon: j: is the journal of another sweep: ";
    const std::string tail = "; remove it, or name another file by --journal\n";
    EXPECT_EQ(why({"null:slow"}), head + "'device' is 'null:echo', not 'null:slow'" + tail);
    EXPECT_EQ(why({"null:echo", "--from", "0.75"}),
              head + "'from' is '0x1p-1', not '0x1.8p-1'" + tail);
    EXPECT_EQ(why({"null:echo", "--shard", "1/2"}), head + "'shard' is '1/1', not '1/2'" + tail);
    EXPECT_THAT(why({"null:echo", "--recipe", "spirv"}), StartsWith(head + "'recipe'"));
    // Another function under the same name.
    folder_.Write("f.glsl", "float f(float x) { return x + 0.0; }\n");
    EXPECT_THAT(why({"null:echo"}), StartsWith(head + "'content' is "));
    folder_.Write("f.glsl", "float f(float x) { return x; }\n");
    const std::string journal = folder_.Read("j");
    folder_.Write("j", journal.substr(0, journal.size() / 2));
    EXPECT_EQ(why({"null:echo"}),
              "etalon: j: is a journal that was cut or changed; remove it to begin anew\n");
    folder_.Write("j", "notes of my own\n");
    EXPECT_EQ(why({"null:echo"}), "etalon: j: is no journal of a sweep\n");
    EXPECT_EQ(folder_.Read("j"), "notes of my own\n");
}

TEST_F(SweepTest, SaysWhatIsWrong) {
    const auto why = [&](const std::vector<std::string>& words) {
        const Finished finished = RunEtalon(words, options_);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        EXPECT_THAT(finished.err, EndsWith("\n"));
        EXPECT_EQ(Lines(finished.err).size(), 1u) << finished.err;
        return finished.err;
    };
    EXPECT_THAT(why({"sweep", "c", "-d", "null:echo"}), HasSubstr("--exhaustive must be said"));
    EXPECT_THAT(why({"sweep", "--exhaustive"}), HasSubstr("no case is named"));
    EXPECT_THAT(why(Words({})), HasSubstr("--device NAME says on which"));
    EXPECT_THAT(why(Words({"-d", "null:echo", "-d", "null:slow"})),
                HasSubstr("a sweep runs on one device, and --device names null:echo, null:slow"));
    EXPECT_THAT(why(Words({"-d", "null:unsupported"})), HasSubstr("supports no program"));
    EXPECT_THAT(why(Words({"-d", "null:echo", "--recipe", "spirv+baked"})),
                HasSubstr("a sweep's inputs cannot be constants"));
    for (const char* shard : {"0/2", "3/2", "1", "1/", "/2", "1/2x", "-1/2", "1/0"}) {
        EXPECT_THAT(why(Words({"-d", "null:echo", std::string("--shard=") + shard})),
                    HasSubstr("it reads I/N"));
    }
    EXPECT_THAT(why(Words({"-d", "null:echo", "--shard", "1/100"})),
                HasSubstr("--shard 1/100: there are 9 blocks to share out, and none for this one"));
    EXPECT_THAT(why(Words({"-d", "null:echo", "--journal", "no/folder/j"})),
                HasSubstr("no/folder/j: cannot be written"));
    EXPECT_THAT(why({"sweep", "d", "--exhaustive"}), HasSubstr("no case is called 'd'"));
    EXPECT_THAT(why({"sweep", "--merge", "none"}), HasSubstr("none: No such file"));
}

}  // namespace
}  // namespace etalon
