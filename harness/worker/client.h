// Client: the judging process's side of a device. Each device runs in a worker process of its own,
// so that a driver that crashes, hangs, loses its device or eats memory ends as a value here and
// costs nobody else anything.
//
// Lifecycle: Start (any number, returns at once) -> Open -> Load/Run... A crashed or hung worker is
// gone, and so is one that could not open its device; Restart starts a fresh one, in which programs
// must be loaded again. The destructor ends the worker. Not thread-safe; a client must be started
// from a thread that lives as long as the worker (the kernel ends a worker with the thread that
// started it).
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "base/result.h"
#include "device/backends.h"
#include "device/device.h"

namespace etalon {

struct WorkerLimits {
    std::chrono::milliseconds timeout{10'000};  // of one Open, Load or Run
    std::uint64_t memory_bytes = 2ull << 30;    // resident, beyond which a worker is ended
};

// Why a request has no answer.
struct WorkerFailure {
    enum class Kind : std::uint8_t {
        kUnsupported,  // as DeviceFailure
        kRejected,
        kStopped,
        kCrash,  // signal, exit, lost device, memory: the reason says which
        kTimeout,
    };
    Kind kind = Kind::kCrash;
    std::string reason;
};

template <typename T>
using WorkerResult = Result<T, WorkerFailure>;

class Client {
  public:
    // `program` is the executable that serves as the worker when its first argument is "worker"
    // (see serve.h).
    Client(std::string program, Candidate candidate, WorkerLimits limits);
    ~Client();
    Client(const Client&) = delete;
    Client& operator=(const Client&) = delete;

    const Candidate& candidate() const;

    // Starts the process, which opens its device at once; the environment of the candidate is added
    // to this one's. Idempotent while it lives.
    Status<> Start();

    // Waits until the worker has opened its device. Idempotent. After a failure the worker is gone.
    WorkerResult<DeviceInfo> Open();

    WorkerResult<std::uint32_t> Load(const Program& program);

    // The inputs of the next Run, to be filled by the caller in place, by columns: shared with the
    // worker, no copy. Valid until the next call of Inputs or Restart. At least one row, and not
    // before Start; throws std::bad_alloc where this process cannot map that much.
    std::span<std::uint32_t> Inputs(std::uint32_t rows, std::uint32_t input_words,
                                    std::uint32_t output_words);

    // Runs on the inputs filled last, at most DeviceInfo::max_rows rows and as many words as the
    // program was loaded with. The outputs are valid until the next call of Inputs or Restart.
    // Where `time` is not null, the run is timed.
    WorkerResult<std::span<const std::uint32_t>> Run(std::uint32_t handle, RunTime* time = nullptr);

    // Ends the worker, if it lives, and starts a fresh one with Candidate::attempt = attempt. Then
    // Open again.
    Status<> Restart(std::uint32_t attempt);

    bool alive() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace etalon
