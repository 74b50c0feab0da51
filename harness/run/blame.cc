#include "run/blame.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "judge/judge.h"
#include "numeric/ulp.h"
#include "run/observe.h"

namespace etalon {
namespace {

// The rows of the greatest values, few enough to be looked at again at more precision.
class Leaders {
  public:
    void Add(std::uint64_t row, double value) {
        if (!(value > values_.back())) {
            return;
        }
        const auto place = std::upper_bound(values_.begin(), values_.end(), value, std::greater());
        const auto index = place - values_.begin();
        std::move_backward(place, values_.end() - 1, values_.end());
        std::move_backward(rows_.begin() + index, rows_.end() - 1, rows_.end());
        values_[static_cast<std::size_t>(index)] = value;
        rows_[static_cast<std::size_t>(index)] = row;
    }
    template <typename F>
    void Each(F&& f) const {
        for (std::size_t i = 0; i < values_.size() && values_[i] > 0; ++i) {
            f(rows_[i]);
        }
    }

  private:
    std::array<double, 4> values_{};
    std::array<std::uint64_t, 4> rows_{};
};

struct NamedPart {
    const char* name;
    Part Parts::*part;
};
constexpr NamedPart kParts[] = {
    {"method", &Parts::method}, {"rounding", &Parts::rounding}, {"driver", &Parts::driver}};

PartSeen SeenOf(const Part& part) {
    return {part.absolute, part.ulp};
}

Budget BudgetOf(const Parts& parts, bool has_truth) {
    Budget budget;
    if (has_truth) {
        budget.method = SeenOf(parts.method);
    }
    budget.rounding = SeenOf(parts.rounding);
    budget.driver = SeenOf(parts.driver);
    return budget;
}

}  // namespace

Blame::Blame(Evaluation& evaluation, const Table& table, const evaluate::Profile& profile,
             Record& record)
    : evaluation_(evaluation), table_(table), record_(record) {
    record.profile = profile.name;
    const Result<Evaluation::Values>& values = evaluation.Get();
    if (!values) {
        record.unevaluated = values.error().message;
        return;
    }
    const Result<Evaluation::Bounds>& bounds = evaluation.BoundsBy(profile);
    if (!bounds) {
        record.unevaluated = bounds.error().message;
        return;
    }
    values_ = &*values;
    bounds_ = &*bounds;
}

Readings Blame::ReadingsAt(const JudgedColumn& column, std::uint32_t word,
                           std::uint64_t row) const {
    const std::size_t index = IndexOf(column.column, row);
    Readings readings;
    if (column.HasTruth()) {
        readings.truth = column.truth.values[row];
        readings.truth_error = column.truth.errors[row];
    }
    readings.method = values_->method.At(index, column.scalar);
    readings.strict = WordValue(column.scalar, values_->strict[index]);
    readings.device = WordValue(column.scalar, word);
    return readings;
}

Parts Blame::ExactParts(const JudgedColumn& column, std::uint32_t word, std::uint64_t row) {
    Readings readings = ReadingsAt(column, word, row);
    readings.method = evaluation_.MethodAt(row, column.column, column.scalar);
    return PartsOf(column.scalar, readings, column.accept.flush);
}

void Blame::Count(Culprit culprit, std::uint64_t values) {
    if (values == 0) {
        return;
    }
    const std::string name(CulpritName(culprit));
    const auto known = std::find_if(record_.culprits.begin(), record_.culprits.end(),
                                    [&](const auto& one) { return one.first == name; });
    if (known == record_.culprits.end()) {
        record_.culprits.emplace_back(name, values);
    } else {
        known->second += values;
    }
}

void Blame::Hold(const std::string& what, const JudgedColumn& column,
                 std::span<const std::uint32_t> words) {
    std::uint64_t outside = 0;
    std::uint64_t worst = 0;
    double worst_excess = 0;
    double worst_error = 0;
    for (std::uint64_t row = 0; row < table_.rows; ++row) {
        const Allowed& allowed = AllowedAt(column.column, row);
        const double excess = Excess(allowed, words[row]);
        record_.unbounded += allowed.kind == Allowed::Kind::kUnbounded ? 1 : 0;
        record_.void_bounds += bounds_->is_void[IndexOf(column.column, row)] ? 1 : 0;
        if (excess == 0) {
            continue;
        }
        ++outside;
        // The ends are floats, so that many lie as far outside.
        const double method = values_->method.At(IndexOf(column.column, row), column.scalar);
        const double error = std::fabs(WordValue(column.scalar, words[row]) - method) / Ulp(method);
        if (excess > worst_excess || (excess == worst_excess && error > worst_error)) {
            worst_excess = excess;
            worst_error = error;
            worst = row;
        }
    }
    record_.held += table_.rows;
    if (outside == 0) {
        return;
    }
    record_.outside += outside;
    if (std::find(record_.outside_in.begin(), record_.outside_in.end(), what) ==
        record_.outside_in.end()) {
        record_.outside_in.push_back(what);
    }
    if (record_.worst_outside && record_.worst_outside->allowed->excess >= worst_excess) {
        return;
    }
    Observation observation = ObserveAllowed(column, AllowedAt(column.column, worst),
                                             record_.profile, words[worst], worst);
    observation.inputs = InputsAt(table_, worst);
    observation.budget = BudgetOf(ExactParts(column, words[worst], worst), column.HasTruth());
    observation.budget->culprit = CulpritName(Culprit::kDriver);
    record_.worst_outside = std::move(observation);
}

void Blame::AddParts(const JudgedColumn& column, std::span<const std::uint32_t> words,
                     bool blames) {
    std::array<Leaders, std::size(kParts)> leaders;
    auto other = column.truth.alternatives.begin();
    for (std::uint64_t row = 0; row < table_.rows; ++row) {
        const Readings readings = ReadingsAt(column, words[row], row);
        const Parts parts = PartsOf(column.scalar, readings, column.accept.flush);
        const bool is_refused =
            blames &&
            !JudgeValue(column.accept, column.scalar, words[row], column.truth, row).accepted;
        if (is_refused) {
            const Allowed& allowed = AllowedAt(column.column, row);
            Count(CulpritOf(parts, allowed, Excess(allowed, words[row])));
        }
        // A device may have taken subnormal inputs as zero: the parts would be those of other
        // inputs. Where the truth is undecided there is none to be off.
        const bool is_other = other != column.truth.alternatives.end() && other->row == row;
        other += is_other ? 1 : 0;
        const bool is_undecided = column.accept.shares && std::isnan(readings.truth.value_or(0));
        if (is_undecided || (is_other && !is_refused)) {
            continue;
        }
        for (std::size_t i = 0; i < std::size(kParts); ++i) {
            leaders[i].Add(row, (parts.*kParts[i].part).ulp);
        }
    }
    for (std::size_t i = 0; i < std::size(kParts); ++i) {
        std::optional<std::pair<std::uint64_t, Part>> worst;
        leaders[i].Each([&](std::uint64_t row) {
            const Part part = ExactParts(column, words[row], row).*kParts[i].part;
            if (!worst || part.ulp > worst->second.ulp) {
                worst = {row, part};
            }
        });
        if (worst) {
            AddWorstPart({kParts[i].name, column.name, {}, SeenOf(worst->second)}, worst->first);
        }
    }
}

void Blame::AddWorstPart(WorstPart worst, std::uint64_t row) {
    const auto known = std::find_if(record_.parts.begin(), record_.parts.end(),
                                    [&](const WorstPart& one) { return one.part == worst.part; });
    if (known != record_.parts.end() && known->seen.ulp >= worst.seen.ulp) {
        return;
    }
    worst.inputs = InputsAt(table_, row);
    if (known != record_.parts.end()) {
        *known = std::move(worst);
    } else {
        record_.parts.push_back(std::move(worst));
    }
}

void Blame::AddColumn(const JudgedColumn& column, std::span<const std::uint32_t> words,
                      std::uint64_t refused) {
    if (!IsKnown()) {
        return;
    }
    Hold(column.name, column, words);
    AddParts(column, words, refused > 0 && !column.IsBySpec());
    if (column.IsBySpec()) {
        Count(Culprit::kDriver, refused);
    }
}

void Blame::AddLaw(const PreparedLaw& law, std::size_t pair, std::span<const std::uint32_t> left,
                   std::span<const std::uint32_t> right, std::uint64_t refused) {
    if (!IsKnown()) {
        return;
    }
    const auto [left_column, right_column] = law.pairs[pair];
    const std::string what = LawLabel(law.law);
    JudgedColumn side;
    side.scalar = law.scalars[pair];
    side.name = what + ", left side";
    side.column = left_column;
    Hold(what, side, left);
    side.name = what + ", right side";
    side.column = right_column;
    Hold(what, side, right);
    for (std::uint64_t row = 0; refused > 0 && row < table_.rows; ++row) {
        if (JudgeLaw(law.law, side.scalar, left[row], right[row]).accepted) {
            continue;
        }
        const Evaluation::Method& method = values_->method;
        Count(LawCulprit(law, pair, left[row], right[row], row,
                         {method.At(IndexOf(left_column, row), side.scalar),
                          method.At(IndexOf(right_column, row), side.scalar)}));
    }
}

Culprit Blame::LawCulprit(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                          std::uint32_t right, std::uint64_t row,
                          const Sides<double>& method) const {
    const auto [left_column, right_column] = law.pairs[pair];
    return CulpritOfLaw(
        law.law, law.scalars[pair], method,
        {values_->strict[IndexOf(left_column, row)], values_->strict[IndexOf(right_column, row)]},
        {left, right}, {AllowedAt(left_column, row), AllowedAt(right_column, row)});
}

void Blame::Explain(const JudgedColumn& column, std::uint32_t word, std::uint64_t row,
                    bool is_refused, Observation& observation) {
    if (!IsKnown()) {
        return;
    }
    const Allowed& allowed = AllowedAt(column.column, row);
    const Parts parts = ExactParts(column, word, row);
    observation.budget = BudgetOf(parts, column.HasTruth());
    if (!observation.allowed) {
        observation.allowed = AllowedValueOf(allowed, column.scalar, word);
    }
    if (is_refused) {
        // Beyond the very bound that it is judged by, no method or rounding is to blame.
        const Culprit culprit =
            column.IsBySpec() ? Culprit::kDriver : CulpritOf(parts, allowed, Excess(allowed, word));
        observation.budget->culprit = CulpritName(culprit);
    }
}

void Blame::ExplainLaw(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                       std::uint32_t right, std::uint64_t row, bool is_refused,
                       Observation& observation) {
    if (!IsKnown()) {
        return;
    }
    const auto [left_column, right_column] = law.pairs[pair];
    const Scalar scalar = law.scalars[pair];
    const Sides<double> method = {evaluation_.MethodAt(row, left_column, scalar),
                                  evaluation_.MethodAt(row, right_column, scalar)};
    const auto seen = [](const Judgement& judgement) -> PartSeen {
        return judgement.accepted ? PartSeen{} : PartSeen{judgement.error, judgement.ulp_error};
    };
    Budget budget;
    budget.is_law = true;
    budget.method = seen(JudgeLawByMethod(law.law, scalar, method));
    budget.rounding = seen(JudgeLaw(law.law, scalar, values_->strict[IndexOf(left_column, row)],
                                    values_->strict[IndexOf(right_column, row)]));
    budget.driver = seen(JudgeLaw(law.law, scalar, left, right));
    if (is_refused) {
        budget.culprit = CulpritName(LawCulprit(law, pair, left, right, row, method));
    }
    observation.budget = std::move(budget);
    observation.allowed = AllowedValueOf(AllowedAt(left_column, row), scalar, left);
}

}  // namespace etalon
