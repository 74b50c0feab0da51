#include "run/case_run.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "base/check.h"
#include "base/file.h"
#include "run/blame.h"
#include "run/expected_failure.h"
#include "run/gathered.h"
#include "run/observe.h"

namespace etalon {
namespace {

// Collects what the judges say of one output or law into the record.
class Collector {
  public:
    Collector(const PreparedCase& prepared, Record& record)
        : prepared_(prepared), record_(record) {}

    // `observe(row, is_refused)` makes the observation of a row; it is asked only for the worst
    // one.
    template <typename Observe>
    void Add(const std::string& what, const Summary& summary, Observe observe) {
        record_.judged += summary.judged;
        record_.refused += summary.refused;
        if (summary.refused > 0) {
            record_.failed.push_back(what);
        }
        JudgedThing thing{what, summary.judged, summary.refused, std::nullopt};
        if (summary.judged > 0) {
            const std::uint64_t row =
                summary.worst_used_at == Summary::kNone ? 0 : summary.worst_used_at;
            thing.worst = observe(row, summary.refused > 0);
            thing.worst->used = summary.worst_used;
            thing.worst->inputs = InputsAt(prepared_.table, row);
            if (!record_.worst || summary.worst_used > record_.worst->used) {
                record_.worst = thing.worst;
            }
        }
        things_.push_back(std::move(thing));
    }
    const std::vector<JudgedThing>& things() const { return things_; }

  private:
    const PreparedCase& prepared_;
    Record& record_;
    std::vector<JudgedThing> things_;
};

Rows RowsOfTable(const Table& table) {
    return {table.words, table.rows, table.columns.size()};
}

ShareCount CountOf(const JudgedColumn& column, const Tally& tally) {
    const Shares& shares = *column.accept.shares;
    ShareCount count;
    count.output = column.name;
    count.search = shares.beyond.has_value();
    count.rows = tally.decided;
    count.wrong = tally.wrong;
    count.wrong_allowed = shares.wrong;
    count.hits = tally.hits;
    count.missed = tally.missed;
    count.missed_allowed = shares.missed;
    count.worst_right = tally.worst_right_error;
    count.undecided = tally.undecided;
    return count;
}

// Evaluates a call at all rows; where that fails, the record says why and nothing is returned.
std::optional<Gathered> Evaluate(const Call& call, const Signature& signature, const Table& table,
                                 Runner& runner, const Recipe& recipe, Record& record) {
    Gathered results(table.rows, signature.OutputWords(call));
    const auto evaluated = runner.Evaluate(
        call, signature, recipe, RowsOfTable(table),
        [&](std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
            results.Take(first, rows, words);
        });
    record.flake += runner.flake();
    if (!evaluated) {
        record.verdict = VerdictOf(evaluated.error());
        record.reason = evaluated.error().reason;
        return std::nullopt;
    }
    return results;
}

// What judges the results of one device by one recipe.
struct Bench {
    Runner& runner;
    const Recipe& recipe;
    Evaluations& evaluations;
    Collector& collector;
    Record& record;

