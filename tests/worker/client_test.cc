// The whole way through a process of its own. This program is also its worker: see main.
#include "worker/client.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <thread>

#include "base/file.h"
#include "broken_worker.h"
#include "process_table.h"
#include "worker/serve.h"

namespace etalon {
namespace {

using std::chrono::milliseconds;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;
using Kind = WorkerFailure::Kind;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kShort{500};
constexpr milliseconds kLong{20'000};

WorkerLimits Limits(milliseconds timeout, std::uint64_t memory_bytes = 4ull << 30) {
    return {timeout, memory_bytes};
}

Candidate Null(const std::string& hint) {
    Candidate candidate;
    candidate.backend = "null";
    candidate.hint = hint;
    return candidate;
}

Candidate Faulty(const std::string& fault) {
    Candidate candidate = Null("echo");
    candidate.environment[kWorkerFault] = fault;
    return candidate;
}

Program Shape(std::uint32_t input_words, std::uint32_t output_words) {
    Program program;
    program.input_words = input_words;
    program.output_words = output_words;
    return program;
}

// A client of the null device, from its start to the answer of a run of one row.
class Served {
  public:
    explicit Served(Candidate candidate, WorkerLimits limits = Limits(kLong))
        : client(ProgramPath(), std::move(candidate), limits) {
        const auto started = client.Start();
        EXPECT_TRUE(started) << started.error().message;
    }

    WorkerResult<std::span<const std::uint32_t>> Run(std::uint32_t word = 42) {
        ETALON_TRY(info, client.Open());
        EXPECT_EQ(info.name, "null:" + client.candidate().hint);
        ETALON_TRY(handle, client.Load(Shape(1, 1)));
        client.Inputs(1, 1, 1)[0] = word;
        return client.Run(handle);
    }

    WorkerFailure Failure() {
        auto answer = Run();
        EXPECT_FALSE(answer.ok());
        return answer ? WorkerFailure{} : answer.error();
    }

    Client client;
};

bool Eventually(const std::function<bool()>& holds) {
    const auto deadline = Clock::now() + std::chrono::seconds(5);
    while (!holds()) {
        if (Clock::now() > deadline) {
            return false;
        }
        std::this_thread::sleep_for(milliseconds(5));
    }
    return true;
}

TEST(Client, EchoesAMillionRowsToTheBit) {
    constexpr std::uint32_t kRows = 1u << 20;
    Served served(Null("echo"));
    const auto info = served.client.Open();
    ASSERT_TRUE(info) << info.error().reason;
    EXPECT_TRUE(info->Has("compute"));
    EXPECT_EQ(info->glsl_version, 450u);
    const auto handle = served.client.Load(Shape(2, 3));
    ASSERT_TRUE(handle);
    for (const std::uint32_t rows : {1u, kRows, 1000u}) {  // grows, then uses less
        const auto inputs = served.client.Inputs(rows, 2, 3);
        ASSERT_EQ(inputs.size(), std::size_t{rows} * 2);
        std::uint32_t word = rows;
        for (std::uint32_t& input : inputs) {
            input = word = word * 1664525u + 1013904223u;
        }
        const auto outputs = served.client.Run(*handle);
        ASSERT_TRUE(outputs) << outputs.error().reason;
        ASSERT_EQ(outputs->size(), std::size_t{rows} * 3);
        EXPECT_TRUE(std::equal(inputs.begin(), inputs.end(), outputs->begin()));
        EXPECT_TRUE(std::equal(inputs.begin(), inputs.begin() + rows,
                               outputs->begin() + std::size_t{rows} * 2));
    }
}

TEST(Client, KeepsSeveralProgramsAndPassesBigOnes) {
    Served served(Null("echo"));
    ASSERT_TRUE(served.client.Open());
    Program big = Shape(1, 2);
    big.glsl.assign(10u << 20, 'x');
    const auto first = served.client.Load(big);
    const auto second = served.client.Load(Shape(0, 1));
    ASSERT_TRUE(first && second);
    served.client.Inputs(1, 1, 2)[0] = 5;
    const auto fives = served.client.Run(*first);
    ASSERT_TRUE(fives);
    EXPECT_EQ((*fives)[1], 5u);
    served.client.Inputs(1, 0, 1);
    const auto zero = served.client.Run(*second);
    ASSERT_TRUE(zero);
    EXPECT_EQ((*zero)[0], 0u);
}

TEST(Client, OpensSeveralAtOnce) {
    std::vector<std::unique_ptr<Served>> all_served(4);
    for (auto& served : all_served) {
        served = std::make_unique<Served>(Null("echo"));
    }
    EXPECT_THAT(Children(), SizeIs(4));
    for (const auto& served : all_served) {
        EXPECT_TRUE(served->Run());
    }
}

TEST(Client, PassesOnARefusalAndLivesOn) {
    Served rejects(Null("rejects"));
    const WorkerFailure rejected = rejects.Failure();
    EXPECT_EQ(rejected.kind, Kind::kRejected);
    EXPECT_EQ(rejected.reason, "the null device rejects every program\n0:1: as it was told");
    EXPECT_TRUE(rejects.client.alive());
    EXPECT_EQ(rejects.Failure().kind, Kind::kRejected);

    Served unsupported(Null("unsupported"));
    EXPECT_EQ(unsupported.Failure().kind, Kind::kUnsupported);
    EXPECT_TRUE(unsupported.client.alive());
}

TEST(Client, EndsAWorkerThatHasNoDevice) {
    Served served(Null("sleeps"));
    const auto opened = served.client.Open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, Kind::kUnsupported);
    EXPECT_EQ(opened.error().reason, "the null device knows no 'sleeps'");
    EXPECT_FALSE(served.client.alive());
}

TEST(Client, TellsOfACrash) {
    for (const char* hint : {"crash", "crash-load", "crash-open"}) {
        Served served(Null(hint));
        const WorkerFailure failure = served.Failure();
        EXPECT_EQ(failure.kind, Kind::kCrash) << hint;
        EXPECT_EQ(failure.reason, "ended by signal 11 (Segmentation fault)") << hint;
        EXPECT_FALSE(served.client.alive());
        EXPECT_EQ(served.client.Load(Shape(1, 1)).error().kind, Kind::kCrash);
    }
    EXPECT_THAT(Children(), IsEmpty());
}

TEST(Client, TellsOfALostDevice) {
    Served served(Null("lost"));
    const WorkerFailure failure = served.Failure();
    EXPECT_EQ(failure.kind, Kind::kCrash);
    EXPECT_EQ(failure.reason, "lost its device: the null device plays a lost device");
    EXPECT_FALSE(served.client.alive());
}

TEST(Client, EndsAWorkerThatHangs) {
    Served served(Null("hang"), Limits(kShort));
    const auto start = Clock::now();
    const WorkerFailure failure = served.Failure();
    EXPECT_EQ(failure.kind, Kind::kTimeout);
    EXPECT_EQ(failure.reason, "no answer within 500 ms");
    EXPECT_LT(Clock::now() - start, kShort * 8);
    EXPECT_FALSE(served.client.alive());
    EXPECT_THAT(Children(), IsEmpty());
}

TEST(Client, EndsAWorkerThatEatsMemory) {
    Served served(Null("memory"), Limits(kLong, 256ull << 20));
    const WorkerFailure failure = served.Failure();
    EXPECT_EQ(failure.kind, Kind::kCrash);
    EXPECT_EQ(failure.reason, "used more than 256 MiB of memory");
    EXPECT_FALSE(served.client.alive());
}

TEST(Client, LimitsWhatAWorkerCanAllocateAtOnce) {
    Served served(Null("echo"), Limits(kLong, 256ull << 20));
    ASSERT_TRUE(served.client.Open());
    const auto children = Children();
    ASSERT_THAT(children, SizeIs(1));
    rlimit limit = {};
    ASSERT_EQ(prlimit(children[0], RLIMIT_DATA, nullptr, &limit), 0);
    EXPECT_GT(limit.rlim_cur, 256ull << 20);
    EXPECT_NE(limit.rlim_cur, RLIM_INFINITY);
    std::ifstream score("/proc/" + std::to_string(children[0]) + "/oom_score_adj");
    int value = 0;
    EXPECT_TRUE(score >> value);
    EXPECT_EQ(value, 1000);
}

TEST(Client, RestartsForASecondAttempt) {
    for (const char* hint : {"crash-once", "hang-once"}) {
        Served served(Null(hint), Limits(kShort));
        const WorkerFailure failure = served.Failure();
        EXPECT_TRUE(failure.kind == Kind::kCrash || failure.kind == Kind::kTimeout);
        ASSERT_TRUE(served.client.Restart(1));
        EXPECT_TRUE(served.client.alive());
        const auto answer = served.Run(43);
        ASSERT_TRUE(answer) << answer.error().reason;
        EXPECT_EQ((*answer)[0], 43u);
    }
}

TEST(Client, RestartsAWorkerThatLives) {
    Served served(Null("echo"));
    ASSERT_TRUE(served.Run());
    const auto before = Children();
    ASSERT_TRUE(served.client.Start());  // nothing to do
    EXPECT_EQ(Children(), before);
    ASSERT_TRUE(served.client.Restart(0));
    EXPECT_THAT(Children(), SizeIs(1));
    EXPECT_NE(Children(), before);
    EXPECT_TRUE(served.Run());
}

TEST(Client, SurvivesAKillFromOutsideDuringARun) {
    Served served(Null("hang"));
    std::thread killer([&] {
        std::this_thread::sleep_for(milliseconds(150));
        for (const pid_t child : Children()) {
            kill(child, SIGKILL);
        }
    });
    const WorkerFailure failure = served.Failure();
    killer.join();
    EXPECT_EQ(failure.kind, Kind::kCrash);
    EXPECT_EQ(failure.reason, "ended by signal 9 (Killed)");
    ASSERT_TRUE(served.client.Restart(1));
    EXPECT_TRUE(served.client.Open());
}

TEST(Client, SurvivesAKillBetweenRequests) {
    Served served(Null("echo"));
    ASSERT_TRUE(served.Run());
    const auto children = Children();
    ASSERT_THAT(children, SizeIs(1));
    kill(children[0], SIGKILL);
    EXPECT_TRUE(Eventually([&] { return !served.client.alive(); }));
    const auto answer = served.client.Run(0);
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().kind, Kind::kCrash);
    EXPECT_EQ(answer.error().reason, "ended by signal 9 (Killed)");
}

TEST(Client, AWorkerDoesNotOutliveAKilledParent) {
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    const pid_t parent = fork();
    ASSERT_GE(parent, 0);
    if (parent == 0) {
        Client client(ProgramPath(), Null("hang"), Limits(kLong));
        if (client.Start() && client.Open() && client.Load(Shape(0, 1))) {
            client.Inputs(1, 0, 1);
            (void)!write(ready[1], "r", 1);
            (void)client.Run(0);
        }
        _exit(1);
    }
    char byte = 0;
    ASSERT_EQ(read(ready[0], &byte, 1), 1);
    close(ready[0]);
    close(ready[1]);
    std::this_thread::sleep_for(milliseconds(50));
    const auto workers = ChildrenOf(parent);
    ASSERT_THAT(workers, SizeIs(1));
    EXPECT_TRUE(Eventually([&] { return StateOf(workers[0]).state == 'S'; }));  // hangs in its run
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    // A zombie has ended; whoever adopts it reaps it, or not.
    EXPECT_TRUE(Eventually([&] {
        const char state = StateOf(workers[0]).state;
        return state == 'X' || state == 'Z';
    }));
}

TEST(Client, LeavesNoDescriptorsAndNoZombies) {
    const auto before = Numbers("/proc/self/fd");
    {
        Served served(Null("crash-open"));
        for (int i = 0; i < 30; ++i) {
            EXPECT_EQ(served.client.Open().error().kind, Kind::kCrash);
            ASSERT_TRUE(served.client.Restart(0));
        }
        EXPECT_LE(Numbers("/proc/self/fd").size(), before.size() + 5);
        Served other(Null("echo"));
        EXPECT_TRUE(other.Run());
    }
    EXPECT_EQ(Numbers("/proc/self/fd"), before);
    EXPECT_THAT(Children(), IsEmpty());
}

TEST(Client, PassesNoDescriptorOn) {
    int leaky[2];
    ASSERT_EQ(pipe(leaky), 0);  // without O_CLOEXEC
    Served served(Faulty("count-descriptors"));
    const auto answer = served.Run();
    EXPECT_TRUE(answer) << answer.error().reason;
    close(leaky[0]);
    close(leaky[1]);
}

TEST(Client, WorksInAPoorSurrounding) {
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        // The worker's own descriptors are free for the client's; children are not waited for.
        close_range(0, 20, 0);
        signal(SIGCHLD, SIG_IGN);
        signal(SIGPIPE, SIG_DFL);
        bool good = false;
        {
            Served served(Null("echo"));
            const auto answer = served.Run();
            good = answer && (*answer)[0] == 42;
            Served crash(Null("crash"));
            good = good && crash.Failure().reason.starts_with("ended");
        }
        _exit(good ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
}

TEST(Client, KeepsADriversChatterToItself) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    {
        Served served(Faulty("chatter"));
        const auto answer = served.Run();
        EXPECT_TRUE(answer) << answer.error().reason;
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Client, QuotesTheLastWords) {
    Served served(Faulty("last-words"));
    const auto opened = served.client.Open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, Kind::kCrash);
    EXPECT_EQ(opened.error().reason, "exited with status 3: driver: ?no? such card");
}

TEST(Client, BelievesNoAnswer) {
    for (const char* fault : {"garbage", "endless-answer", "huge-answer"}) {
        Served served(Faulty(fault));
        const auto opened = served.client.Open();
        ASSERT_FALSE(opened);
        EXPECT_EQ(opened.error().kind, Kind::kCrash);
        EXPECT_EQ(opened.error().reason, "sent an answer that makes no sense") << fault;
        EXPECT_FALSE(served.client.alive());
    }
}

TEST(Client, DoesNotWaitForAWorkerThatDoesNotListen) {
    Served served(Faulty("deaf"), Limits(kShort));
    ASSERT_TRUE(served.client.Open());
    Program big = Shape(1, 1);
    big.glsl.assign(10u << 20, 'x');
    const auto loaded = served.client.Load(big);
    ASSERT_FALSE(loaded);
    EXPECT_EQ(loaded.error().kind, Kind::kTimeout);
}

TEST(Client, TellsOfAWorkerThatHangsUp) {
    Served served(Faulty("hang-up"));
    const auto opened = served.client.Open();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().kind, Kind::kCrash);
    EXPECT_EQ(opened.error().reason, "went silent");
    EXPECT_THAT(Children(), IsEmpty());
}

