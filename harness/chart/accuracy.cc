#include "chart/accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "judge/judge.h"
#include "numeric/tally.h"
#include "run/observe.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

double InMeasure(const Judgement& judgement, double truth, ErrorMeasure measure) {
    switch (measure) {
        case ErrorMeasure::kAbsolute:
            return judgement.error;
        case ErrorMeasure::kRelative:
            return judgement.error == 0 || std::isinf(judgement.error)
                       ? judgement.error
                       : judgement.error / std::fabs(truth);
        case ErrorMeasure::kUlp:
            return judgement.ulp_error;
    }
    return kNan;
}

bool IsUndecided(const Truth& truth, std::uint64_t row) {
    return std::isnan(truth.values[row]) || truth.errors[row] == kInfinity;
}

class Measurer {
  public:
    Measurer(const PreparedCase& prepared, const Gathered& results, ErrorMeasure measure)
        : prepared_(prepared), results_(results), measure_(measure) {}

    Errors Measure() {
        errors_.rows = prepared_.table.rows;
        const Acceptance& accept = prepared_.judged.front().accept;
        const bool is_search = accept.shares && accept.shares->beyond;
        for (std::uint64_t row = 0; row < errors_.rows; ++row) {
            if (is_search) {
                AddHit(row);
            } else {
                AddRow(row);
            }
        }
        if (is_search) {
            errors_.shares_held =
                ShareOf(errors_.missed, errors_.hits) <= accept.shares->missed &&
                ShareOf(errors_.wrong, errors_.rows - errors_.undecided) <= accept.shares->wrong;
        }
        return std::move(errors_);
    }

    static double ShareOf(std::uint64_t part, std::uint64_t whole) {
        return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
    }

  private:
    Judgement JudgementOf(const JudgedColumn& column, std::uint64_t row) const {
        return JudgeValue(column.accept, column.scalar, results_.Column(column.column)[row],
                          column.truth, row);
    }

    void Show(const JudgedColumn& column, std::uint64_t row) {
        errors_.shown = ObserveOutput(column, results_.Column(column.column)[row], row);
        errors_.shown->inputs = InputsAt(prepared_.table, row);
    }

    // `column` is that of the greatest error.
    void Keep(double error, double absolute, const JudgedColumn& column, std::uint64_t row) {
        errors_.of_rows.push_back(error);
        errors_.worst_absolute = std::max(errors_.worst_absolute, absolute);
        if (!errors_.shown || (!errors_.is_shown_off && error > errors_.worst)) {
            Show(column, row);
        }
        errors_.worst = std::max(errors_.worst, error);
    }

    void AddRow(std::uint64_t row) {
        const JudgedColumn* worst_column = nullptr;
        double worst = 0;
        double worst_absolute = 0;
        bool is_finite = true;
        for (const JudgedColumn& column : prepared_.judged) {
            if (IsUndecided(column.truth, row)) {
                continue;
            }
            const double truth = column.truth.values[row];
            const double value = WordValue(column.scalar, results_.Column(column.column)[row]);
            const Judgement judgement = JudgementOf(column, row);
            const double error = InMeasure(judgement, truth, measure_);
            if (worst_column == nullptr || error > worst) {
                worst_column = &column;
                worst = error;
            }
            worst_absolute = std::max(worst_absolute, judgement.error);
            is_finite = is_finite && (std::isfinite(value) || !std::isfinite(truth));
            errors_.refused += judgement.accepted ? 0 : 1;
            if (std::isfinite(truth)) {
                errors_.greatest_truth = std::max(errors_.greatest_truth, std::fabs(truth));
            }
        }
        if (worst_column == nullptr) {
            ++errors_.undecided;
            return;
        }
        errors_.not_finite += is_finite ? 0 : 1;
        Keep(worst, worst_absolute, *worst_column, row);
    }

