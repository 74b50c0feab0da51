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

namespace etalon {
namespace {

// Evaluations at once: enough for each core of a host, and for all of a graphics card's.
constexpr std::uint64_t kRowsOnHost = 1u << 14;
constexpr std::uint64_t kRowsOnCard = 1u << 18;
// So long should a run be: far above what the clocks tell apart, and what a submission costs.
constexpr double kRunSeconds = 4e-3;
constexpr std::size_t kFewestRounds = kParts;
// What a turn of a host's loop does beside its calls takes some nanoseconds, in which a short call
// would hide: the calls of a turn must take far longer.
constexpr double kTurnSeconds = 50e-9;
// A call that is less of its loop is not told more exactly than this part.
constexpr double kSmallPart = 0.1;
// They make the program longer, which must fit a cache; words of SPIR-V.
constexpr std::size_t kMostWords = 1u << 13;

double SecondsOf(const RunTime& time, const Runner& runner) {
    return runner.info().on_host ? time.processor_seconds : time.seconds;
}

std::string ClockName(const RunTime& time, const Runner& runner) {
    if (runner.info().on_host) {
        return "processor time";
    }
    return time.clock == RunTime::Clock::kDevice ? "device timestamps" : "host clock";
}

// How many calls a turn may hold at most.
unsigned MostCalls(const PreparedCase& subject) {
    Recipe recipe;
    recipe.stage = subject.signature.stage;
    const auto program = Compile(subject.call, subject.signature, recipe, Target{}, {});
    return program ? static_cast<unsigned>(
                         std::clamp<std::size_t>(kMostWords / program->spirv.size(), 1, kMostSlots))
                   : 1;
}

// A call's loop, and the same loop with fewer calls: with none, where a call takes long, else with
// half of them, for the calls that are left fill the time in which others would hide.
class Subject {
  public:
    static Result<Subject> Make(const PreparedCase& prepared, const Recipe& recipe,
                                std::uint64_t fewest_rows, std::filesystem::path name) {
        Subject subject(prepared, recipe, fewest_rows, std::move(name));
        ETALON_TRY_STEP(subject.Hold(1, 0));
        return subject;
    }

    // Finds how many calls a turn has, and how many turns a run.
    Status<> Settle(Runner& runner) {
        ETALON_TRY_STEP(SettleTurns(runner));
        ETALON_TRY(run, full_->Make(runner, turns_));
        const double turn =
            SecondsOf(run.time, runner) / static_cast<double>(full_->rows() * turns_);
        if (turn >= kTurnSeconds) {
            return Ok();
        }
        const auto wanted = static_cast<unsigned>(2 * kTurnSeconds / std::max(turn, 1e-9)) + 1;
        const unsigned half = std::min(wanted, MostCalls(*prepared_)) / 2;
        if (half == 0) {
            return Ok();
        }
        ETALON_TRY_STEP(Hold(2 * half, half));
        turns_ = 1;
        return SettleTurns(runner);
    }

    // One run of the loop, or of the one with fewer calls.
    Status<> Measure(Runner& runner, bool less) {
        ETALON_TRY(run, (less ? less_ : full_)->Make(runner, turns_));
        (less ? times_.less : times_.full).push_back(SecondsOf(run.time, runner));
        return Ok();
    }

    TimeEstimate Told() const {
        const double evaluations = static_cast<double>(full_->rows()) * turns_ * calls_;
        const LoopEstimate found = Estimate(times_, evaluations);
        return {found.seconds, found.low, found.high, times_.full.size(), clock_};
    }

    // Of a call that is a small part of its loop, the spread is held against that part of the loop:
    // no number of rounds tells the time of what takes none.
    bool IsWithin(double spread) const {
        const LoopEstimate found = Estimate(times_, 1);
        const double loop = *std::min_element(times_.full.begin(), times_.full.end());
        return found.high - found.low <= spread * std::max(found.seconds, kSmallPart * loop);
    }

  private:
    Subject(const PreparedCase& prepared, const Recipe& recipe, std::uint64_t fewest_rows,
            std::filesystem::path name)
        : prepared_(&prepared),
          recipe_(recipe),
          fewest_rows_(fewest_rows),
          name_(std::move(name)) {}

    // Makes the loop of so many calls, and the one of `less` calls in as many slots. The names are
    // new, by which a runner knows programs.
    Status<> Hold(unsigned calls, unsigned less) {
        const std::string name = name_.string() + "_" + std::to_string(calls);
        ETALON_TRY(full, LoopCall(*prepared_, name + "_full.glsl", calls, calls));
        ETALON_TRY(fewer, LoopCall(*prepared_, name + "_less.glsl", calls, less));
        full_.emplace(std::move(full), prepared_->table, recipe_, fewest_rows_);
        less_.emplace(std::move(fewer), prepared_->table, recipe_, fewest_rows_);
        calls_ = calls - less;
        return Ok();
    }

    Status<> SettleTurns(Runner& runner) {
        // Drivers compile in the first run.
        ETALON_TRY_STEP(less_->Make(runner, turns_));
        ETALON_TRY_STEP(full_->Make(runner, turns_));
        for (std::uint32_t most = kMostTurns;;) {
            ETALON_TRY(run, full_->Make(runner, turns_));
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

    const PreparedCase* prepared_;
    Recipe recipe_;
    std::uint64_t fewest_rows_;
    std::filesystem::path name_;
    std::optional<TimedLoop> full_;
    std::optional<TimedLoop> less_;
    unsigned calls_ = 1;  // that the full loop has more, in each turn
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
    std::vector<std::size_t> order_;  // subject i's loop is 2 i, its lesser one 2 i + 1
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
