#include "judge/judge.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

Acceptance Ulps(double ulp) {
    Acceptance rule;
    rule.ulp = ulp;
    return rule;
}

std::vector<std::uint32_t> Words(const std::vector<float>& values) {
    std::vector<std::uint32_t> words;
    for (const float value : values) {
        words.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return words;
}

Truth TruthOf(std::vector<double> values) {
    Truth truth;
    truth.errors.assign(values.size(), 0);
    truth.values = std::move(values);
    return truth;
}

float Above(float value, int steps) {
    return FromOrderedBits(OrderedBits(value) + steps);
}

Summary Judged(const Acceptance& rule, const std::vector<float>& values, const Truth& truth,
               std::uint64_t first = 0) {
    Summary summary;
    JudgeColumn(rule, Scalar::kFloat, Words(values), truth, first, summary);
    return summary;
}

TEST(JudgeColumn, CountsRowsFromTheFirst) {
    const Truth truth = TruthOf({9, 9, 1.25, 1.25, 1.25});
    const Summary summary =
        Judged(Ulps(2), {Above(1.25f, 1), Above(1.25f, 3), Above(1.25f, 2)}, truth, 2);
    EXPECT_EQ(summary.judged, 3u);
    EXPECT_EQ(summary.refused, 1u);
    EXPECT_EQ(summary.first_refused, 3u);
    EXPECT_EQ(summary.worst_ulp_error, 3);
    EXPECT_EQ(summary.worst_ulp_at, 3u);
    EXPECT_EQ(summary.worst_used, 1.5);
    EXPECT_EQ(summary.worst_used_at, 3u);
}

TEST(JudgeColumn, FindsOneWrongValueAmongMany) {
    constexpr std::size_t kRows = 5'000;
    std::vector<float> values(kRows, 1.25f);
    const Truth truth = TruthOf(std::vector<double>(kRows, 1.25));
    EXPECT_EQ(Judged(Ulps(1), values, truth).refused, 0u);
    for (const std::size_t wrong :
         {std::size_t{0}, std::size_t{511}, std::size_t{512}, kRows - 1}) {
        for (const float value : {Above(1.25f, 2), kNan, kInf, -1.0f, 0.0f}) {
            values.assign(kRows, 1.25f);
            values[wrong] = value;
            const Summary summary = Judged(Ulps(1), values, truth);
            EXPECT_EQ(summary.judged, kRows);
            EXPECT_EQ(summary.refused, 1u) << wrong << " " << value;
            EXPECT_EQ(summary.first_refused, wrong);
        }
    }
}

TEST(JudgeColumn, WidensByTheOraclesOwnError) {
    Truth truth = TruthOf({1.25, 1.25});
    truth.errors = {0, 0x1p-23};
    const Summary summary = Judged(Ulps(1), {Above(1.25f, 2), Above(1.25f, 2)}, truth);
    EXPECT_EQ(summary.refused, 1u);
    EXPECT_EQ(summary.first_refused, 0u);
}

// Rows 1, 2 and 5 of six have subnormal inputs: there 7 is true as well.
Truth WithAlternatives() {
    Truth truth = TruthOf({1, 2, 3, 4, 5, 6});
    truth.alternatives = {{1, 7, 0}, {2, 7, 0}, {5, 7, 0x1p-10}};
    return truth;
}

TEST(JudgeColumn, TakesTheAlternativeOfItsRowOnly) {
    const Truth truth = WithAlternatives();
    EXPECT_EQ(Judged(Ulps(1), {1, 2, 3, 4, 5, 6}, truth).refused, 0u);
    EXPECT_EQ(Judged(Ulps(1), {1, 7, 7, 4, 5, 7}, truth).refused, 0u);
    EXPECT_EQ(Judged(Ulps(1), {7, 2, 3, 4, 5, 6}, truth).first_refused, 0u);
    EXPECT_EQ(Judged(Ulps(1), {1, 7, 7, 7, 7, 7}, truth).refused, 2u);
    EXPECT_EQ(Judged(Ulps(1), {1, 7, 7, 7, 7, 7}, truth).first_refused, 3u);
    // Its own error counts, and only its own.
    EXPECT_EQ(Judged(Ulps(1), {1, 7, 7, 4, 5, 7 + 0x1p-11f}, truth).refused, 0u);
    EXPECT_EQ(Judged(Ulps(1), {1, 7 + 0x1p-11f, 7, 4, 5, 7}, truth).first_refused, 1u);
    // Neither one nor the other.
    EXPECT_EQ(Judged(Ulps(1), {1, 4.5f, kNan, 4, 5, 6}, truth).refused, 2u);
}

TEST(JudgeColumn, TakesTheAlternativeOfLaterChunks) {
    const Truth truth = WithAlternatives();
    EXPECT_EQ(Judged(Ulps(1), {7, 4, 5, 7}, truth, 2).refused, 0u);
    EXPECT_EQ(Judged(Ulps(1), {4, 5}, truth, 3).refused, 0u);
    const Summary summary = Judged(Ulps(1), {7, 5}, truth, 3);
    EXPECT_EQ(summary.first_refused, 3u);
    EXPECT_EQ(summary.judged, 2u);
}

TEST(JudgeColumn, KnowsNoAlternativeWithoutFlush) {
    Acceptance rule = Ulps(1);
    rule.flush = false;
    const Summary summary = Judged(rule, {1, 7, 7, 4, 5, 7}, WithAlternatives());
    EXPECT_EQ(summary.refused, 3u);
    EXPECT_EQ(summary.first_refused, 1u);
    EXPECT_EQ(summary.judged, 6u);
}

TEST(JudgeColumn, WantsIntegersAndBoolsEqualWhateverTheRule) {
    Acceptance generous = Ulps(1e6);
    generous.absolute = 100;
    Summary summary;
    JudgeColumn(generous, Scalar::kInt, std::vector<std::uint32_t>{0xffffffffu, 3, 0x80000000u},
                TruthOf({-1, 4, -2147483648.0}), 0, summary);
    EXPECT_EQ(summary.judged, 3u);
    EXPECT_EQ(summary.refused, 1u);
    EXPECT_EQ(summary.first_refused, 1u);
    EXPECT_EQ(summary.worst_used, kInf);

    Summary unsigned_summary;
    JudgeColumn(generous, Scalar::kUint, std::vector<std::uint32_t>{0xffffffffu, 0xffffffffu},
                TruthOf({4294967295.0, -1}), 0, unsigned_summary);
    EXPECT_EQ(unsigned_summary.refused, 1u);
    EXPECT_EQ(unsigned_summary.first_refused, 1u);

    Summary bool_summary;
    JudgeColumn(generous, Scalar::kBool, std::vector<std::uint32_t>{0, 1, 1, 0},
                TruthOf({0, 1, 0, 1}), 0, bool_summary);
    EXPECT_EQ(bool_summary.refused, 2u);
    EXPECT_EQ(bool_summary.first_refused, 2u);
}

TEST(JudgeColumn, FindsAnIntegerTruthThatIsNoInteger) {
    Summary summary;
    JudgeColumn({}, Scalar::kInt, std::vector<std::uint32_t>{1}, TruthOf({1.5}), 0, summary);
    EXPECT_EQ(summary.refused, 1u);
}

Acceptance Search(double missed, double wrong) {
    Acceptance rule;
    rule.absolute = 0.25;
    rule.shares = Shares{missed, wrong, 2};
    return rule;
}

TEST(TallyColumn, CountsRowsFromTheFirst) {
    const Truth truth = TruthOf({9, 9, 1, -1, 5, kNan});
    Tally tally;
    TallyColumn(Search(0, 0), Scalar::kFloat, Words({1, 3}), truth, 2, tally);
    TallyColumn(Search(0, 0), Scalar::kFloat, Words({-1, 5}), truth, 4, tally);
    EXPECT_EQ(tally.decided, 3u);
    EXPECT_EQ(tally.undecided, 1u);
    EXPECT_EQ(tally.first_wrong, 3u);
    EXPECT_EQ(tally.first_missed, 4u);
    EXPECT_EQ(tally.Settle({}).refused, 2u);
}

TEST(TallyColumn, TakesTheAlternativeOfItsRow) {
    Truth truth = TruthOf({-1, 3, 3, -1});
    truth.alternatives = {{0, 7, 0}, {1, -1, 0}, {2, kNan, 0}};
    const auto tally = [&truth](const std::vector<float>& values) {
        Tally result;
        TallyColumn(Search(0, 0), Scalar::kFloat, Words(values), truth, 0, result);
        return result;
    };
    EXPECT_EQ(tally({7, -1, 3, -1}).Settle({}).refused, 0u);
    EXPECT_EQ(tally({-1, 3, 3, -1}).Settle({}).refused, 0u);
    EXPECT_EQ(tally({4, 6, 3, 7}).Settle({}).refused, 3u);
    EXPECT_EQ(tally({-1, 3, 100, -1}).undecided, 1u);
}

TEST(TallyColumn, CountsUnequalIntegersAndBools) {
    Acceptance rule;
    rule.shares = Shares{0, 0.25, {}};
    Tally integers;
    TallyColumn(rule, Scalar::kInt, std::vector<std::uint32_t>{0xffffffffu, 3, 2, 1},
                TruthOf({-1, 4, 2, 1}), 0, integers);
    EXPECT_EQ(integers.wrong, 1u);
    EXPECT_EQ(integers.Settle(*rule.shares).refused, 0u);
    EXPECT_EQ(integers.Settle({0, 0.2, {}}).refused, 1u);
    Tally flags;
    TallyColumn(rule, Scalar::kBool, std::vector<std::uint32_t>{0, 1, 1, 0}, TruthOf({0, 1, 0, 1}),
                0, flags);
    EXPECT_EQ(flags.Settle(*rule.shares).refused, 2u);
}

TEST(JudgeValue, SaysWhatTheColumnSays) {
    const Truth truth = WithAlternatives();
    const auto word = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    EXPECT_TRUE(JudgeValue(Ulps(1), Scalar::kFloat, word(7), truth, 1).accepted);
    EXPECT_FALSE(JudgeValue(Ulps(1), Scalar::kFloat, word(7), truth, 0).accepted);
    const Judgement off = JudgeValue(Ulps(1), Scalar::kFloat, word(Above(5, 3)), truth, 4);
    EXPECT_FALSE(off.accepted);
    EXPECT_EQ(off.ulp_error, 3);
    EXPECT_EQ(off.used, 3);
    EXPECT_EQ(off.error, 3 * 0x1p-21);
}

// left relation right, with the values on both sides of the border.
struct LawRow {
    Relation relation;
    float left;
    float right;
    bool holds;
    bool holds_within_one_ulp;
};

TEST(JudgeLaw, KnowsEachRelation) {
    const float one = 1.25f;
    const float up = Above(1.25f, 1);
    const float up2 = Above(1.25f, 2);
    const LawRow rows[] = {
        {Relation::kEqual, one, one, true, true},
        {Relation::kEqual, up, one, false, true},
        {Relation::kEqual, up2, one, false, false},
        {Relation::kEqual, one, up2, false, false},
        {Relation::kLessEqual, 1, 1, true, true},
        {Relation::kLessEqual, -5, 1, true, true},
        {Relation::kLessEqual, up, one, false, true},
        {Relation::kLessEqual, up2, one, false, false},
        {Relation::kGreaterEqual, 1, 1, true, true},
        {Relation::kGreaterEqual, 5, 1, true, true},
        {Relation::kGreaterEqual, one, up, false, true},
        {Relation::kGreaterEqual, one, up2, false, false},
        {Relation::kLess, one, up, true, true},
        {Relation::kLess, 1, 1, false, true},
        {Relation::kLess, up, one, false, true},
        {Relation::kLess, up2, one, false, false},
        {Relation::kGreater, up, one, true, true},
        {Relation::kGreater, 1, 1, false, true},
        {Relation::kGreater, one, up, false, true},
        {Relation::kGreater, one, up2, false, false},
        {Relation::kEqual, 0.0f, -0.0f, true, true},
        {Relation::kLess, -0.0f, 0.0f, false, true},
        {Relation::kLessEqual, kInf, kInf, true, true},
        {Relation::kLessEqual, 1, kInf, true, true},
        {Relation::kLessEqual, kInf, 1, false, false},
        {Relation::kLess, kInf, kInf, false, false},
        {Relation::kGreaterEqual, -kInf, 1, false, false},
        {Relation::kEqual, kInf, -kInf, false, false},
    };
    for (const LawRow& row : rows) {
        Law law;
        law.relation = row.relation;
        const auto left = std::bit_cast<std::uint32_t>(row.left);
        const auto right = std::bit_cast<std::uint32_t>(row.right);
        const std::string what = std::to_string(static_cast<int>(row.relation)) + " " +
                                 HexFloat(row.left) + " " + HexFloat(row.right);
        const Judgement strict = JudgeLaw(law, Scalar::kFloat, left, right);
        EXPECT_EQ(strict.accepted, row.holds) << what;
        EXPECT_EQ(strict.used > 1, !row.holds) << what << " " << strict.used;
        law.within = Ulps(1);
        const Judgement within = JudgeLaw(law, Scalar::kFloat, left, right);
        EXPECT_EQ(within.accepted, row.holds_within_one_ulp) << what;
        EXPECT_EQ(within.used > 1, !row.holds_within_one_ulp) << what << " " << within.used;
    }
}

TEST(JudgeLaw, IsBrokenByNan) {
    for (const Relation relation : {Relation::kEqual, Relation::kLessEqual, Relation::kGreaterEqual,
                                    Relation::kLess, Relation::kGreater}) {
        Law law;
        law.relation = relation;
        law.within.absolute = 1e30;
        for (const auto& [left, right] :
             {std::pair(kNan, 1.0f), std::pair(1.0f, kNan), std::pair(kNan, kNan)}) {
            const Judgement judgement =
                JudgeLaw(law, Scalar::kFloat, std::bit_cast<std::uint32_t>(left),
                         std::bit_cast<std::uint32_t>(right));
            EXPECT_FALSE(judgement.accepted);
            EXPECT_EQ(judgement.used, kInf);
        }
    }
}

TEST(JudgeLaw, MeasuresTheToleranceAtTheRightSide) {
    Law law;
    law.within.relative = 0.25;
    const auto word = [](float value) { return std::bit_cast<std::uint32_t>(value); };
    EXPECT_TRUE(JudgeLaw(law, Scalar::kFloat, word(5), word(4)).accepted);
    EXPECT_FALSE(JudgeLaw(law, Scalar::kFloat, word(4 - 1.5f), word(4)).accepted);
    EXPECT_FALSE(JudgeLaw(law, Scalar::kFloat, word(4), word(3)).accepted);
    EXPECT_EQ(JudgeLaw(law, Scalar::kFloat, word(6), word(4)).used, 2);
}

TEST(JudgeLaw, GrantsNothingToIntegers) {
    Law law;
    law.within.absolute = 10;
    EXPECT_TRUE(JudgeLaw(law, Scalar::kInt, 3, 3).accepted);
    EXPECT_FALSE(JudgeLaw(law, Scalar::kInt, 4, 3).accepted);
    law.relation = Relation::kLess;
    EXPECT_TRUE(JudgeLaw(law, Scalar::kInt, 0xffffffffu, 3).accepted);  // -1 < 3
    EXPECT_FALSE(JudgeLaw(law, Scalar::kUint, 0xffffffffu, 3).accepted);
    EXPECT_FALSE(JudgeLaw(law, Scalar::kInt, 3, 3).accepted);
    EXPECT_GT(JudgeLaw(law, Scalar::kInt, 3, 3).used, 1);
}

}  // namespace
}  // namespace etalon
