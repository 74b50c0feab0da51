#include "numeric/tally.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Judgement Off(Outcome outcome) {
    return {false, kInfinity, kInfinity, kInfinity, outcome};
}

Judgement As(Outcome outcome) {
    return {.accepted = true, .outcome = outcome};
}

double ShareOf(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Judgement JudgeShared(const Acceptance& rule, float value, double truth, double truth_error) {
    ETALON_CHECK(rule.shares.has_value());
    const double result = value;
    if (std::isnan(truth)) {
        return As(Outcome::kUndecided);
    }
    const std::optional<double> beyond = rule.shares->beyond;
    if (beyond && truth < 0) {
        return result < 0 ? As(Outcome::kNone) : Off(Outcome::kPhantom);
    }
    if (beyond && result < 0) {
        return Off(Outcome::kMissed);
    }
    Judgement judgement = Judge(rule, value, truth, truth_error);
    const bool other =
        std::isnan(result) ||
        (beyond ? std::fabs(result - truth) > *beyond + truth_error : !judgement.accepted);
    if (other) {
        judgement.accepted = false;
        judgement.used = kInfinity;
        judgement.outcome = Outcome::kOther;
    }
    return judgement;
}

Judgement JudgeSharedExact(double value, double truth) {
    if (std::isnan(truth)) {
        return As(Outcome::kUndecided);
    }
    Judgement judgement = value == truth ? As(Outcome::kRight) : Off(Outcome::kOther);
    judgement.error = std::fabs(value - truth);
    return judgement;
}

void Tally::Add(std::uint64_t index, const Judgement& judgement) {
    if (judgement.outcome == Outcome::kUndecided) {
        ++undecided;
        return;
    }
    ++decided;
    switch (judgement.outcome) {
        case Outcome::kUndecided:
        case Outcome::kNone:
            right.Add(index, judgement);
            return;
        case Outcome::kRight:
            ++hits;
            right.Add(index, judgement);
            worst_right_error = std::max(worst_right_error, judgement.error);
            return;
        case Outcome::kMissed:
            ++hits;
            ++missed;
            first_missed = std::min(first_missed, index);
            return;
        case Outcome::kOther:
            ++hits;
            break;
        case Outcome::kPhantom:
            break;
    }
    ++wrong;
    first_wrong = std::min(first_wrong, index);
    if (worst_wrong_at == kNone || judgement.error > worst_wrong_error ||
        (judgement.error == worst_wrong_error && index < worst_wrong_at)) {
        worst_wrong_error = judgement.error;
        worst_wrong_at = index;
    }
}

double Tally::MissedShare() const {
    return ShareOf(missed, hits);
}

double Tally::WrongShare() const {
    return ShareOf(wrong, decided);
}

Summary Tally::Settle(const Shares& shares) const {
    Summary summary = right;
    summary.judged = decided;
    const auto weigh = [&summary](double share, double allowed, std::uint64_t count,
                                  std::uint64_t first, std::uint64_t example) {
        if (share > allowed) {
            summary.refused += count;
            summary.first_refused = std::min(summary.first_refused, first);
        }
        const double used = share > allowed ? kInfinity : (allowed > 0 ? share / allowed : 0);
        if (used > summary.worst_used) {
            summary.worst_used = used;
            summary.worst_used_at = example;
        }
    };
    weigh(WrongShare(), shares.wrong, wrong, first_wrong, worst_wrong_at);
    weigh(MissedShare(), shares.missed, missed, first_missed, first_missed);
    return summary;
}

}  // namespace etalon
