#include "map/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/ulp.h"
#include "run/observe.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

using Outputs = std::vector<std::vector<std::uint32_t>>;

Result<Outputs, EvaluationFailure> RunCall(const MapPlan& plan, const Call& call,
                                           const Signature& signature, Runner& runner,
                                           const Recipe& recipe) {
    const Table& table = plan.prepared.table;
    Outputs outputs(signature.OutputWords(call), std::vector<std::uint32_t>(table.rows));
    const auto evaluated = runner.Evaluate(
        call, signature, recipe, {table.words, table.rows, table.columns.size()},
        [&](std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
            for (std::size_t c = 0; c < outputs.size(); ++c) {
                const auto from = words.subspan(c * rows, rows);
                std::copy(from.begin(), from.end(),
                          outputs[c].begin() + static_cast<std::ptrdiff_t>(first));
            }
        });
    if (!evaluated) {
        return evaluated.error();
    }
    return outputs;
}

const Acceptance& FirstRule(const MapPlan& plan) {
    return plan.prepared.judged.empty() ? plan.prepared.laws.front().law.within
                                        : plan.prepared.judged.front().accept;
}

bool IsUndecided(const JudgedColumn& column, std::uint64_t cell) {
    const double truth = column.truth.values[cell];
    return (std::isnan(truth) && column.accept.shares) || !std::isfinite(column.truth.errors[cell]);
}

// Worse is greater.
int RankOf(MapMark mark) {
    constexpr MapMark kOrder[] = {MapMark::kHolds,    MapMark::kUndecided, MapMark::kRefused,
                                  MapMark::kWrong,    MapMark::kMissed,    MapMark::kSpent,
                                  MapMark::kInfinity, MapMark::kNan,       MapMark::kCrash};
    return static_cast<int>(std::find(std::begin(kOrder), std::end(kOrder), mark) -
                            std::begin(kOrder));
}

class CellJudge {
  public:
    CellJudge(const MapPlan& plan, const MapResults& results, MappedDevice& device)
        : plan_(plan), results_(results), device_(device), measure_(MeasureOf(plan)) {}

    void Run() {
        const std::uint64_t cells = plan_.cells();
        device_.error.assign(cells, std::numeric_limits<double>::quiet_NaN());
        device_.mark.assign(cells, MapMark::kUndecided);
        for (std::uint64_t cell = 0; cell < cells; ++cell) {
            if (!plan_.left_out[cell]) {
                is_first_ = true;
                JudgeOutputs(cell);
                JudgeLaws(cell);
            }
        }
    }

  private:
    void JudgeOutputs(std::uint64_t cell) {
        for (const JudgedColumn& column : plan_.prepared.judged) {
            const std::uint32_t word = results_.outputs[column.column][cell];
            if (IsUndecided(column, cell)) {
                Add(cell, MapMark::kUndecided, std::numeric_limits<double>::quiet_NaN());
                continue;
            }
            const Judgement judgement =
                JudgeValue(column.accept, column.scalar, word, column.truth, cell);
            Add(cell, MarkOf(judgement, column.scalar, word, word, cell),
                ErrorOf(judgement, column.truth.values[cell]));
            Compare(judgement, cell, [&] { return ObserveOutput(column, word, cell); });
        }
    }

    void JudgeLaws(std::uint64_t cell) {
        for (std::size_t k = 0; k < plan_.prepared.laws.size(); ++k) {
            const PreparedLaw& law = plan_.prepared.laws[k];
            for (std::size_t pair = 0; pair < law.pairs.size(); ++pair) {
                const std::uint32_t left = results_.laws[k][law.pairs[pair].first][cell];
                const std::uint32_t right = results_.laws[k][law.pairs[pair].second][cell];
                const Scalar scalar = law.scalars[pair];
                const Judgement judgement = JudgeLaw(law.law, scalar, left, right);
                Add(cell, MarkOf(judgement, scalar, left, right, cell),
                    ErrorOf(judgement, WordValue(scalar, right)));
                Compare(judgement, cell, [&] { return ObserveLaw(law, pair, left, right); });
            }
        }
    }

    MapMark MarkOf(const Judgement& judgement, Scalar scalar, std::uint32_t word,
                   std::uint32_t other, std::uint64_t cell) const {
        if (judgement.accepted) {
            return MapMark::kHolds;
        }
        if (scalar == Scalar::kFloat) {
            if (std::isnan(FromBits(word)) || std::isnan(FromBits(other))) {
                return MapMark::kNan;
            }
            if (std::isinf(FromBits(word)) || std::isinf(FromBits(other))) {
                return MapMark::kInfinity;
            }
        }
        if (!results_.spent.empty() && results_.spent[cell] != 0) {
            return MapMark::kSpent;
        }
        switch (judgement.outcome) {
            case Outcome::kMissed:
                return MapMark::kMissed;
            case Outcome::kPhantom:
            case Outcome::kOther:
                return MapMark::kWrong;
            default:
                return MapMark::kRefused;
        }
    }

    double ErrorOf(const Judgement& judgement, double truth) const {
        if (measure_ == "ulp") {
            return judgement.ulp_error;
        }
        return measure_ == "absolute" || judgement.error == 0 ? judgement.error
                                                              : judgement.error / std::fabs(truth);
    }

