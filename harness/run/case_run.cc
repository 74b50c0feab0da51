#include "run/case_run.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "base/check.h"
#include "base/file.h"
#include "run/expected_failure.h"

namespace etalon {
namespace {

Value ValueOf(Scalar scalar, std::uint32_t word) {
    const std::string decimal = WordText(scalar, word);
    return {decimal, scalar == Scalar::kFloat ? HexFloat(std::bit_cast<float>(word)) : decimal};
}

std::vector<std::pair<std::string, Value>> InputsAt(const Table& table, std::uint64_t row) {
    std::vector<std::pair<std::string, Value>> inputs;
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const Scalar scalar = table.columns[c].scalar;
        const std::uint32_t word = table.At(row, c);
        const bool is_nan = scalar == Scalar::kFloat && std::isnan(std::bit_cast<float>(word));
        const std::string exact = ExactText(scalar, word);
        inputs.emplace_back(table.columns[c].name,
                            is_nan ? Value{exact, exact} : ValueOf(scalar, word));
    }
    return inputs;
}

// The results of one evaluation, by columns over all rows.
class Gathered {
  public:
    Gathered(std::uint64_t rows, std::size_t columns) : rows_(rows), words_(rows * columns) {}

    void Take(std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
        const std::size_t columns = words_.size() / rows_;
        for (std::size_t c = 0; c < columns; ++c) {
            const auto from = words.subspan(c * rows, rows);
            std::copy(from.begin(), from.end(),
                      words_.begin() + static_cast<std::ptrdiff_t>(c * rows_ + first));
        }
    }
    std::span<const std::uint32_t> Column(std::size_t column) const {
        return std::span(words_).subspan(column * rows_, rows_);
    }

  private:
    std::uint64_t rows_;
    std::vector<std::uint32_t> words_;
};

// Collects what the judges say of one output or law into the record.
class Collector {
  public:
    Collector(const PreparedCase& prepared, Record& record)
        : prepared_(prepared), record_(record) {}

