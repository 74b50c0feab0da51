#include "numeric/tally.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Acceptance Search(double missed, double wrong, double absolute = 0.25, double beyond = 2) {
    Acceptance rule;
    rule.absolute = absolute;
    rule.shares = Shares{missed, wrong, beyond};
    return rule;
}

Acceptance Equal(double wrong) {
    Acceptance rule;
    rule.shares = Shares{0, wrong, {}};
    return rule;
}

Outcome OutcomeOf(float value, double truth, double truth_error = 0) {
    return JudgeShared(Search(0, 0), value, truth, truth_error).outcome;
}

TEST(JudgeShared, KnowsEveryOutcome) {
    EXPECT_EQ(OutcomeOf(-1, -1), Outcome::kNone);
    EXPECT_EQ(OutcomeOf(-7, -1), Outcome::kNone) << "how negative does not matter";
    EXPECT_EQ(OutcomeOf(-1e-30f, -1), Outcome::kNone);
    EXPECT_EQ(OutcomeOf(-1, 3), Outcome::kMissed);
    EXPECT_EQ(OutcomeOf(-0x1p-149f, 0), Outcome::kMissed);
    EXPECT_EQ(OutcomeOf(3, -1), Outcome::kPhantom);
    EXPECT_EQ(OutcomeOf(0, -1), Outcome::kPhantom);
    EXPECT_EQ(OutcomeOf(-0.0f, -1), Outcome::kPhantom) << "-0 is a hit at the start";
    EXPECT_EQ(OutcomeOf(-0.0f, 0), Outcome::kRight);
    EXPECT_EQ(OutcomeOf(3, 3), Outcome::kRight);
    EXPECT_EQ(OutcomeOf(5, 3), Outcome::kRight) << "just as far as `beyond`";
    EXPECT_EQ(OutcomeOf(5.0625f, 3), Outcome::kOther);
    EXPECT_EQ(OutcomeOf(5.0625f, 3, 0.0625), Outcome::kRight) << "the oracle's own error";
    EXPECT_EQ(OutcomeOf(0.9375f, 3), Outcome::kOther);
    EXPECT_EQ(OutcomeOf(kNan, 3), Outcome::kOther);
    EXPECT_EQ(OutcomeOf(kNan, -1), Outcome::kPhantom);
    EXPECT_EQ(OutcomeOf(3, kNan), Outcome::kUndecided);
    EXPECT_EQ(OutcomeOf(kNan, kNan), Outcome::kUndecided);
    EXPECT_EQ(OutcomeOf(std::numeric_limits<float>::infinity(), 3), Outcome::kOther);
}

TEST(JudgeShared, JudgesARightHitByTheTolerance) {
    const Judgement at = JudgeShared(Search(0, 0), 3.25f, 3, 0);
    EXPECT_TRUE(at.accepted);
    EXPECT_EQ(at.used, 1);
    const Judgement beyond = JudgeShared(Search(0, 0), 3.5f, 3, 0);
    EXPECT_FALSE(beyond.accepted);
    EXPECT_EQ(beyond.outcome, Outcome::kRight);
    EXPECT_EQ(beyond.used, 2);
    EXPECT_EQ(beyond.error, 0.5);
    EXPECT_TRUE(JudgeShared(Search(0, 0), 3.5f, 3, 0.25).accepted);
}

TEST(JudgeShared, OffIsInfinitelyFar) {
    for (const auto& [value, truth] :
         {std::pair(-1.0f, 3.0), std::pair(3.0f, -1.0), std::pair(kNan, 3.0)}) {
        const Judgement judgement = JudgeShared(Search(0, 0), value, truth, 0);
        EXPECT_FALSE(judgement.accepted);
        EXPECT_EQ(judgement.error, kInfinity);
        EXPECT_EQ(judgement.used, kInfinity);
    }
    const Judgement other = JudgeShared(Search(0, 0), 6, 3, 0);
    EXPECT_EQ(other.error, 3);
    EXPECT_EQ(other.used, kInfinity);
}

TEST(JudgeShared, WithoutBeyondIsExact) {
    EXPECT_EQ(JudgeShared(Equal(0), -3, -3, 0).outcome, Outcome::kRight);
    EXPECT_EQ(JudgeShared(Equal(0), -3, -2, 0).outcome, Outcome::kOther);
    EXPECT_EQ(JudgeShared(Equal(0), -3, 2, 0).outcome, Outcome::kOther);
    EXPECT_EQ(JudgeSharedExact(2, 2).outcome, Outcome::kRight);
    EXPECT_EQ(JudgeSharedExact(1, 2).outcome, Outcome::kOther);
    EXPECT_EQ(JudgeSharedExact(1, 2).error, 1);
    EXPECT_EQ(JudgeSharedExact(1, kNan).outcome, Outcome::kUndecided);
}

Tally Tallied(const Acceptance& rule, const std::vector<float>& values,
              const std::vector<double>& truths, std::size_t chunk) {
    Tally tally;
    for (std::size_t first = 0; first < values.size(); first += chunk) {
        for (std::size_t row = first; row < std::min(first + chunk, values.size()); ++row) {
            tally.Add(row, JudgeShared(rule, values[row], truths[row], 0));
        }
    }
    return tally;
}

