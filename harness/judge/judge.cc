#include "judge/judge.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace etalon {
namespace {

Judgement JudgeExact(double value, double truth) {
    Judgement judgement;
    judgement.accepted = value == truth;
    if (!judgement.accepted) {
        judgement.error = std::fabs(value - truth);
        judgement.ulp_error = std::numeric_limits<double>::infinity();
        judgement.used = std::numeric_limits<double>::infinity();
    }
    return judgement;
}

Judgement Better(const Judgement& a, const Judgement& b) {
    if (a.accepted != b.accepted) {
        return a.accepted ? a : b;
    }
    return b.used < a.used ? b : a;
}

std::vector<Truth::Alternative>::const_iterator AlternativeFrom(const Truth& truth,
                                                                std::uint64_t row) {
    return std::lower_bound(
        truth.alternatives.begin(), truth.alternatives.end(), row,
        [](const Truth::Alternative& one, std::uint64_t wanted) { return one.row < wanted; });
}

Judgement JudgeAgainst(const Acceptance& rule, Scalar scalar, std::uint32_t word, double truth,
                       double error) {
    if (scalar != Scalar::kFloat) {
        const double value = WordValue(scalar, word);
        return rule.shares ? JudgeSharedExact(value, truth) : JudgeExact(value, truth);
    }
    const auto value = std::bit_cast<float>(word);
    return rule.shares ? JudgeShared(rule, value, truth, error) : Judge(rule, value, truth, error);
}

}  // namespace

Judgement JudgeValue(const Acceptance& rule, Scalar scalar, std::uint32_t word, const Truth& truth,
                     std::uint64_t row) {
    const Judgement judgement =
        JudgeAgainst(rule, scalar, word, truth.values[row], truth.errors[row]);
    const auto other = AlternativeFrom(truth, row);
    if (!rule.flush || other == truth.alternatives.end() || other->row != row) {
        return judgement;
    }
    return Better(judgement, JudgeAgainst(rule, scalar, word, other->value, other->error));
}

void JudgeColumn(const Acceptance& rule, Scalar scalar, std::span<const std::uint32_t> words,
                 const Truth& truth, std::uint64_t first_row, Summary& summary,
                 UlpHistogram* histogram) {
    ETALON_CHECK(!rule.shares);
    const auto judge_one = [&](std::size_t i) {
        const Judgement judgement = JudgeValue(rule, scalar, words[i], truth, first_row + i);
        summary.Add(first_row + i, judgement);
        if (histogram != nullptr) {
            histogram->Add(judgement.ulp_error);
        }
    };
    if (scalar != Scalar::kFloat) {
        for (std::size_t i = 0; i < words.size(); ++i) {
            judge_one(i);
        }
        return;
    }
    // Runs of plain rows go through the fast door; rows with an alternative one by one.
    auto other = AlternativeFrom(truth, first_row);
    std::vector<float> values(words.size());
    std::transform(words.begin(), words.end(), values.begin(),
                   [](std::uint32_t word) { return std::bit_cast<float>(word); });
    std::size_t at = 0;
    while (at < words.size()) {
        std::size_t end = words.size();
        if (rule.flush && other != truth.alternatives.end()) {
            end = std::min<std::size_t>(end, other->row - first_row);
        }
        if (end > at) {
            const std::size_t row = first_row + at;
            JudgeAll(rule, std::span(values).subspan(at, end - at),
                     std::span(truth.values).subspan(row, end - at),
                     std::span(truth.errors).subspan(row, end - at), row, summary, histogram);
            at = end;
        } else {
            judge_one(at);
            ++at;
            ++other;
        }
    }
}

void TallyColumn(const Acceptance& rule, Scalar scalar, std::span<const std::uint32_t> words,
                 const Truth& truth, std::uint64_t first_row, Tally& tally) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        tally.Add(first_row + i, JudgeValue(rule, scalar, words[i], truth, first_row + i));
    }
}

bool Holds(Relation relation, double left, double right) {
    switch (relation) {
        case Relation::kEqual:
            return left == right;
        case Relation::kLessEqual:
            return left <= right;
        case Relation::kGreaterEqual:
            return left >= right;
        case Relation::kLess:
            return left < right;
        case Relation::kGreater:
            return left > right;
    }
    return false;
}

Judgement JudgeLaw(const Law& law, Scalar scalar, std::uint32_t left, std::uint32_t right) {
    const double a = WordValue(scalar, left);
    const double b = WordValue(scalar, right);
    if (std::isnan(a) || std::isnan(b)) {
        Judgement broken;
        broken.error = broken.ulp_error = broken.used = std::numeric_limits<double>::infinity();
        return broken;
    }
    if (Holds(law.relation, a, b)) {
        return Judgement{.accepted = true};
    }
    if (scalar != Scalar::kFloat) {
        Judgement broken = JudgeExact(a, b);
        broken.accepted = false;
        broken.used = std::numeric_limits<double>::infinity();
        return broken;
    }
    Judgement judgement = Judge(law.within, static_cast<float>(a), b, 0);
    if (law.relation == Relation::kLess || law.relation == Relation::kGreater) {
        // Equal sides break a strict law unless a tolerance was granted.
        judgement.accepted = judgement.accepted && Tolerance(law.within, b) > 0;
        if (!judgement.accepted && judgement.used <= 1) {
            judgement.used = std::numeric_limits<double>::infinity();
        }
    }
    return judgement;
}

}  // namespace etalon
