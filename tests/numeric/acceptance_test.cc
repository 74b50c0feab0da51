#include "numeric/acceptance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr float kInfinite = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kLargest = std::numeric_limits<float>::max();

Acceptance Rule(std::optional<double> ulp, std::optional<double> absolute = {},
                std::optional<double> relative = {}, bool flush = true) {
    Acceptance rule;
    rule.ulp = ulp;
    rule.absolute = absolute;
    rule.relative = relative;
    rule.flush = flush;
    return rule;
}

bool Accepts(const Acceptance& rule, float value, double truth, double truth_error = 0) {
    return Judge(rule, value, truth, truth_error).accepted;
}

TEST(Acceptance, ReadsAloud) {
    EXPECT_EQ(Rule(16, 1e-9).Text(), "ulp 16 or absolute 1e-09");
    EXPECT_EQ(Rule({}, {}, 0.5).Text(), "relative 0.5");
    EXPECT_EQ(Rule({}).Text(), "exact");
    EXPECT_EQ(Rule({}, {}, {}, false).Text(), "exact, no flush");
    Acceptance search = Rule({}, 0.02);
    search.shares = Shares{0.001, 0.01, 2};
    EXPECT_EQ(search.Text(), "absolute 0.02, missed 0.001, wrong 0.01, beyond 2");
    Acceptance equal = Rule({});
    equal.shares = Shares{0, 0.01, {}};
    EXPECT_EQ(equal.Text(), "exact, wrong 0.01");
}

TEST(Acceptance, GrantsTheWidestTolerance) {
    EXPECT_EQ(Tolerance(Rule(2, 1e-3), 1.5), 1e-3);
    EXPECT_EQ(Tolerance(Rule(2, 1e-9), 1.5), 0x1p-22);
    EXPECT_EQ(Tolerance(Rule(2, 1e-9, 0.25), -8), 2);
    EXPECT_EQ(Tolerance(Rule({}), 8), 0);
    EXPECT_EQ(Tolerance(Rule({}, {}, 0.25), kInfinity), 0);
}

TEST(Judge, HoldsAtTheToleranceAndRefusesBeyond) {
    const Acceptance rule = Rule(2);
    const Judgement at = Judge(rule, 1.5f + 0x1p-22f, 1.5, 0);
    EXPECT_TRUE(at.accepted);
    EXPECT_EQ(at.error, 0x1p-22);
    EXPECT_EQ(at.ulp_error, 2);
    EXPECT_EQ(at.used, 1);
    const Judgement beyond = Judge(rule, 1.5f + 3 * 0x1p-23f, 1.5, 0);
    EXPECT_FALSE(beyond.accepted);
    EXPECT_EQ(beyond.used, 1.5);
    EXPECT_TRUE(Accepts(rule, 1.5f + 3 * 0x1p-23f, 1.5, 0x1p-23)) << "the oracle's own error";
    EXPECT_FALSE(Accepts(rule, 1.5f + 3 * 0x1p-23f, 1.5, 0x1.fp-24));
    EXPECT_FALSE(Accepts(rule, 1.5f + 3 * 0x1p-23f, 1.5, std::nan("")));
}

TEST(Judge, AnyToleranceIsEnough) {
    EXPECT_TRUE(Accepts(Rule(1, 0.5), 1.25f, 1));
    EXPECT_TRUE(Accepts(Rule(1, {}, 0.25), 1.25f, 1));
    EXPECT_FALSE(Accepts(Rule(1, 0.1, 0.2), 1.25f, 1));
}

TEST(Judge, ExactMeansTheNearestFloat) {
    const Acceptance exact = Rule({});
    const float third = static_cast<float>(1.0 / 3);
    EXPECT_TRUE(Accepts(exact, third, 1.0 / 3));
    EXPECT_EQ(Judge(exact, third, 1.0 / 3, 0).used, 0);
    EXPECT_FALSE(Accepts(exact, std::nextafter(third, 1.0f), 1.0 / 3));
    EXPECT_EQ(Judge(exact, std::nextafter(third, 1.0f), 1.0 / 3, 0).used, kInfinity);
    EXPECT_TRUE(Accepts(exact, -0.0f, 0));
    EXPECT_TRUE(Accepts(exact, 0.0f, -0.0));
    const double tie = 1 + 0x1p-24;
    EXPECT_FALSE(Accepts(exact, 1 + 0x1p-23f, tie));
    EXPECT_TRUE(Accepts(exact, 1 + 0x1p-23f, tie, 1e-15)) << "the truth may lie above the tie";
}