    // `observe(row)` makes the observation of a row; it is asked only for the worst one.
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
            thing.worst = observe(row);
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

void SetFailure(const EvaluationFailure& failure, Record& record) {
    using Kind = EvaluationFailure::Kind;
    record.reason = failure.reason;
    switch (failure.kind) {
        case Kind::kUnsupported:
            record.verdict = Verdict::kSkip;
            return;
        case Kind::kInput:
        case Kind::kRejected:
            record.verdict = Verdict::kFail;
            return;
        case Kind::kCrash:
            record.verdict = Verdict::kCrash;
            return;
        case Kind::kTimeout:
            record.verdict = Verdict::kTimeout;
            return;
    }
}

Rows RowsOfTable(const Table& table) {
    return {table.words, table.rows, table.columns.size()};
}

Observation ObserveOutput(const JudgedColumn& column, std::uint32_t word, std::uint64_t row) {
    const Judgement judgement = JudgeValue(column.accept, column.scalar, word, column.truth, row);
    Observation observation;
    observation.output = column.name;
    const bool tells = column.scalar == Scalar::kFloat || column.accept.shares;
    observation.rule = tells ? column.accept.Text() : "equal";
    observation.actual = ValueOf(column.scalar, word);
    const double truth = column.truth.values[row];
    observation.expected = {Shortest(truth), HexFloat(truth)};
    observation.error = judgement.error;
    observation.ulp_error = judgement.ulp_error;
    observation.used = judgement.used;
    return observation;
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

std::string LawLabel(const Law& law) {
    return "law '" + law.name + "'";
}

std::string RelationText(const Law& law) {
    switch (law.relation) {
        case Relation::kEqual:
            return "==";
        case Relation::kLessEqual:
            return "<=";
        case Relation::kGreaterEqual:
            return ">=";
        case Relation::kLess:
            return "<";
        case Relation::kGreater:
            return ">";
    }
    return "";
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
        SetFailure(evaluated.error(), record);
        return std::nullopt;
    }
    return results;
}

// The call's outputs against their oracles. False where there was no result to judge.
bool JudgeOutputs(const PreparedCase& prepared, Runner& runner, const Recipe& recipe,
                  Collector& collector, Record& record) {
    const std::optional<Gathered> results =
        Evaluate(prepared.call, prepared.signature, prepared.table, runner, recipe, record);
    if (!results) {
        return false;
    }
    for (const JudgedColumn& column : prepared.judged) {
        const std::span<const std::uint32_t> words = results->Column(column.column);
        Summary summary;
        if (column.accept.shares) {
            Tally tally;
            TallyColumn(column.accept, column.scalar, words, column.truth, 0, tally);
            summary = tally.Settle(*column.accept.shares);
            record.shares.push_back(CountOf(column, tally));
        } else {
            JudgeColumn(column.accept, column.scalar, words, column.truth, 0, summary);
        }
        collector.Add(column.name, summary,
                      [&](std::uint64_t row) { return ObserveOutput(column, words[row], row); });
    }
    return true;
}

bool JudgeLawRows(const PreparedCase& prepared, const PreparedLaw& law, Runner& runner,
                  const Recipe& recipe, Collector& collector, Record& record) {
    const std::optional<Gathered> results =
        Evaluate(law.call, law.signature, prepared.table, runner, recipe, record);
    if (!results) {
        return false;
    }
    for (std::size_t i = 0; i < law.pairs.size(); ++i) {
        const std::span<const std::uint32_t> left = results->Column(law.pairs[i].first);
        const std::span<const std::uint32_t> right = results->Column(law.pairs[i].second);
        Summary summary;
        for (std::uint64_t row = 0; row < prepared.table.rows; ++row) {
            summary.Add(row, JudgeLaw(law.law, law.scalars[i], left[row], right[row]));
        }
        collector.Add(LawLabel(law.law), summary, [&](std::uint64_t row) {
            const Judgement judgement = JudgeLaw(law.law, law.scalars[i], left[row], right[row]);
            Observation observation;
            observation.output = LawLabel(law.law) + ", left side";
            observation.rule = law.law.left + " " + RelationText(law.law) + " " + law.law.right +
                               ", within " + law.law.within.Text();
            observation.actual = ValueOf(law.scalars[i], left[row]);
            observation.expected = ValueOf(law.scalars[i], right[row]);
            observation.error = judgement.error;
            observation.ulp_error = judgement.ulp_error;
            observation.used = judgement.used;
            return observation;
        });
    }
    return true;
}

std::string RepeatCommand(const Record& record, const RepeatContext& context) {
    std::string command = context.program + " run " + ShellWord(record.case_path) +
                          context.options + " --device " + ShellWord(record.device) + " --recipe " +
                          record.recipe;
    // A figure is of the whole case.
    const bool is_figure = std::any_of(record.figures.begin(), record.figures.end(),
                                       [](const FigureSeen& figure) { return !figure.agrees; });
    if (record.worst && !is_figure) {
        std::string at;
        for (const auto& [name, value] : record.worst->inputs) {
            at += (at.empty() ? "" : ",") + name + "=" + value.hex;
        }
        command += " --at " + ShellWord(at);
    }
    return command;
}

}  // namespace

Record RunCase(const PreparedCase& prepared, Runner& runner, const Recipe& recipe,
               const RepeatContext& context) {
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
    bool complete = true;
    if (!prepared.judged.empty()) {
        complete = JudgeOutputs(prepared, runner, recipe, collector, record);
    }
    for (const PreparedLaw& law : prepared.laws) {
        complete = complete && JudgeLawRows(prepared, law, runner, recipe, collector, record);
    }
    if (complete && record.judged == 0) {
        ETALON_CHECK(!record.shares.empty());
        record.verdict = Verdict::kSkip;
        record.reason = "the oracle is undecided at every row";
    } else if (complete) {
        record.verdict = record.refused == 0 ? Verdict::kPass : Verdict::kFail;
    }
    ApplyExpectations(prepared.source, prepared.extent, collector.things(), record);
    record.repeat = RepeatCommand(record, context);
    record.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return record;
}

}  // namespace etalon