// 100 rows: 20 truths are none, 4 undecided, 76 hits.
struct Column {
    std::vector<float> values;
    std::vector<double> truths;

    Column() {
        for (int row = 0; row < 100; ++row) {
            truths.push_back(row < 20 ? -1.0 : row < 24 ? double{kNan} : row);
            values.push_back(static_cast<float>(truths.back()));
        }
    }
    Tally Under(const Acceptance& rule) const { return Tallied(rule, values, truths, 7); }
    Summary Settled(const Acceptance& rule) const { return Under(rule).Settle(*rule.shares); }
};

TEST(Tally, CountsWhatThereIs) {
    Column column;
    column.values[30] = -1;
    column.values[31] = -1;
    column.values[40] = 50;
    column.values[3] = 8;
    column.values[60] += 0.125f;
    const Tally tally = column.Under(Search(0, 0));
    EXPECT_EQ(tally.decided, 96u);
    EXPECT_EQ(tally.undecided, 4u);
    EXPECT_EQ(tally.hits, 76u);
    EXPECT_EQ(tally.missed, 2u);
    EXPECT_EQ(tally.wrong, 2u);
    EXPECT_EQ(tally.MissedShare(), 2.0 / 76);
    EXPECT_EQ(tally.WrongShare(), 2.0 / 96);
    EXPECT_EQ(tally.worst_right_error, 0.125);
    EXPECT_EQ(tally.worst_wrong_at, 3u) << "a phantom is infinitely off";
}

TEST(Tally, RefusesAShareOnlyBeyondIt) {
    Column column;
    column.values[30] = -1;
    column.values[31] = -1;
    Summary summary = column.Settled(Search(2.0 / 76, 0));
    EXPECT_EQ(summary.judged, 96u);
    EXPECT_EQ(summary.refused, 0u);
    EXPECT_EQ(summary.worst_used, 1);
    EXPECT_EQ(summary.worst_used_at, 30u);
    column.values[32] = -1;
    summary = column.Settled(Search(2.0 / 76, 0));
    EXPECT_EQ(summary.refused, 3u);
    EXPECT_EQ(summary.worst_used, kInfinity);
    EXPECT_EQ(summary.worst_used_at, 30u);
    EXPECT_EQ(summary.first_refused, 30u);

    column = {};
    column.values[30] = 33;
    column.values[40] = 50;
    EXPECT_EQ(column.Settled(Search(0, 2.0 / 96)).refused, 0u);
    summary = column.Settled(Search(0.4, 1.0 / 96));
    EXPECT_EQ(summary.refused, 2u);
    EXPECT_EQ(summary.worst_used_at, 40u) << "the greatest error";
    EXPECT_EQ(summary.first_refused, 30u);
}

TEST(Tally, RefusesEveryRightHitBeyondTheTolerance) {
    Column column;
    column.values[70] += 0.5f;
    Summary summary = column.Settled(Search(0.4, 0.4));
    EXPECT_EQ(summary.refused, 1u);
    EXPECT_EQ(summary.worst_used, 2);
    EXPECT_EQ(summary.worst_used_at, 70u);
    column.values[2] = 1;
    summary = column.Settled(Search(0.4, 0.4));
    EXPECT_EQ(summary.refused, 1u) << "a phantom that the share allows";
    EXPECT_EQ(summary.worst_used_at, 70u);
    summary = column.Settled(Search(0, 0));
    EXPECT_EQ(summary.refused, 2u);
    EXPECT_EQ(summary.worst_used_at, 2u);
}

TEST(Tally, IsTheSameInAnyChunks) {
    Column column;
    for (const std::size_t row : {1u, 5u, 33u, 34u, 77u, 99u}) {
        column.values[row] = row % 2 == 0 ? -1 : 1000;
    }
    column.values[50] += 1;
    const Acceptance rule = Search(0.01, 0.04);
    const Tally whole = Tallied(rule, column.values, column.truths, 100);
    for (const std::size_t chunk : {1u, 3u, 64u}) {
        const Tally tally = Tallied(rule, column.values, column.truths, chunk);
        const Summary a = whole.Settle(*rule.shares);
        const Summary b = tally.Settle(*rule.shares);
        EXPECT_EQ(a.judged, b.judged);
        EXPECT_EQ(a.refused, b.refused);
        EXPECT_EQ(a.worst_used_at, b.worst_used_at);
        EXPECT_EQ(a.first_refused, b.first_refused);
        EXPECT_EQ(whole.worst_right_error, tally.worst_right_error);
    }
}

TEST(Tally, IsNothingWithoutRows) {
    const Summary summary = Tally().Settle({0.1, 0.1, 1});
    EXPECT_EQ(summary.judged, 0u);
    EXPECT_EQ(summary.refused, 0u);
    EXPECT_EQ(summary.worst_used, 0);
}

}  // namespace
}  // namespace etalon