TEST(Judge, NanMatchesNanAlone) {
    const Acceptance wide = Rule(1e30, kInfinity, 1e30);
    EXPECT_FALSE(Accepts(wide, kNan, 1));
    EXPECT_FALSE(Accepts(wide, kNan, 1, kInfinity));
    EXPECT_FALSE(Accepts(wide, kNan, kInfinity));
    EXPECT_FALSE(Accepts(wide, 1, std::nan("")));
    EXPECT_TRUE(Accepts(Rule({}), kNan, std::nan("")));
    EXPECT_EQ(Judge(wide, kNan, 1, 0).error, kInfinity);
    EXPECT_EQ(Judge(wide, kNan, 1, 0).used, kInfinity);
}

TEST(Judge, RefusesNothingWhereNothingIsKnown) {
    EXPECT_TRUE(Accepts(Rule({}), 1, std::nan(""), kInfinity));
    EXPECT_TRUE(Accepts(Rule({}), 1, kInfinity, kInfinity));
    EXPECT_TRUE(IsBlind(Rule({}), kInfinity, kInfinity));
    const float value[] = {1};
    const double truth[] = {kInfinity};
    Summary summary;
    JudgeAll(Rule({}), value, truth, 1e-15, 0, 0, summary);
    EXPECT_EQ(summary.refused, 1u) << "a relative bound says nothing about an infinity";
}

TEST(Judge, InfinityMatchesItselfOrAnOverflow) {
    const Acceptance ulp = Rule(2);
    EXPECT_TRUE(Accepts(ulp, kInfinite, kInfinity));
    EXPECT_FALSE(Accepts(ulp, -kInfinite, kInfinity));
    EXPECT_FALSE(Accepts(ulp, kLargest, kInfinity));
    EXPECT_FALSE(Accepts(Rule({}, 1e30), kInfinite, 1));
    const double largest = kLargest;
    EXPECT_TRUE(Accepts(ulp, kInfinite, largest - 0x1p104));
    EXPECT_TRUE(Accepts(ulp, -kInfinite, -largest + 0x1p104));
    EXPECT_FALSE(Accepts(ulp, -kInfinite, largest - 0x1p104));
    EXPECT_FALSE(Accepts(ulp, kInfinite, largest - 0x1p105));
    EXPECT_LE(Judge(ulp, kInfinite, largest - 0x1p104, 0).used, 1);
    EXPECT_TRUE(Accepts(ulp, kInfinite, 1e300));
    EXPECT_TRUE(Accepts(ulp, kLargest, 1e300));
    EXPECT_FALSE(Accepts(ulp, -kLargest, 1e300));
    EXPECT_FALSE(Accepts(ulp, std::nextafter(kLargest, 0.0f), 1e300));
    EXPECT_TRUE(Accepts(Rule({}), kInfinite, 1e39));
    EXPECT_TRUE(Accepts(Rule({}), kLargest, 1e39));
    EXPECT_FALSE(Accepts(Rule({}), kInfinite, largest));
    EXPECT_TRUE(Accepts(Rule({}), kLargest, largest));
}

TEST(Judge, FlushAcceptsZeroForSubnormalsOnly) {
    const double subnormal = 0x1.8p-127;
    for (const Acceptance& rule : {Rule({}), Rule(2)}) {
        EXPECT_TRUE(Accepts(rule, 0.0f, subnormal));
        EXPECT_TRUE(Accepts(rule, -0.0f, subnormal));
        EXPECT_TRUE(Accepts(rule, 0.0f, -subnormal));
        EXPECT_EQ(Judge(rule, 0.0f, subnormal, 0).used, 0);
        EXPECT_TRUE(Accepts(rule, static_cast<float>(subnormal), subnormal));
        EXPECT_FALSE(Accepts(rule, static_cast<float>(subnormal) / 2, subnormal));
    }
    EXPECT_FALSE(Accepts(Rule({}, {}, {}, false), 0.0f, subnormal));
    EXPECT_FALSE(Accepts(Rule(2, {}, {}, false), 0.0f, subnormal));
    EXPECT_FALSE(Accepts(Rule({}), 0.0f, 0x1p-126));
    EXPECT_TRUE(Accepts(Rule({}), 0.0f, 0x1p-126, 1e-50)) << "the truth may be subnormal";
    EXPECT_TRUE(Accepts(Rule(1), 0.0f, 0x1p-126)) << "the interval reaches into the subnormals";
    EXPECT_FALSE(Accepts(Rule(1), 0.0f, 0x1p-126 + 0x1p-148));
    EXPECT_FALSE(Accepts(Rule(2), 0.0f, 1e-30));
}

