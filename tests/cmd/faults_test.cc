// What a driver, a disk or a person with `kill` may do to a run. The null device plays the driver.
#include <gmock/gmock.h>
#include <signal.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::SizeIs;

bool Eventually(const std::function<bool()>& holds) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (!holds()) {
        if (std::chrono::steady_clock::now() > deadline) {
            return false;
        }
        std::this_thread::sleep_for(milliseconds(5));
    }
    return true;
}

constexpr const char* kSkipped =
    "skipped: null:unsupported (glsl): the null device supports no program\n";
constexpr const char* kCrashedOnce =
    "null:crash-once (glsl) failed once and not again: ended by signal 11 (Segmentation fault)\n";
constexpr const char* kRows = "null:echo,glsl,1.5,1.5\nnull:echo,glsl,2.5,2.5\n";
constexpr const char* kCrashedRows = "null:crash-once,glsl,1.5,1.5\nnull:crash-once,glsl,2.5,2.5\n";
constexpr const char* kHeader = "device,recipe,x,result\n";

class Faults : public testing::Test {
  protected:
    Faults() {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("in.csv", "x:float\n1.5\n2.5\n");
        folder_.Write("cases/c.toml", R"toml(source = "f.glsl"
call = "f(x)"
oracle = "x"
accept = { ulp = 1 }
recipes = ["glsl"]
[domain]
x = { values = [1.5, 2.5] }
)toml");
        options_.folder = folder_.path();
    }

