// Runner: one device through a run: compiles for it, runs rows in chunks, starts a fresh worker
// after a failure.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "probe/call.h"
#include "run/programs.h"
#include "worker/client.h"

namespace etalon {

// Why there are no results.
struct EvaluationFailure {
    enum class Kind : std::uint8_t {
        kInput,        // the user's source or call is wrong
        kUnsupported,  // skip
        kRejected,     // the driver's compiler refused a valid program: fail
        kStopped,      // the program has no result at some row: fail
        kCrash,
        kTimeout,
    };
    Kind kind = Kind::kInput;
    std::string reason;
};

// A table of inputs: word of (row, column) at words[column * rows + row].
struct Rows {
    std::span<const std::uint32_t> words;
    std::uint64_t rows = 0;
    std::size_t columns = 0;
};

class Runner {
  public:
    Runner(std::unique_ptr<Client> client, DeviceInfo info, std::shared_ptr<Programs> programs);

    const DeviceInfo& info() const { return info_; }

    // Receives the outputs of `rows` rows from `first` on: word of (row, column) at words[column *
    // rows + row - first].
    using Sink = std::function<void(std::uint64_t first, std::uint32_t rows,
                                    std::span<const std::uint32_t> words)>;

    // Evaluates the call at all rows. A crash or a hang is tried once more in a fresh worker, from
    // the failed chunk on; where that succeeds, flake() tells what had happened. Where `time` is
    // not null, it is set to how long the device worked on all chunks together.
    Result<Nothing, EvaluationFailure> Evaluate(const Call& call, const Signature& signature,
                                                const Recipe& recipe, const Rows& inputs,
                                                const Sink& sink, RunTime* time = nullptr);

    // The outputs of a program that the caller has made, under a name of its own, at one row. A
    // crash or a hang is not tried again.
    Result<std::vector<std::uint32_t>, EvaluationFailure> RunOnce(
        const std::string& name, const Program& program, std::span<const std::uint32_t> inputs);

    // What went wrong once in the last Evaluate and not again; empty otherwise.
    const std::string& flake() const { return flake_; }

  private:
    using Outcome = Result<Nothing, EvaluationFailure>;

    // The program's handle in the present worker, compiled and loaded on first use.
    Result<std::uint32_t, EvaluationFailure> Ready(const std::string& key, const Program& program);
    // What a chunk takes is added to `time`.
    Outcome RunChunk(const std::string& key, const Program& program, const Rows& inputs,
                     std::uint64_t first, std::uint32_t rows, const Sink& sink, RunTime* time);
    Outcome RunChunkTwice(const std::string& key, const Program& program, const Rows& inputs,
                          std::uint64_t first, std::uint32_t rows, const Sink& sink, RunTime* time);
    Outcome EvaluateBaked(const Call& call, const Signature& signature, const Recipe& recipe,
                          const Rows& inputs, const Sink& sink, RunTime* time);
    Outcome Renew(std::uint32_t attempt);

    std::unique_ptr<Client> client_;
    DeviceInfo info_;
    std::map<std::string, std::uint32_t> loaded_;  // program key -> handle in the present worker
    std::shared_ptr<Programs> programs_;
    std::string flake_;
};

}  // namespace etalon