TEST(IsBlind, SeesARuleThatAcceptsEverything) {
    EXPECT_FALSE(IsBlind(Rule(16), 1));
    EXPECT_FALSE(IsBlind(Rule({}), 0x1p-104));
    EXPECT_TRUE(IsBlind(Rule({}, 10), 1));
    EXPECT_FALSE(IsBlind(Rule({}, 10), 100));
    EXPECT_TRUE(IsBlind(Rule({}, {}, 2.5), 1));
    EXPECT_FALSE(IsBlind(Rule({}, {}, 0.5), 1));
    EXPECT_TRUE(IsBlind(Rule({}, 1), 0));
    EXPECT_FALSE(IsBlind(Rule({}, 0.5), 0));
    EXPECT_FALSE(IsBlind(Rule({}, 1e9), std::nan("")));
    EXPECT_FALSE(IsBlind(Rule({}, 1e9), kInfinity));
    EXPECT_TRUE(IsBlind(Rule(1), 1, kInfinity)) << "an oracle that knows nothing";
    EXPECT_FALSE(IsBlind(Rule(1), kLargest));
}

// The batch must say what the single judgements say.
TEST(JudgeAll, AgreesWithJudge) {
    const std::size_t count = 5003;
    std::vector<float> values(count);
    std::vector<double> truths(count);
    std::vector<double> errors(count);
    const float odd[] = {kNan, kInfinite, -kInfinite, kLargest, 0.0f, -0.0f, 0x1p-140f, 1.0f};
    for (const Acceptance& rule : {Rule(2), Rule(2, 1e-3), Rule({}), Rule(1, {}, 1e-6, false)}) {
        for (const unsigned wild : {0u, 1u, 7u}) {
            for (std::size_t k = 0; k < count; ++k) {
                truths[k] = FromBits(static_cast<std::uint32_t>(Mix(wild, k)));
                if (!std::isfinite(truths[k])) {
                    truths[k] = 1.0 / 3;
                }
                values[k] = static_cast<float>(truths[k]);
                if (wild > 0 && Mix(9, k) % 50 < wild) {
                    values[k] = odd[Mix(10, k) % 8];
                }
                if (wild > 0 && Mix(11, k) % 50 < wild) {
                    truths[k] = odd[Mix(12, k) % 8];
                }
                if (Mix(13, k) % 100 == 0) {
                    values[k] = std::nextafter(values[k], 0.0f);
                }
                errors[k] = std::fabs(truths[k]) * 1e-12;
                errors[k] = std::isfinite(errors[k]) ? errors[k] : 0;
            }
            Summary expected;
            for (std::size_t k = 0; k < count; ++k) {
                expected.Add(100 + k, Judge(rule, values[k], truths[k], errors[k]));
            }
            Summary summary;
            const std::size_t half = 2048;
            const std::span<const float> all_values(values);
            const std::span<const double> all_truths(truths);
            const std::span<const double> all_errors(errors);
            JudgeAll(rule, all_values.first(half), all_truths.first(half), all_errors.first(half),
                     100, summary);
            JudgeAll(rule, all_values.subspan(half), all_truths.subspan(half),
                     all_errors.subspan(half), 100 + half, summary);
            EXPECT_EQ(summary.judged, expected.judged);
            EXPECT_EQ(summary.refused, expected.refused);
            EXPECT_EQ(summary.first_refused, expected.first_refused);
            EXPECT_EQ(summary.worst_ulp_error, expected.worst_ulp_error);
            EXPECT_EQ(summary.worst_ulp_at, expected.worst_ulp_at);
            EXPECT_EQ(summary.worst_used, expected.worst_used);
            EXPECT_EQ(summary.worst_used_at, expected.worst_used_at);
        }
    }
}

TEST(JudgeAll, FindsTheOneWrongValue) {
    std::vector<float> values(3000, 1.5f);
    const std::vector<double> truths(3000, 1.5);
    Summary summary;
    JudgeAll(Rule(1), values, truths, 0, 0, 0, summary);
    EXPECT_EQ(summary.refused, 0u);
    EXPECT_EQ(summary.worst_ulp_at, Summary::kNone);
    values[1234] = 1.5f + 0x1p-22f;
    JudgeAll(Rule(1), values, truths, 0, 0, 3000, summary);
    EXPECT_EQ(summary.judged, 6000u);
    EXPECT_EQ(summary.refused, 1u);
    EXPECT_EQ(summary.first_refused, 4234u);
    EXPECT_EQ(summary.worst_ulp_error, 2);
    EXPECT_EQ(summary.worst_used_at, 4234u);
    Summary widened;
    JudgeAll(Rule(1), values, truths, 0, 0x1p-23, 0, widened);
    EXPECT_EQ(widened.refused, 0u);
    EXPECT_EQ(widened.worst_used, 1);
}

TEST(TruthError, TurnsTheBoundAround) {
    EXPECT_EQ(TruthError(-2, 0.5, 1), 4);  // an exact value of -6 may have been computed as -2
}

}  // namespace
}  // namespace etalon