    void AddHit(std::uint64_t row) {
        const JudgedColumn& column = prepared_.judged.front();
        if (IsUndecided(column.truth, row)) {
            ++errors_.undecided;
            return;
        }
        const double truth = column.truth.values[row];
        const double value = WordValue(column.scalar, results_.Column(column.column)[row]);
        errors_.not_finite += std::isfinite(value) ? 0 : 1;
        errors_.hits += truth >= 0 ? 1 : 0;
        const Judgement judgement = JudgementOf(column, row);
        switch (judgement.outcome) {
            case Outcome::kNone:
            case Outcome::kUndecided:
                return;
            case Outcome::kRight:
                errors_.greatest_truth = std::max(errors_.greatest_truth, truth);
                Keep(InMeasure(judgement, truth, measure_), judgement.error, column, row);
                return;
            case Outcome::kMissed:
                ShowOff(column, row, errors_.missed == 0 && errors_.wrong == 0);
                ++errors_.missed;
                return;
            case Outcome::kPhantom:
            case Outcome::kOther:
                ShowOff(column, row, errors_.wrong == 0);
                ++errors_.wrong;
                return;
        }
    }

    void ShowOff(const JudgedColumn& column, std::uint64_t row, bool is_first) {
        if (is_first) {
            Show(column, row);
            errors_.is_shown_off = true;
        }
    }

    const PreparedCase& prepared_;
    const Gathered& results_;
    ErrorMeasure measure_;
    Errors errors_;
};

// The least of the values that so large a share of them does not exceed.
double Percentile(std::vector<double>& values, double share) {
    const auto count = static_cast<double>(values.size());
    const auto index = static_cast<std::ptrdiff_t>(std::ceil(share * count)) - 1;
    const auto at = values.begin() + std::max<std::ptrdiff_t>(index, 0);
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

void Errors::Add(const Errors& other) {
    const bool is_worse = other.shown && (!shown || (other.is_shown_off && !is_shown_off) ||
                                          (other.is_shown_off && other.wrong > 0 && wrong == 0) ||
                                          (!is_shown_off && other.worst > worst));
    if (is_worse) {
        shown = other.shown;
        shown_scene = other.shown_scene;
        is_shown_off = other.is_shown_off;
    }
    rows += other.rows;
    undecided += other.undecided;
    not_finite += other.not_finite;
    refused += other.refused;
    hits += other.hits;
    missed += other.missed;
    wrong += other.wrong;
    shares_held = shares_held && other.shares_held;
    of_rows.insert(of_rows.end(), other.of_rows.begin(), other.of_rows.end());
    worst_absolute = std::max(worst_absolute, other.worst_absolute);
    greatest_truth = std::max(greatest_truth, other.greatest_truth);
    worst = std::max(worst, other.worst);
}

Errors ErrorsOf(const PreparedCase& prepared, const Gathered& results, ErrorMeasure measure) {
    return Measurer(prepared, results, measure).Measure();
}

ChartAccuracy AccuracyOf(Errors& errors) {
    ChartAccuracy accuracy;
    accuracy.rows = errors.rows;
    accuracy.judged = errors.rows - errors.undecided;
    accuracy.undecided = errors.undecided;
    accuracy.not_finite = errors.not_finite;
    accuracy.refused = errors.refused;
    accuracy.missed = Measurer::ShareOf(errors.missed, errors.hits);
    accuracy.wrong = Measurer::ShareOf(errors.wrong, accuracy.judged);
    accuracy.shown = errors.shown;
    if (errors.of_rows.empty()) {
        accuracy.worst = accuracy.p999 = accuracy.rms = accuracy.bits = kNan;
        return accuracy;
    }
    accuracy.worst = errors.worst;
    double squares = 0;
    for (const double error : errors.of_rows) {
        squares += error * error;
    }
    accuracy.rms = std::sqrt(squares / static_cast<double>(errors.of_rows.size()));
    accuracy.p999 = Percentile(errors.of_rows, 0.999);
    accuracy.bits = errors.worst_absolute == 0
                        ? kInfinity
                        : -std::log2(errors.worst_absolute / errors.greatest_truth);
    return accuracy;
}

}  // namespace etalon