    void Add(std::uint64_t cell, MapMark mark, double error) {
        if (is_first_ || RankOf(mark) > RankOf(device_.mark[cell])) {
            device_.mark[cell] = mark;
        }
        double& worst = device_.error[cell];
        if (is_first_ || std::isnan(worst) || error > worst) {
            worst = error;
        }
        is_first_ = false;
    }

    template <typename Observe>
    void Compare(const Judgement& judgement, std::uint64_t cell, const Observe& observe) {
        if (!device_.worst || judgement.used > device_.worst->used) {
            device_.worst = observe();
            device_.worst->used = judgement.used;
            device_.worst->inputs = InputsAt(plan_.prepared.table, cell);
        }
    }

    const MapPlan& plan_;
    const MapResults& results_;
    MappedDevice& device_;
    std::string measure_;
    bool is_first_ = true;  // of the cell's columns
};

double Distance(Scalar scalar, std::uint32_t a, std::uint32_t b) {
    if (scalar != Scalar::kFloat) {
        return a == b ? 0 : kInfinity;
    }
    const float left = FromBits(a);
    const float right = FromBits(b);
    return std::max(UlpError(left, right), UlpError(right, left));
}

}  // namespace

Result<MapResults, EvaluationFailure> RunCells(const MapPlan& plan, Runner& runner,
                                               const Recipe& recipe) {
    MapResults results;
    if (!plan.prepared.judged.empty()) {
        ETALON_TRY(outputs,
                   RunCall(plan, plan.prepared.call, plan.prepared.signature, runner, recipe));
        results.outputs = std::move(outputs);
    }
    for (const PreparedLaw& law : plan.prepared.laws) {
        ETALON_TRY(outputs, RunCall(plan, law.call, law.signature, runner, recipe));
        results.laws.push_back(std::move(outputs));
    }
    if (plan.spent) {
        ETALON_TRY(outputs, RunCall(plan, plan.spent->call, plan.spent->signature, runner, recipe));
        results.spent = std::move(outputs.front());
    }
    return results;
}

std::string MeasureOf(const MapPlan& plan) {
    const Acceptance& rule = FirstRule(plan);
    const bool is_search = rule.shares && rule.shares->beyond;
    return rule.ulp && !is_search            ? "ulp"
           : rule.relative && !rule.absolute ? "relative"
                                             : "absolute";
}

std::string ToleranceOf(const MapPlan& plan) {
    std::vector<std::string> rules;
    const auto add = [&](const std::string& rule) {
        if (std::find(rules.begin(), rules.end(), rule) == rules.end()) {
            rules.push_back(rule);
        }
    };
    for (const JudgedColumn& column : plan.prepared.judged) {
        add(column.scalar == Scalar::kFloat ? column.accept.Text() : "equal");
    }
    for (const PreparedLaw& law : plan.prepared.laws) {
        add(law.law.within.Text());
    }
    std::string text;
    for (const std::string& rule : rules) {
        text += (text.empty() ? "" : "; ") + rule;
    }
    return text;
}

std::string OutputOf(const MapPlan& plan) {
    std::string text;
    for (const JudgedColumn& column : plan.prepared.judged) {
        text += (text.empty() ? "" : ", ") + column.name;
    }
    for (const PreparedLaw& law : plan.prepared.laws) {
        text += (text.empty() ? "" : ", ") + LawLabel(law.law);
    }
    return text;
}

void JudgeCells(const MapPlan& plan, const MapResults& results, MappedDevice& device) {
    CellJudge(plan, results, device).Run();
}

std::vector<bool> UndecidedCells(const MapPlan& plan) {
    std::vector<bool> undecided = plan.left_out;
    for (const JudgedColumn& column : plan.prepared.judged) {
        for (std::uint64_t cell = 0; cell < plan.cells(); ++cell) {
            undecided[cell] = undecided[cell] || IsUndecided(column, cell);
        }
    }
    return undecided;
}

std::vector<double> Disagreement(const MapPlan& plan, const std::vector<const MapResults*>& all) {
    std::vector<double> greatest(plan.cells(), 0);
    const auto compare = [&](Scalar scalar, const auto& column_of) {
        for (std::size_t a = 0; a < all.size(); ++a) {
            for (std::size_t b = a + 1; b < all.size(); ++b) {
                const std::vector<std::uint32_t>& left = column_of(*all[a]);
                const std::vector<std::uint32_t>& right = column_of(*all[b]);
                for (std::uint64_t cell = 0; cell < plan.cells(); ++cell) {
                    greatest[cell] =
                        std::max(greatest[cell], Distance(scalar, left[cell], right[cell]));
                }
            }
        }
    };
    for (const JudgedColumn& column : plan.prepared.judged) {
        compare(column.scalar, [&](const MapResults& results) -> const std::vector<std::uint32_t>& {
            return results.outputs[column.column];
        });
    }
    for (std::size_t k = 0; k < plan.prepared.laws.size(); ++k) {
        const PreparedLaw& law = plan.prepared.laws[k];
        for (std::size_t pair = 0; pair < law.pairs.size(); ++pair) {
            for (const std::size_t column : {law.pairs[pair].first, law.pairs[pair].second}) {
                compare(law.scalars[pair],
                        [&](const MapResults& results) -> const std::vector<std::uint32_t>& {
                            return results.laws[k][column];
                        });
            }
        }
    }
    return greatest;
}

}  // namespace etalon
