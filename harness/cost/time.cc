#include <algorithm>
#include <numeric>
#include <optional>
#include <random>

#include "compile/compile.h"
#include "cost/cost.h"
#include "cost/estimate.h"
#include "cost/scratch_folder.h"
#include "cost/timed_loop.h"
#include "run/fit.h"
#include "spirv/loops.h"

namespace etalon {
namespace {

// Evaluations at once: enough for each core of a host, and for all of a graphics card's.
constexpr std::uint64_t kRowsOnHost = 1u << 14;
constexpr std::uint64_t kRowsOnCard = 1u << 18;
// So long should a run be: far above what the clocks tell apart, and what a submission costs.
constexpr double kRunSeconds = 4e-3;
constexpr std::size_t kFewestRounds = kParts;
// Copies of a call make its program longer, which must fit a cache; words of SPIR-V.
constexpr std::size_t kMostWords = 1u << 12;

double SecondsOf(const RunTime& time, const Runner& runner) {
    return runner.info().on_host ? time.processor_seconds : time.seconds;
}

std::string ClockName(const RunTime& time, const Runner& runner) {
    if (runner.info().on_host) {
        return "processor time";
    }
    return time.clock == RunTime::Clock::kDevice ? "device timestamps" : "host clock";
}

// How many evaluations of the call a turn may hold.
unsigned CopiesFor(const PreparedCase& subject) {
    Recipe recipe;
    recipe.stage = subject.signature.stage;
    const auto program = Compile(subject.call, subject.signature, recipe, Target{}, {});
    if (!program || spirv::HasLoop(program->spirv)) {
        return 1;
    }
    return static_cast<unsigned>(
        std::clamp<std::size_t>(kMostWords / program->spirv.size(), 1, kMostCopies));
}

// A call's loop and its empty loop.
class Subject {
  public:
    static Result<Subject> Make(const PreparedCase& prepared, const Recipe& recipe,
                                std::uint64_t fewest_rows, const std::filesystem::path& name) {
        const unsigned copies = CopiesFor(prepared);
        ETALON_TRY(full, LoopCall(prepared, name.string() + "full.glsl", copies, false));
        ETALON_TRY(empty, LoopCall(prepared, name.string() + "empty.glsl", copies, true));
        return Subject({std::move(full), prepared.table, recipe, fewest_rows},
                       {std::move(empty), prepared.table, recipe, fewest_rows}, copies);
    }

    // Finds how many turns a run has.
    Status<> Settle(Runner& runner) {
        // Drivers compile in the first run.
        ETALON_TRY_STEP(empty_.Make(runner, turns_));
        ETALON_TRY_STEP(full_.Make(runner, turns_));
        for (std::uint32_t most = kMostTurns;;) {
            ETALON_TRY(run, full_.Make(runner, turns_));
            clock_ = ClockName(run.time, runner);
            if (run.turns < turns_) {
                most = std::max(run.turns / 2, 1u);
                if (turns_ == most) {
                    return Error{"the device ends the call's own loops"};
                }
                turns_ = most;
                continue;
            }
            const double seconds = std::max(SecondsOf(run.time, runner), kRunSeconds / 64);
            const auto wanted = static_cast<std::uint32_t>(turns_ * kRunSeconds / seconds);
            if (wanted <= turns_ + turns_ / 4 || turns_ >= most) {
                return Ok();
            }
            turns_ = std::min(wanted, most);
        }
    }

    // One run of the loop, or of the empty one.
    Status<> Measure(Runner& runner, bool empty) {
        ETALON_TRY(run, (empty ? empty_ : full_).Make(runner, turns_));
        (empty ? times_.empty : times_.full).push_back(SecondsOf(run.time, runner));
        return Ok();
    }

    TimeEstimate Told() const {
        const double evaluations = static_cast<double>(full_.rows()) * turns_ * copies_;
        const LoopEstimate found = Estimate(times_, evaluations);
        return {found.seconds, found.low, found.high, times_.full.size(), clock_};
    }

    bool IsWithin(double spread) const { return Estimate(times_, 1).Spread() <= spread; }

