#include "chart/measure.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <ostream>
#include <thread>

#include "base/progress.h"
#include "run/fit.h"

namespace etalon {
namespace {

OperationCounts Sum(const OperationCounts& a, const OperationCounts& b) {
    return {a.arithmetic + b.arithmetic,
            a.division + b.division,
            a.special + b.special,
            a.comparison + b.comparison,
            a.integer + b.integer,
            a.fetch + b.fetch,
            a.other + b.other};
}

OperationCounts Share(const OperationCounts& a, double share) {
    return {a.arithmetic * share, a.division * share, a.special * share, a.comparison * share,
            a.integer * share,    a.fetch * share,    a.other * share};
}

class Measuring {
  public:
    Measuring(const Family& family, const MeasurePlan& plan,
              const std::vector<std::unique_ptr<Runner>>& runners, std::ostream& notes)
        : family_(family),
          plan_(plan),
          runners_(runners),
          notes_(notes),
          found_(runners.size(), std::vector<std::vector<Found>>(plan.points.size())),
          progress_(static_cast<std::int64_t>(plan.points.size() * plan.scenes.size() *
                                              (1 + runners.size() * (1 + TimeSteps())))) {}

    Result<FoundOnDevices> Measure() {
        for (const std::size_t scene : plan_.scenes) {
            ETALON_TRY_STEP(MeasureScene(scene));
        }
        progress_.Clear();
        return std::move(found_);
    }

  private:
    double SecondsInScene() const {
        return plan_.seconds / static_cast<double>(plan_.scenes.size());
    }
    // How many steps of progress the timing of a point in a scene counts as.
    std::size_t TimeSteps() const {
        return static_cast<std::size_t>(std::ceil(20 * SecondsInScene()));
    }
    const std::string& LabelAt(std::size_t p) const {
        return family_.points[plan_.points[p]].label;
    }

    Result<PreparedCase> PrepareAPoint(const Case& source) const {
        if (!plan_.at.empty()) {
            return PrepareAt(source, plan_.at);
        }
        ETALON_TRY(table, Expand(source.domains, source.seed));
        return family_.has_truth ? PrepareRows(source, std::move(table))
                                 : PrepareCall(source, std::move(table));
    }

    // A point in a scene, and what is counted of it.
    struct Ready {
        PreparedCase prepared;
        Result<CountedCall> counts;
    };

    Result<Ready> MakeReady(std::size_t p, std::size_t scene) const {
        auto one = PrepareAPoint(family_.points[plan_.points[p]].cases[scene]);
        if (!one) {
            const std::string& name = family_.scenes[scene].name;
            return Error{one.error().message + " (" + LabelAt(p) +
                         (name.empty() ? "" : ", scene '" + name + "'") + ")"};
        }
        Result<CountedCall> counts = CountOperations(*one);
        return Ready{std::move(*one), std::move(counts)};
    }

    // All points, on all cores: most of the time goes into compiling. Of several mistakes the first
    // one, in the order of the points, is the error.
    Result<std::vector<Ready>> MakeAllReady(std::size_t scene) {
        std::vector<std::optional<Result<Ready>>> made(plan_.points.size());
        std::atomic<std::size_t> next = 0;
        const auto work = [&] {
            for (std::size_t p = next++; p < made.size(); p = next++) {
                made[p] = MakeReady(p, scene);
                progress_.Step(LabelAt(p));
            }
        };
        std::vector<std::thread> threads;
        const std::size_t wanted =
            std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), made.size());
        for (std::size_t i = 1; i < wanted; ++i) {
            threads.emplace_back(work);
        }
        work();
        for (std::thread& thread : threads) {
            thread.join();
        }
        std::vector<Ready> ready;
        for (std::optional<Result<Ready>>& one : made) {
            if (!*one) {
                return one->error();
            }
            ready.push_back(std::move(**one));
        }
        return ready;
    }

    Status<> MeasureScene(std::size_t scene) {
        ETALON_TRY(ready, MakeAllReady(scene));
        std::vector<PreparedCase> prepared;
        for (Ready& one : ready) {
            prepared.push_back(std::move(one.prepared));
        }
        for (std::size_t d = 0; d < runners_.size(); ++d) {
            ETALON_TRY_STEP(MeasureOn(*runners_[d], scene, prepared, found_[d]));
            for (std::size_t p = 0; p < plan_.points.size(); ++p) {
                Found& found = found_[d][p].back();
                if (ready[p].counts) {
                    found.counts = *ready[p].counts;
                } else {
                    found.AddReason("no counts: " + ready[p].counts.error().message);
                }
            }
        }
        return Ok();
    }