TEST(Client, EndsWhatAWorkerStarted) {
    pid_t grandchild = 0;
    {
        Served served(Faulty("fork"));
        ASSERT_TRUE(served.Run());
        const auto grandchildren = ChildrenOf(Children().at(0));
        ASSERT_THAT(grandchildren, SizeIs(1));
        grandchild = grandchildren[0];
    }
    EXPECT_TRUE(Eventually([&] {
        const char state = StateOf(grandchild).state;
        return state == 'X' || state == 'Z';
    }));
}

TEST(Client, ReportsAProgramThatDoesNotStart) {
    Client client("/no/such/program", Null("echo"), Limits(kLong));
    const auto started = client.Start();
    ASSERT_FALSE(started);
    EXPECT_EQ(started.error().message,
              "/no/such/program: cannot be started as a worker (No such file or directory)");
    EXPECT_FALSE(client.alive());
    EXPECT_EQ(client.Open().error().kind, Kind::kCrash);

    Client other("/bin/false", Null("echo"), Limits(kLong));
    ASSERT_TRUE(other.Start());
    EXPECT_EQ(other.Open().error().reason, "exited with status 1");
}

TEST(ClientDeathTest, WantsItsOrder) {
    Served served(Null("echo"));
    EXPECT_DEATH((void)served.client.Load(Shape(1, 1)), "internal error");
    EXPECT_DEATH(served.client.Inputs(0, 1, 1), "internal error");
}

TEST(Client, AWrongBatchEndsTheWorkerOnly) {
    Served served(Null("echo"));
    ASSERT_TRUE(served.Run());
    served.client.Inputs(1, 2, 2);  // the program was loaded for one word each
    const auto answer = served.client.Run(0);
    ASSERT_FALSE(answer);
    EXPECT_THAT(answer.error().reason, StartsWith("ended by signal 6 (Aborted): "));
    EXPECT_THAT(answer.error().reason, HasSubstr("internal error"));
}

TEST(Serve, RefusesToBeStartedByHand) {
    const std::string command = ProgramPath().string() + " worker 2>/dev/null 3</dev/null";
    const int status = std::system(command.c_str());
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2);
}

}  // namespace
}  // namespace etalon

// Taken instead of the test library's own, which the linker looks at last.
int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "worker") {
        const char* fault = std::getenv(etalon::kWorkerFault);
        if (fault != nullptr && !etalon::Misbehave(fault)) {
            return 1;
        }
        return etalon::ServeWorker(argc, argv);
    }
    testing::InitGoogleMock(&argc, argv);
    return RUN_ALL_TESTS();
}
