#include "worker/client.h"

#include <poll.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

#include "worker/channel.h"
#include "worker/message.h"
#include "worker/process.h"
#include "worker/shared_memory.h"

namespace etalon {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr milliseconds kSlice{20};  // between two looks at the worker's memory

// How long a worker that has closed its socket may take to end.
constexpr milliseconds kEndPatience{1'000};

std::string TimeText(milliseconds time) {
    return time.count() % 1000 == 0 ? std::to_string(time.count() / 1000) + " s"
                                    : std::to_string(time.count()) + " ms";
}

WorkerFailure Crash(std::string reason) {
    return {WorkerFailure::Kind::kCrash, std::move(reason)};
}

}  // namespace

struct Client::State {
    std::string program;
    Candidate candidate;
    WorkerLimits limits;
    std::optional<SharedMemory> memory;  // outlives a worker
    Batch batch;

    // Of the worker that lives.
    std::unique_ptr<Process> process;
    std::optional<Channel> channel;
    std::string request;
    std::string_view unsent;  // the end of `request`
    std::optional<WorkerResult<DeviceInfo>> opened;
    Clock::time_point looked;  // at its memory

    Status<> Start();
    void End();

    // Sends the request and waits for the answer. A failure other than a device's own refusal ends
    // the worker.
    template <typename T>
    WorkerResult<T> Ask(std::string framed);
    template <typename T>
    WorkerResult<T> Answer();

    using Failed = std::optional<WorkerFailure>;
    Failed Talk(std::string& answer);
    Failed WaitFor(short events, Clock::time_point deadline);
    Failed LookAtMemory();
};

Status<> Client::State::Start() {
    if (process != nullptr && !process->Ended()) {
        return Ok();
    }
    End();
    if (!memory) {
        ETALON_TRY(created, SharedMemory::Create());
        memory.emplace(std::move(created));
    }
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        return Error{program + ": cannot be started as a worker (" + std::strerror(errno) + ")"};
    }
    channel.emplace(Descriptor(ends[0]), kLongestAnswer);
    const Descriptor worker_end(ends[1]);
    auto started =
        Process::Start(program, candidate.environment, worker_end.number(), memory->descriptor());
    if (!started) {
        End();
        return started.error();
    }
    process = std::move(*started);
    // Sent now and answered when Open asks, so that several workers open their devices at once.
    request = Encode(OpenRequest{candidate, limits.memory_bytes});
    unsent = request;
    channel->Send(unsent);
    return Ok();
}

void Client::State::End() {
    process.reset();
    channel.reset();
    opened.reset();
    unsent = {};
}

Client::State::Failed Client::State::LookAtMemory() {
    const auto now = Clock::now();
    if (now - looked < kSlice) {
        return std::nullopt;
    }
    looked = now;
    if (process->ResidentBytes() <= limits.memory_bytes) {
        return std::nullopt;
    }
    return Crash("used more than " + std::to_string(limits.memory_bytes >> 20) + " MiB of memory");
}

Client::State::Failed Client::State::WaitFor(short events, Clock::time_point deadline) {
    for (;;) {
        pollfd watched[] = {{channel->descriptor(), events, 0},
                            {process->log_descriptor(), POLLIN, 0},
                            {process->end_descriptor(), POLLIN, 0}};
        // Where a signal interrupts it, nothing is marked and the clock is looked at all the same.
        poll(watched, std::size(watched), static_cast<int>(kSlice.count()));
        if (watched[1].revents != 0) {
            process->ReadLog();
        }
        // Before the end and the clock: an answer that is there counts, even where this process
        // was stopped meanwhile.
        if (watched[0].revents != 0) {
            return std::nullopt;
        }
        if (watched[2].revents != 0) {
            return Crash(process->End(kEndPatience));
        }
        if (Failed failed = LookAtMemory()) {
            return failed;
        }
        if (Clock::now() >= deadline) {
            return WorkerFailure{WorkerFailure::Kind::kTimeout,
                                 "no answer within " + TimeText(limits.timeout)};
        }
    }
}