    // Adds a scene to what was found of each point.
    Status<> MeasureOn(Runner& runner, std::size_t scene, const std::vector<PreparedCase>& prepared,
                       std::vector<std::vector<Found>>& found) {
        Recipe recipe = DefaultRecipe(runner.info());
        const std::vector<std::string>& own = prepared.front().source.recipes;
        if (!plan_.recipe.empty() || !own.empty()) {
            ETALON_TRY(wanted, ParseRecipe(plan_.recipe.empty() ? own.front() : plan_.recipe));
            recipe = wanted;
        }
        // One stage for all: their times are to be compared.
        if (std::any_of(prepared.begin(), prepared.end(), [](const PreparedCase& one) {
                return one.signature.stage == Stage::kFragment;
            })) {
            recipe.stage = Stage::kFragment;
        }
        const Result<Recipe> fitted = FitRecipe(recipe, runner.info());
        for (std::size_t p = 0; p < plan_.points.size(); ++p) {
            Found one;
            one.recipe = RecipeText(fitted ? *fitted : recipe);
            if (!fitted) {
                one.reason = fitted.error().message;
            } else {
                ETALON_TRY_STEP(Evaluate(prepared[p], runner, *fitted, one));
                if (one.errors) {
                    one.errors->shown_scene = family_.scenes[scene].name;
                }
            }
            found[p].push_back(std::move(one));
            progress_.Step(LabelAt(p));
        }
        if (fitted && plan_.seconds > 0) {
            Time(prepared, runner, *fitted, found);
        }
        return Ok();
    }

    Status<> Evaluate(const PreparedCase& prepared, Runner& runner, const Recipe& recipe,
                      Found& found) {
        Gathered results(prepared.table.rows, prepared.signature.OutputWords(prepared.call));
        const auto evaluated = runner.Evaluate(
            prepared.call, prepared.signature, recipe,
            {prepared.table.words, prepared.table.rows, prepared.table.columns.size()},
            [&](std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
                results.Take(first, rows, words);
            });
        if (!runner.flake().empty()) {
            progress_.Clear();
            notes_ << runner.info().name << " failed once and not again: " << runner.flake()
                   << "\n";
        }
        if (!evaluated) {
            using Kind = EvaluationFailure::Kind;
            if (evaluated.error().kind == Kind::kInput) {
                return Error{evaluated.error().reason};
            }
            found.reason = evaluated.error().reason;
            found.failed = evaluated.error().kind != Kind::kUnsupported;
        } else if (family_.has_truth) {
            found.errors = ErrorsOf(prepared, results, family_.measure);
        }
        return Ok();
    }

    // The points that could be evaluated, all in turns with each other.
    void Time(const std::vector<PreparedCase>& prepared, Runner& runner, const Recipe& recipe,
              std::vector<std::vector<Found>>& found) {
        std::vector<PreparedCase> subjects;
        std::vector<std::size_t> of_subject;
        for (std::size_t p = 0; p < plan_.points.size(); ++p) {
            if (found[p].back().reason.empty()) {
                subjects.push_back(prepared[p]);
                of_subject.push_back(p);
            }
        }
        CostOptions options;
        options.most_seconds *= SecondsInScene() / options.seconds;
        options.seconds = SecondsInScene();
        const auto steps = static_cast<double>(TimeSteps() * plan_.points.size());
        double done = 0;
        const auto step = [&](double share) {
            for (; done + 1 <= share * steps; ++done) {
                progress_.Step("timing on " + runner.info().name);
            }
        };
        if (!subjects.empty()) {
            const auto times = EstimateTimes(subjects, runner, recipe, options, step);
            for (std::size_t k = 0; k < subjects.size(); ++k) {
                Found& one = found[of_subject[k]].back();
                if (!times || !(*times)[k]) {
                    one.AddReason("no time: " +
                                  (times ? (*times)[k].error() : times.error()).message);
                } else {
                    one.time = *(*times)[k];
                }
            }
        }
        step(1);
    }

    const Family& family_;
    const MeasurePlan& plan_;
    const std::vector<std::unique_ptr<Runner>>& runners_;
    std::ostream& notes_;
    FoundOnDevices found_;
    Progress progress_;
};

}  // namespace

void Found::AddReason(const std::string& text) {
    reason += (reason.empty() ? "" : "; ") + text;
}

Result<FoundOnDevices> MeasureFamily(const Family& family, const MeasurePlan& plan,
                                     const std::vector<std::unique_ptr<Runner>>& runners,
                                     std::ostream& notes) {
    return Measuring(family, plan, runners, notes).Measure();
}

Found Together(const std::vector<Found>& of_scenes) {
    Found all;
    all.recipe = of_scenes.front().recipe;
    for (const Found& one : of_scenes) {
        all.failed = all.failed || one.failed;
        if (all.reason.empty()) {
            all.reason = one.reason;
        }
    }
    const auto all_have = [&](auto Found::*part) {
        return std::all_of(of_scenes.begin(), of_scenes.end(),
                           [part](const Found& one) { return (one.*part).has_value(); });
    };
    const double share = 1 / static_cast<double>(of_scenes.size());
    if (all_have(&Found::errors)) {
        all.errors.emplace();
        for (const Found& one : of_scenes) {
            all.errors->Add(*one.errors);
        }
    }
    if (all_have(&Found::time)) {
        all.time.emplace();
        for (const Found& one : of_scenes) {
            all.time->seconds += share * one.time->seconds;
            all.time->low += share * one.time->low;
            all.time->high += share * one.time->high;
            all.time->rounds += one.time->rounds;
            all.time->clock = one.time->clock;
        }
    }
    if (all_have(&Found::counts)) {
        all.counts.emplace();
        for (const Found& one : of_scenes) {
            all.counts->mean = Sum(all.counts->mean, Share(one.counts->mean, share));
            if (one.counts->worst.Total() > all.counts->worst.Total()) {
                all.counts->worst = one.counts->worst;
            }
        }
    }
    return all;
}

}  // namespace etalon