    Evaluation& EvaluationOf(const Call& call, const Signature& signature,
                             const Table& table) const {
        return evaluations.Of(call, signature, recipe, RowsOfTable(table));
    }
};

// By what a specification allows. Values without a bound are counted and not judged.
void JudgeSpec(const JudgedColumn& column, std::span<const std::uint32_t> words, const Bench& bench,
               Evaluation& evaluation, Blame& blame) {
    const evaluate::Profile& spec = column.own_spec ? ProfileOf(bench.runner.info()) : *column.spec;
    const Result<Evaluation::Bounds>& bounds = evaluation.BoundsBy(spec);
    if (!bounds) {
        bench.record.unjudged += words.size();
        return;
    }
    const auto allowed =
        std::span(bounds->allowed).subspan(column.column * words.size(), words.size());
    Summary summary;
    std::uint64_t first = Summary::kNone;
    for (std::uint64_t row = 0; row < words.size(); ++row) {
        if (allowed[row].kind == Allowed::Kind::kUnbounded) {
            ++bench.record.unjudged;
            continue;
        }
        first = std::min(first, row);
        summary.Add(row, JudgeAllowed(allowed[row], words[row]));
    }
    if (summary.worst_used_at == Summary::kNone) {
        summary.worst_used_at = first;
    }
    blame.AddColumn(column, words, summary.refused);
    bench.collector.Add(column.name, summary, [&](std::uint64_t row, bool is_refused) {
        Observation observation = ObserveAllowed(column, allowed[row], spec.name, words[row], row);
        blame.Explain(column, words[row], row, is_refused, observation);
        return observation;
    });
}

void JudgeByTruth(const JudgedColumn& column, std::span<const std::uint32_t> words,
                  const Bench& bench, Blame& blame) {
    Summary summary;
    if (column.accept.shares) {
        Tally tally;
        TallyColumn(column.accept, column.scalar, words, column.truth, 0, tally);
        summary = tally.Settle(*column.accept.shares);
        bench.record.shares.push_back(CountOf(column, tally));
    } else {
        JudgeColumn(column.accept, column.scalar, words, column.truth, 0, summary);
    }
    blame.AddColumn(column, words, summary.refused);
    bench.collector.Add(column.name, summary, [&](std::uint64_t row, bool is_refused) {
        Observation observation = ObserveOutput(column, words[row], row);
        blame.Explain(column, words[row], row, is_refused, observation);
        return observation;
    });
}

// The call's outputs. False where there was no result to judge.
bool JudgeOutputs(const PreparedCase& prepared, const Bench& bench) {
    const std::optional<Gathered> results =
        Evaluate(prepared.call, prepared.signature, prepared.table, bench.runner, bench.recipe,
                 bench.record);
    if (!results) {
        return false;
    }
    Evaluation& evaluation = bench.EvaluationOf(prepared.call, prepared.signature, prepared.table);
    Blame blame(evaluation, prepared.table, ProfileOf(bench.runner.info()), bench.record);
    for (const JudgedColumn& column : prepared.judged) {
        const std::span<const std::uint32_t> words = results->Column(column.column);
        if (column.IsBySpec()) {
            JudgeSpec(column, words, bench, evaluation, blame);
        } else {
            JudgeByTruth(column, words, bench, blame);
        }
    }
    return true;
}

bool JudgeLawRows(const PreparedCase& prepared, const PreparedLaw& law, const Bench& bench) {
    const std::optional<Gathered> results =
        Evaluate(law.call, law.signature, prepared.table, bench.runner, bench.recipe, bench.record);
    if (!results) {
        return false;
    }
    Blame blame(bench.EvaluationOf(law.call, law.signature, prepared.table), prepared.table,
                ProfileOf(bench.runner.info()), bench.record);
    for (std::size_t i = 0; i < law.pairs.size(); ++i) {
        const std::span<const std::uint32_t> left = results->Column(law.pairs[i].first);
        const std::span<const std::uint32_t> right = results->Column(law.pairs[i].second);
        Summary summary;
        for (std::uint64_t row = 0; row < prepared.table.rows; ++row) {
            summary.Add(row, JudgeLaw(law.law, law.scalars[i], left[row], right[row]));
        }
        blame.AddLaw(law, i, left, right, summary.refused);
        bench.collector.Add(LawLabel(law.law), summary, [&](std::uint64_t row, bool is_refused) {
            Observation observation = ObserveLaw(law, i, left[row], right[row]);
            blame.ExplainLaw(law, i, left[row], right[row], row, is_refused, observation);
            return observation;
        });
    }
    return true;
}

std::string WhyUnjudged(const Record& record) {
    return record.unevaluated.empty() ? "the specification bounds no value at any row"
                                      : "there is no bound to judge by: " + record.unevaluated;
}

std::string RepeatCommand(const Record& record, const RepeatContext& context) {
    std::string command = context.program + " run " + ShellWord(record.case_path) +
                          context.options + " --device " + ShellWord(record.device) + " --recipe " +
                          record.recipe;
    // A figure is of the whole case.
    const bool is_figure = std::any_of(record.figures.begin(), record.figures.end(),
                                       [](const FigureSeen& figure) { return !figure.agrees; });
    const Observation* worst = record.Shown();
    if (worst == nullptr && record.worst) {
        worst = &*record.worst;
    }
    if (worst != nullptr && !is_figure) {
        std::string at;
        for (const auto& [name, value] : worst->inputs) {
            at += (at.empty() ? "" : ",") + name + "=" + value.hex;
        }
        command += " --at " + ShellWord(at);
    }
    return command;
}

// Of a record that has results.
void SetVerdict(Record& record) {
    if (record.refused > 0) {
        record.verdict = Verdict::kFail;
    } else if (record.outside > 0) {
        record.verdict = Verdict::kNonconforming;
        record.failed = record.outside_in;
    } else if (record.judged > 0) {
        record.verdict = Verdict::kPass;
    } else {
        ETALON_CHECK(!record.shares.empty() || record.unjudged > 0);
        record.verdict = Verdict::kSkip;
        record.reason =
            record.shares.empty() ? WhyUnjudged(record) : "the oracle is undecided at every row";
    }
}

}  // namespace

Verdict VerdictOf(const EvaluationFailure& failure) {
    using Kind = EvaluationFailure::Kind;
    switch (failure.kind) {
        case Kind::kUnsupported:
            return Verdict::kSkip;
        case Kind::kInput:
        case Kind::kRejected:
        case Kind::kStopped:
            return Verdict::kFail;
        case Kind::kCrash:
            return Verdict::kCrash;
        case Kind::kTimeout:
            return Verdict::kTimeout;
    }
    return Verdict::kFail;
}

Record RunCase(const PreparedCase& prepared, Runner& runner, const Recipe& recipe,
               Evaluations& evaluations, const RepeatContext& context) {
    const auto start = std::chrono::steady_clock::now();
    Record record;
    record.case_path = prepared.source.path;
    record.device = runner.info().name;
    record.recipe = RecipeText(recipe);
    record.family = prepared.source.family;
    record.covers = prepared.source.covers;
    record.seed = prepared.source.seed;
    record.rows = prepared.table.rows;
    record.all_rows = prepared.all_rows;
    Collector collector(prepared, record);
    const Bench bench = {runner, recipe, evaluations, collector, record};
    bool complete = true;
    if (!prepared.judged.empty()) {
        complete = JudgeOutputs(prepared, bench);
    }
    for (const PreparedLaw& law : prepared.laws) {
        complete = complete && JudgeLawRows(prepared, law, bench);
    }
    if (complete) {
        SetVerdict(record);
    }
    ApplyExpectations(prepared.source, prepared.extent, collector.things(), record);
    record.repeat = RepeatCommand(record, context);
    record.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return record;
}

}  // namespace etalon
