#include "run/runner.h"

#include <algorithm>

#include "compile/text.h"
#include "run/fit.h"

namespace etalon {
namespace {

using Kind = EvaluationFailure::Kind;

// Rows that one dispatch takes: few dispatches for a million rows, and a bound on what is repeated
// after a crash.
constexpr std::uint64_t kChunkRows = 1u << 18;
constexpr std::uint64_t kChunkWords = 1u << 23;
// A baked program is as long as its rows are many; drivers compile longer ones ever more slowly.
constexpr std::size_t kBakedRowsPerProgram = 16;

EvaluationFailure FromWorker(const WorkerFailure& failure, const Program& program) {
    switch (failure.kind) {
        case WorkerFailure::Kind::kUnsupported:
            return {Kind::kUnsupported, failure.reason};
        case WorkerFailure::Kind::kRejected:
            return {Kind::kRejected,
                    "the driver's compiler refused a program that glslang accepts: " +
                        DriverError(failure.reason, program.line_names)};
        case WorkerFailure::Kind::kStopped:
            return {Kind::kStopped, failure.reason};
        case WorkerFailure::Kind::kCrash:
            return {Kind::kCrash, failure.reason};
        case WorkerFailure::Kind::kTimeout:
            return {Kind::kTimeout, failure.reason};
    }
    return {Kind::kCrash, failure.reason};
}

bool IsWorkersEnd(const EvaluationFailure& failure) {
    return failure.kind == Kind::kCrash || failure.kind == Kind::kTimeout;
}

EvaluationFailure FromCompiler(const CompileFailure& failure) {
    return {failure.kind == CompileFailure::Kind::kInput ? Kind::kInput : Kind::kUnsupported,
            failure.reason};
}

}  // namespace

Runner::Runner(std::unique_ptr<Client> client, DeviceInfo info, std::shared_ptr<Programs> programs)
    : client_(std::move(client)), info_(std::move(info)), programs_(std::move(programs)) {}

Runner::Outcome Runner::Renew(std::uint32_t attempt) {
    loaded_.clear();
    if (auto started = client_->Restart(attempt); !started) {
        return EvaluationFailure{Kind::kCrash, started.error().message};
    }
    if (auto opened = client_->Open(); !opened) {
        return EvaluationFailure{Kind::kCrash, "did not open again: " + opened.error().reason};
    }
    return Ok();
}

Result<std::uint32_t, EvaluationFailure> Runner::Ready(const std::string& key,
                                                       const Program& program) {
    if (const auto known = loaded_.find(key); known != loaded_.end()) {
        return known->second;
    }
    WorkerResult<std::uint32_t> handle = client_->Load(program);
    if (!handle) {
        return FromWorker(handle.error(), program);
    }
    loaded_[key] = *handle;
    return *handle;
}

Runner::Outcome Runner::RunChunk(const std::string& key, const Program& program, const Rows& inputs,
                                 std::uint64_t first, std::uint32_t rows, const Sink& sink,
                                 RunTime* time) {
    ETALON_TRY(handle, Ready(key, program));
    const std::span<std::uint32_t> words =
        client_->Inputs(rows, program.input_words, program.output_words);
    for (std::size_t column = 0; column < program.input_words; ++column) {
        const auto from = inputs.words.subspan(column * inputs.rows + first, rows);
        std::copy(from.begin(), from.end(),
                  words.begin() + static_cast<std::ptrdiff_t>(column * rows));
    }
    RunTime taken;
    WorkerResult<std::span<const std::uint32_t>> outputs =
        client_->Run(handle, time != nullptr ? &taken : nullptr);
    if (!outputs) {
        EvaluationFailure failure = FromWorker(outputs.error(), program);
        if (failure.kind == Kind::kStopped && first > 0) {
            failure.reason = "of the rows from " + std::to_string(first) + " on, " + failure.reason;
        }
        return failure;
    }
    if (time != nullptr) {
        *time = {time->seconds + taken.seconds, taken.clock,
                 time->processor_seconds + taken.processor_seconds};
    }
    sink(first, rows, *outputs);
    return Ok();
}

Runner::Outcome Runner::RunChunkTwice(const std::string& key, const Program& program,
                                      const Rows& inputs, std::uint64_t first, std::uint32_t rows,
                                      const Sink& sink, RunTime* time) {
    // A worker may have ended since the last chunk, by no fault of this one.
    Outcome once = client_->alive() ? Outcome(Ok()) : Renew(0);
    if (once) {
        once = RunChunk(key, program, inputs, first, rows, sink, time);
    }
    if (once || !IsWorkersEnd(once.error())) {
        return once;
    }
    Outcome again = Renew(1);
    if (again) {
        again = RunChunk(key, program, inputs, first, rows, sink, time);
    }
    if (again) {
        flake_ = once.error().reason;
        return again;
    }
    if (IsWorkersEnd(again.error())) {
        // The next case gets a fresh worker; one that does not even open will say so then.
        (void)Renew(0);
    }
    return again;
}

Runner::Outcome Runner::Evaluate(const Call& call, const Signature& signature, const Recipe& recipe,
                                 const Rows& inputs, const Sink& sink, RunTime* time) {
    flake_.clear();
    if (time != nullptr) {
        *time = {};
    }
    if (recipe.baked) {
        return EvaluateBaked(call, signature, recipe, inputs, sink, time);
    }
    const std::string key = Programs::KeyOf(call, recipe);
    const auto& compiled = programs_->Get(call, signature, recipe, TargetOf(info_), {});
    if (!compiled) {
        return FromCompiler(compiled.error());
    }
    const Program& program = *compiled;
    const std::uint64_t words =
        std::max<std::uint64_t>(1, program.input_words + program.output_words);
    const std::uint64_t chunk = std::clamp<std::uint64_t>(
        kChunkWords / words, 1, std::min<std::uint64_t>(kChunkRows, info_.max_rows));
    for (std::uint64_t first = 0; first < inputs.rows; first += chunk) {
        const auto rows = static_cast<std::uint32_t>(std::min(chunk, inputs.rows - first));
        ETALON_TRY_STEP(RunChunkTwice(key, program, inputs, first, rows, sink, time));
    }
    return Ok();
}

Result<std::vector<std::uint32_t>, EvaluationFailure> Runner::RunOnce(
    const std::string& name, const Program& program, std::span<const std::uint32_t> inputs) {
    std::vector<std::uint32_t> outputs;
    const std::string key = "once " + name;
    loaded_.erase(key);
    if (!client_->alive()) {
        ETALON_TRY_STEP(Renew(0));
    }
    const Outcome done = RunChunk(
        key, program, Rows{inputs, 1, inputs.size()}, 0, 1,
        [&](std::uint64_t, std::uint32_t, std::span<const std::uint32_t> words) {
            outputs.assign(words.begin(), words.end());
        },
        nullptr);
    if (!done) {
        if (IsWorkersEnd(done.error())) {
            (void)Renew(0);
        }
        return done.error();
    }
    return outputs;
}

Runner::Outcome Runner::EvaluateBaked(const Call& call, const Signature& signature,
                                      const Recipe& recipe, const Rows& inputs, const Sink& sink,
                                      RunTime* time) {
    for (std::uint64_t first = 0; first < inputs.rows; first += kBakedRowsPerProgram) {
        const auto rows = static_cast<std::uint32_t>(
            std::min<std::uint64_t>(kBakedRowsPerProgram, inputs.rows - first));
        std::vector<std::vector<std::uint32_t>> baked(rows);
        for (std::uint32_t row = 0; row < rows; ++row) {
            for (std::size_t column = 0; column < inputs.columns; ++column) {
                baked[row].push_back(inputs.words[column * inputs.rows + first + row]);
            }
        }
        const auto& program = programs_->Get(call, signature, recipe, TargetOf(info_), baked);
        if (!program) {
            return FromCompiler(program.error());
        }
        const std::string key = Programs::KeyOf(call, recipe) + "rows " + std::to_string(first);
        loaded_.erase(key);
        ETALON_TRY_STEP(RunChunkTwice(key, *program, inputs, first, rows, sink, time));
        // Other rows may come under the same number the next time.
        loaded_.erase(key);
    }
    return Ok();
}

}  // namespace etalon