    static std::vector<std::string> Joined(std::vector<std::string> words,
                                           const std::vector<std::string>& more) {
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static std::vector<std::string> ProbeWords(const std::vector<std::string>& more) {
        return Joined({"probe", "f.glsl", "f(x)", "--inputs", "in.csv", "--csv"}, more);
    }
    Finished Probe(const std::vector<std::string>& more) {
        return RunEtalon(ProbeWords(more), options_);
    }
    Finished Run(const std::vector<std::string>& more) {
        return RunEtalon(Joined({"run"}, more), options_);
    }
    // A worker of the program, once there is one that is none of `others`; 0 if none comes.
    static pid_t Worker(const RunningProgram& program, const std::vector<pid_t>& others = {}) {
        pid_t found = 0;
        Eventually([&] {
            for (const pid_t worker : WorkersOf(program.id())) {
                if (std::find(others.begin(), others.end(), worker) == others.end()) {
                    found = worker;
                }
            }
            return found != 0;
        });
        return found;
    }

    // A probe of null:echo, null:crash-once and `device`, and its workers, once all of them are
    // open: the note on null:crash-once comes after that.
    std::unique_ptr<RunningProgram> ProbeUntilItRuns(const std::string& device,
                                                     std::vector<pid_t>& workers) {
        auto program = std::make_unique<RunningProgram>(
            EtalonWords(ProbeWords(
                {"-d", "null:echo", "-d", "null:crash-once", "-d", device, "--timeout", "30"})),
            options_);
        EXPECT_TRUE(Eventually([&] { return program->ErrSoFar() == kCrashedOnce; }));
        workers = WorkersOf(program->id());
        EXPECT_THAT(workers, SizeIs(3));
        std::this_thread::sleep_for(milliseconds(100));  // from the note to the run that hangs
        return program;
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(Faults, ProbeNamesEachFault) {
    const std::pair<const char*, const char*> rows[] = {
        {"null:crash", "crash: null:crash (glsl): ended by signal 11 (Segmentation fault)\n"},
        {"null:crash-load",
         "crash: null:crash-load (glsl): ended by signal 11 (Segmentation fault)\n"},
        {"null:lost",
         "crash: null:lost (glsl): lost its device: the null device plays a lost device\n"},
        {"null:hang", "timeout: null:hang (glsl): no answer within 300 ms\n"},
        {"null:memory", "crash: null:memory (glsl): used more than 256 MiB of memory\n"},
        {"null:rejects",
         "fail: null:rejects (glsl): the driver's compiler refused a program that glslang accepts: "
         "the null device rejects every program: 0:1: as it was told\n"},
    };
    for (const auto& [device, note] : rows) {
        const bool hangs = std::string_view(device) == "null:hang";
        const Finished finished =
            Probe({"-d", device, "--memory", "256", "--timeout", hangs ? "0.3" : "20"});
        EXPECT_EQ(finished.status, 1) << device;
        EXPECT_EQ(finished.err, note);
        EXPECT_EQ(finished.out, "");
    }
}

TEST_F(Faults, ProbeNotesAFlake) {
    const Finished finished = Probe({"-d", "null:crash-once"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, std::string(kHeader) + kCrashedRows);
    EXPECT_EQ(finished.err, kCrashedOnce);
}

TEST_F(Faults, OneDevicesFaultCostsTheOthersNothing) {
    const Finished finished = Probe({"-d", "null:crash", "-d", "null:echo", "-d", "null:lost"});
    EXPECT_EQ(finished.out, std::string(kHeader) + kRows);
    EXPECT_THAT(Lines(finished.err), SizeIs(2));
    const Finished skipped = Probe({"-d", "null:unsupported", "-d", "null:echo"});
    EXPECT_EQ(skipped.status, 0);
    EXPECT_EQ(skipped.out, std::string(kHeader) + kRows);
    EXPECT_EQ(skipped.err, kSkipped);
}

TEST_F(Faults, RunGivesEachFaultItsVerdict) {
    const std::string report = (folder_.path() / "r.json").string();
    const Finished finished = Run({"-d",        "null:echo",
                                   "-d",        "null:crash*",
                                   "-d",        "null:hang*",
                                   "-d",        "null:memory",
                                   "-d",        "null:lost",
                                   "-d",        "null:rejects",
                                   "-d",        "null:unsupported",
                                   "--timeout", "0.5",
                                   "--memory",  "256",
                                   "--json",    report});
    EXPECT_EQ(finished.status, 1);
    EXPECT_EQ(finished.err, "");
    std::map<std::string, std::string> verdicts;
    std::map<std::string, std::string> flakes;
    const json read = json::parse(folder_.Read("r.json"));
    for (const json& record : read["records"]) {
        verdicts[record["device"]] = record["verdict"];
        flakes[record["device"]] = record["flake"];
    }
    const std::map<std::string, std::string> expected = {
        {"null:echo", "pass"},        {"null:crash", "crash"},  {"null:crash-once", "pass"},
        {"null:crash-load", "crash"}, {"null:hang", "timeout"}, {"null:hang-once", "pass"},
        {"null:memory", "crash"},     {"null:lost", "crash"},   {"null:rejects", "fail"},
        {"null:unsupported", "skip"}};
    EXPECT_EQ(verdicts, expected);
    EXPECT_EQ(flakes["null:crash-once"], "ended by signal 11 (Segmentation fault)");
    EXPECT_EQ(flakes["null:hang-once"], "no answer within 500 ms");
    EXPECT_EQ(flakes["null:echo"], "");
    EXPECT_THAT(finished.out, HasSubstr("c on null:crash-load (glsl): crash\n"
                                        "  reason    ended by signal 11 (Segmentation fault)\n"
                                        "  repeat    etalon run c "));
    EXPECT_THAT(finished.out,
                HasSubstr("failed once and not again:\n  c on null:crash-once (glsl): "));
    EXPECT_THAT(finished.out, HasSubstr("\n3 passed, 6 failed, 1 skipped in "));
}

TEST_F(Faults, AWorkerKilledFromOutsideIsAFlake) {
    std::vector<pid_t> workers;
    const auto program = ProbeUntilItRuns("null:hang-once", workers);
    for (const pid_t worker : workers) {
        kill(worker, SIGKILL);
    }
    const Finished finished = program->Wait();
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.out, std::string(kHeader) + kRows + kCrashedRows +
                                "null:hang-once,glsl,1.5,1.5\nnull:hang-once,glsl,2.5,2.5\n");
    EXPECT_EQ(finished.err, std::string(kCrashedOnce) +
                                "null:hang-once (glsl) failed once and not again: "
                                "ended by signal 9 (Killed)\n");
}

TEST_F(Faults, AWorkerKilledTwiceIsACrash) {
    std::vector<pid_t> workers;
    const auto program = ProbeUntilItRuns("null:hang", workers);
    for (const pid_t worker : workers) {
        kill(worker, SIGKILL);
    }
    const pid_t second = Worker(*program, workers);
    ASSERT_NE(second, 0);
    kill(second, SIGKILL);
    const Finished finished = program->Wait();
    EXPECT_EQ(finished.status, 1);
    EXPECT_EQ(finished.out, std::string(kHeader) + kRows + kCrashedRows);
    EXPECT_THAT(finished.err, HasSubstr("crash: null:hang (glsl): "));
    EXPECT_THAT(finished.err, HasSubstr("ended by signal 9 (Killed)\n"));
}

TEST_F(Faults, NoWorkerOutlivesTheProgram) {
    for (const int signal : {SIGKILL, SIGTERM, SIGINT, SIGHUP}) {
        RunningProgram program(EtalonWords(ProbeWords({"-d", "null:hang", "--timeout", "30"})),
                               options_);
        const pid_t worker = Worker(program);
        ASSERT_NE(worker, 0);
        std::this_thread::sleep_for(milliseconds(50));
        kill(program.id(), signal);
        const Finished finished = program.Wait();
        EXPECT_EQ(finished.signal, signal);
        EXPECT_TRUE(Eventually([&] {
            const auto workers = WorkersOf(0);
            return std::find(workers.begin(), workers.end(), worker) == workers.end();
        })) << "a worker outlives signal "
            << signal;
    }
}

TEST_F(Faults, NoWorkerIsLeftAfterAnyEnd) {
    for (const char* device : {"null:echo", "null:crash", "null:hang"}) {
        RunningProgram program(EtalonWords(ProbeWords({"-d", device, "--timeout", "0.3"})),
                               options_);
        const pid_t worker = Worker(program);
        program.Wait();
        EXPECT_TRUE(Eventually([&] {
            const auto workers = WorkersOf(0);
            return worker == 0 ||
                   std::find(workers.begin(), workers.end(), worker) == workers.end();
        }));
    }
}

TEST_F(Faults, AFullDiskIsTold) {
    options_.out_file = "/dev/full";
    const std::vector<std::string> commands[] = {
        ProbeWords({"-d", "null:echo"}),
        {"probe", "f.glsl", "f(1.0)", "-d", "null:echo"},
        {"run", "-d", "null:echo"},
        {"list"},
        {"devices", "-d", "null:echo"},
        {"devices", "-d", "null:echo", "--json"},
        {"--help"},
        {"run", "--help"},
        {"--version"},
    };
    for (const auto& words : commands) {
        const Finished finished = RunEtalon(words, options_);
        EXPECT_EQ(finished.status, 2) << testing::PrintToString(words);
        EXPECT_EQ(finished.err, "etalon: standard output: cannot be written\n")
            << testing::PrintToString(words);
    }
}

TEST_F(Faults, AFullDiskUnderAListOfTestsIsTold) {
    options_.out_file = "/dev/full";
    const Finished finished = Run({"-d", "null:echo", "--gtest_list_tests"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "etalon: standard output: cannot be written\n");
}

TEST_F(Faults, AFullDiskUnderALongTableIsToldOnce) {
    std::string csv = "x:float\n";
    for (int i = 0; i < 100'000; ++i) {
        csv += "1.5\n";
    }
    folder_.Write("in.csv", csv);
    options_.out_file = "/dev/full";
    const Finished finished = Probe({"-d", "null:echo"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "etalon: standard output: cannot be written\n");
}

TEST_F(Faults, AReportThatCannotBeWrittenIsTold) {
    const Finished full = Run({"-d", "null:echo", "--json", "/dev/full"});
    EXPECT_EQ(full.status, 2);
    EXPECT_EQ(full.err, "etalon: --json: /dev/full: No space left on device\n");
    const Finished xml = Run({"-d", "null:echo", "--gtest_output=xml:/dev/full"});
    EXPECT_EQ(xml.status, 2);
    EXPECT_EQ(xml.err, "etalon: --gtest_output: /dev/full: No space left on device\n");
    const Finished folder = Run({"-d", "null:echo", "--json", "."});
    EXPECT_EQ(folder.status, 2);
    EXPECT_EQ(folder.err, "etalon: --json: .: is a folder, not a file\n");
    const Finished missing = Run({"-d", "null:echo", "--json", "no/such/r.json"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_THAT(missing.err, HasSubstr("etalon: --json: no/such/r.json: "));
}

TEST_F(Faults, AnOldReportStaysWholeUntilTheNewOneIsThere) {
    folder_.Write("r.json", "old");
    RunningProgram program(
        EtalonWords({"run", "-d", "null:hang", "--timeout", "30", "--json", "r.json"}), options_);
    ASSERT_NE(Worker(program), 0);
    kill(program.id(), SIGKILL);
    program.Wait();
    EXPECT_EQ(folder_.Read("r.json"), "old");
    EXPECT_EQ(Run({"nothing", "-d", "null:echo", "--json", "r.json"}).status, 2);
    EXPECT_EQ(folder_.Read("r.json"), "old");
    EXPECT_EQ(Run({"-d", "null:echo", "--json", "r.json"}).status, 0);
    EXPECT_TRUE(json::accept(folder_.Read("r.json")));
}

TEST_F(Faults, ClosedOutputsDoNoHarm) {
    const Finished finished = RunInShell("etalon probe f.glsl 'f(1.0)' -d null:echo >&-", options_);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "etalon: standard output: cannot be written\n");
    EXPECT_EQ(RunInShell("etalon probe f.glsl 'f(1.0)' -d null:echo <&- 2>&-", options_).status, 0);
    // A reader that goes away ends the program as it ends any other, or is told of.
    const Finished piped =
        RunInShell("etalon probe f.glsl 'f(x)' --inputs in.csv -d null:echo | true", options_);
    EXPECT_EQ(piped.status, 0);
}

}  // namespace
}  // namespace etalon