Client::State::Failed Client::State::Talk(std::string& answer) {
    const auto deadline = Clock::now() + limits.timeout;
    for (;;) {
        const bool sending = !unsent.empty();
        switch (sending ? channel->Send(unsent) : channel->Receive(answer)) {
            case Channel::Step::kDone:
                if (!sending) {
                    // Here too: many short runs may fill the memory between two waits.
                    return LookAtMemory();
                }
                break;
            case Channel::Step::kBlocked:
                if (Failed failed = WaitFor(sending ? POLLOUT : POLLIN, deadline)) {
                    return failed;
                }
                break;
            case Channel::Step::kClosed:
                return Crash(process->End(kEndPatience));
            case Channel::Step::kMalformed:
                return Crash("sent an answer that makes no sense");
        }
    }
}

template <typename T>
WorkerResult<T> Client::State::Answer() {
    std::string message;
    if (Failed failed = Talk(message)) {
        End();
        return *std::move(failed);
    }
    std::optional<DeviceResult<T>> answer = DecodeAnswer<T>(message);
    if (!answer) {
        End();
        return Crash("sent an answer that makes no sense");
    }
    if (answer->ok()) {
        return **std::move(answer);
    }
    const DeviceFailure& failure = answer->error();
    switch (failure.kind) {
        case DeviceFailure::Kind::kUnsupported:
            return WorkerFailure{WorkerFailure::Kind::kUnsupported, failure.reason};
        case DeviceFailure::Kind::kRejected:
            return WorkerFailure{WorkerFailure::Kind::kRejected, failure.reason};
        case DeviceFailure::Kind::kStopped:
            return WorkerFailure{WorkerFailure::Kind::kStopped, failure.reason};
        case DeviceFailure::Kind::kLost:
            break;
    }
    End();
    return Crash("lost its device: " + failure.reason);
}

template <typename T>
WorkerResult<T> Client::State::Ask(std::string framed) {
    if (process == nullptr) {
        return Crash("the worker has ended");
    }
    ETALON_CHECK(opened && opened->ok());
    request = std::move(framed);
    unsent = request;
    return Answer<T>();
}

Client::Client(std::string program, Candidate candidate, WorkerLimits limits)
    : state_(std::make_unique<State>()) {
    state_->program = std::move(program);
    state_->candidate = std::move(candidate);
    state_->limits = limits;
}

Client::~Client() = default;

const Candidate& Client::candidate() const {
    return state_->candidate;
}

Status<> Client::Start() {
    return state_->Start();
}

WorkerResult<DeviceInfo> Client::Open() {
    if (state_->process == nullptr) {
        return Crash("the worker has ended");
    }
    if (!state_->opened) {
        auto answer = state_->Answer<DeviceInfo>();
        if (!answer) {
            state_->End();  // without a device there is nothing left for it to do
            return answer;
        }
        state_->opened = std::move(answer);
    }
    return *state_->opened;
}

WorkerResult<std::uint32_t> Client::Load(const Program& program) {
    return state_->Ask<std::uint32_t>(Encode(program));
}

std::span<std::uint32_t> Client::Inputs(std::uint32_t rows, std::uint32_t input_words,
                                        std::uint32_t output_words) {
    ETALON_CHECK(rows > 0 && state_->memory);
    state_->batch = {rows, input_words, output_words};
    state_->memory->Reserve(state_->batch);
    return state_->memory->Inputs(state_->batch);
}

WorkerResult<std::span<const std::uint32_t>> Client::Run(std::uint32_t handle, RunTime* time) {
    ETALON_CHECK(state_->batch.rows > 0);
    auto answer = state_->Ask<RunTime>(Encode(RunRequest{handle, state_->batch, time != nullptr}));
    if (!answer) {
        return answer.error();
    }
    if (time != nullptr) {
        *time = *answer;
    }
    return std::span<const std::uint32_t>(state_->memory->Outputs(state_->batch));
}

Status<> Client::Restart(std::uint32_t attempt) {
    state_->End();
    state_->batch = {};
    state_->candidate.attempt = attempt;
    return state_->Start();
}

bool Client::alive() const {
    return state_->process != nullptr && !state_->process->Ended();
}

}  // namespace etalon