  private:
    Subject(TimedLoop full, TimedLoop empty, unsigned copies)
        : full_(std::move(full)), empty_(std::move(empty)), copies_(copies) {}

    TimedLoop full_;
    TimedLoop empty_;
    unsigned copies_;
    std::uint32_t turns_ = 1;
    std::string clock_;
    LoopTimes times_;
};

// All subjects in turns.
class Contest {
  public:
    Contest(Runner& runner, const CostOptions& options, const CostProgress& progress,
            std::size_t subjects)
        : runner_(runner),
          options_(options),
          progress_(progress),
          order_(2 * subjects),
          random_(static_cast<std::mt19937::result_type>(options.seed)) {
        std::iota(order_.begin(), order_.end(), std::size_t{0});
    }

    void Settle(std::vector<Result<Subject>>& subjects) {
        for (std::size_t i = 0; i < subjects.size(); ++i) {
            if (subjects[i]) {
                if (auto settled = subjects[i]->Settle(runner_); !settled) {
                    subjects[i] = settled.error();
                }
            }
            Tell(kSettlingShare * static_cast<double>(i + 1) /
                 static_cast<double>(subjects.size()));
        }
    }

    void Run(std::vector<Result<Subject>>& subjects) {
        const auto count = static_cast<double>(std::count_if(
            subjects.begin(), subjects.end(), [](const auto& one) { return one.ok(); }));
        const Stopwatch stopwatch;
        for (std::size_t round = 1; count > 0; ++round) {
            MakeRound(subjects);
            const double seconds = stopwatch.Read().seconds;
            Tell(kSettlingShare +
                 (1 - kSettlingShare) * std::min(1.0, seconds / (count * options_.seconds)));
            if (round < kFewestRounds || seconds < count * options_.seconds) {
                continue;
            }
            if (seconds >= count * options_.most_seconds || AreNarrow(subjects)) {
                return;
            }
        }
    }

  private:
    static constexpr double kSettlingShare = 0.2;

    void Tell(double share) const {
        if (progress_) {
            progress_(share);
        }
    }

    // Each loop once, in an order of this round's own.
    void MakeRound(std::vector<Result<Subject>>& subjects) {
        std::shuffle(order_.begin(), order_.end(), random_);
        for (const std::size_t loop : order_) {
            Result<Subject>& subject = subjects[loop / 2];
            if (!subject) {
                continue;
            }
            if (auto measured = subject->Measure(runner_, loop % 2 == 1); !measured) {
                subject = measured.error();
            }
        }
    }

    bool AreNarrow(const std::vector<Result<Subject>>& subjects) const {
        return std::all_of(subjects.begin(), subjects.end(), [&](const Result<Subject>& one) {
            return !one || one->IsWithin(options_.spread);
        });
    }

    Runner& runner_;
    const CostOptions& options_;
    const CostProgress& progress_;
    std::vector<std::size_t> order_;  // subject i's loop is 2 i, its empty one 2 i + 1
    std::mt19937 random_;
};

}  // namespace

Result<std::vector<Result<TimeEstimate>>> EstimateTimes(std::span<const PreparedCase> subjects,
                                                        Runner& runner, const Recipe& recipe,
                                                        const CostOptions& options,
                                                        const CostProgress& progress) {
    ETALON_TRY(fitted, FitRecipe(recipe, runner.info()));
    if (fitted.baked) {
        return Error{"a call whose inputs are constants has no time: not with '+baked'"};
    }
    ETALON_TRY(folder, ScratchFolder::Make());
    std::vector<Result<Subject>> measured;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        measured.push_back(Subject::Make(subjects[i], fitted,
                                         runner.info().on_host ? kRowsOnHost : kRowsOnCard,
                                         folder.path() / std::to_string(i)));
    }
    Contest contest(runner, options, progress, subjects.size());
    contest.Settle(measured);
    contest.Run(measured);
    std::vector<Result<TimeEstimate>> told;
    for (const Result<Subject>& subject : measured) {
        told.push_back(subject ? Result<TimeEstimate>(subject->Told())
                               : Result<TimeEstimate>(subject.error()));
    }
    return told;
}

}  // namespace etalon
