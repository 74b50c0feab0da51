#include "judge/budget.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "judge/judge.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<float>::max();
constexpr double kUlp = 0x1p-23;  // of numbers from above 1 to 2

std::uint32_t Word(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

Allowed Interval(float low, float high) {
    return {Allowed::Kind::kNumber, low, high, 0, 0};
}
Allowed OneWord(std::uint32_t word) {
    return {Allowed::Kind::kWord, 0, 0, word, 0};
}
const Allowed kAnything;

Parts Of(double truth, double method, double strict, double device, bool flush = true) {
    return PartsOf(Scalar::kFloat, {truth, 0, method, strict, device}, flush);
}

// By readings and an interval.
Culprit Blamed(double truth, double method, double strict, float device, const Allowed& allowed) {
    return CulpritOf(Of(truth, method, strict, device), allowed, Excess(allowed, Word(device)));
}

TEST(Excess, IsNothingInside) {
    for (const float value : {1.0f, 1.5f, 2.0f}) {
        EXPECT_EQ(Excess(Interval(1, 2), Word(value)), 0);
    }
    EXPECT_EQ(Excess(Interval(0, 1), Word(-0.0f)), 0);
    EXPECT_EQ(Excess(Interval(-0.0f, -0.0f), Word(0.0f)), 0);
    EXPECT_EQ(Excess(Interval(1, static_cast<float>(kInf)), Word(static_cast<float>(kInf))), 0);
    EXPECT_EQ(Excess(OneWord(7), 7), 0);
}

TEST(Excess, IsMeasuredFromTheNearerEnd) {
    EXPECT_EQ(Excess(Interval(1.25f, 1.5f), Word(static_cast<float>(1.5 + 3 * kUlp))), 3);
    EXPECT_EQ(Excess(Interval(1.25f, 1.5f), Word(static_cast<float>(1.25 - kUlp))), 1);
    EXPECT_EQ(Excess(Interval(1.5f, static_cast<float>(kInf)), Word(1.25f)), 0x1p21);
}

TEST(Excess, IsInfiniteWhereThereIsNoDistance) {
    EXPECT_EQ(Excess(Interval(1, 2), Word(static_cast<float>(kNan))), kInf);
    EXPECT_EQ(Excess(Interval(1, 2), Word(static_cast<float>(kInf))), kInf);
    EXPECT_EQ(Excess(Interval(1, static_cast<float>(kInf)), Word(static_cast<float>(-kInf))), kInf);
    EXPECT_EQ(Excess(Interval(1, static_cast<float>(kInf)), Word(static_cast<float>(kNan))), kInf);
    EXPECT_EQ(Excess(OneWord(7), 8), kInf);
}

TEST(Excess, OfANumberBetweenMultiplesIsTheWayToOne) {
    Allowed eighths = Interval(1, 2);
    eighths.quantum = 0.125f;
    EXPECT_EQ(Excess(eighths, Word(1.375f)), 0);
    EXPECT_EQ(Excess(eighths, Word(static_cast<float>(1.375 - 3 * kUlp))), 3);
    EXPECT_EQ(Excess(eighths, Word(1.4375f)), 0x1p19);
    EXPECT_EQ(JudgeAllowed(eighths, Word(1.4375f)).used, kInf);
    EXPECT_EQ(JudgeAllowed(eighths, Word(1.4375f)).error, 0.0625);
    EXPECT_FALSE(JudgeAllowed(eighths, Word(1.4375f)).accepted);
    EXPECT_EQ(JudgeAllowed(eighths, Word(1.75f)).used, 0.5);
    eighths.high = static_cast<float>(kInf);
    EXPECT_EQ(Excess(eighths, Word(static_cast<float>(kInf))), 0);
}

TEST(Excess, IsNothingWhereThereIsNoBound) {
    EXPECT_EQ(Excess(kAnything, Word(static_cast<float>(kNan))), 0);
    EXPECT_EQ(Excess(kAnything, 12345), 0);
}

TEST(JudgeAllowed, TellsTheShareOfTheIntervalThatIsUsed) {
    EXPECT_EQ(JudgeAllowed(Interval(1, 2), Word(1.5f)).used, 0);
    EXPECT_EQ(JudgeAllowed(Interval(1, 2), Word(1.75f)).used, 0.5);
    EXPECT_EQ(JudgeAllowed(Interval(1, 2), Word(2)).used, 1);
    EXPECT_TRUE(JudgeAllowed(Interval(1, 2), Word(2)).accepted);
    const Judgement outside = JudgeAllowed(Interval(1, 2), Word(3));
    EXPECT_FALSE(outside.accepted);
    EXPECT_EQ(outside.used, 3);
    EXPECT_EQ(outside.error, 1);
    EXPECT_EQ(outside.ulp_error, 0x1p23);
    // Next to an end, yet more than all of it.
    EXPECT_GT(JudgeAllowed(Interval(-1e30f, 1), Word(std::nextafter(1.0f, 2.0f))).used, 1);
}

TEST(JudgeAllowed, NeedsNoWidth) {
    EXPECT_TRUE(JudgeAllowed(Interval(1, 1), Word(1)).accepted);
    EXPECT_EQ(JudgeAllowed(Interval(1, 1), Word(1)).used, 0);
    EXPECT_EQ(JudgeAllowed(Interval(1, 1), Word(std::nextafter(1.0f, 2.0f))).used, kInf);
    const auto all = static_cast<float>(kInf);
    EXPECT_EQ(JudgeAllowed(Interval(1, all), Word(5)).used, 0);
    EXPECT_EQ(JudgeAllowed(Interval(1, all), Word(0.5f)).used, kInf);
    EXPECT_EQ(JudgeAllowed(Interval(1, 2), Word(static_cast<float>(kNan))).used, kInf);
    EXPECT_TRUE(JudgeAllowed(OneWord(3), 3).accepted);
    EXPECT_FALSE(JudgeAllowed(OneWord(3), 4).accepted);
    EXPECT_EQ(JudgeAllowed(OneWord(3), 4).used, kInf);
}

TEST(Parts, AreTheStepsFromTruthToResult) {
    const Parts parts = Of(1.5, 1.5 + 0.25 * kUlp, 1.5 + 2 * kUlp, 1.5 - kUlp);
    EXPECT_EQ(parts.method.ulp, 0.25);
    EXPECT_EQ(parts.rounding.ulp, 1.75);
    EXPECT_EQ(parts.driver.ulp, 3);
    EXPECT_EQ(parts.driver.absolute, 3 * kUlp);
}

TEST(Parts, LeaveTheOraclesErrorOut) {
    Readings readings = {1.5, 0, 1.5 + kUlp, 1.5 + kUlp, 1.5 + kUlp};
    EXPECT_EQ(PartsOf(Scalar::kFloat, readings, true).method.ulp, 1);
    readings.truth_error = 0.75 * kUlp;
    EXPECT_EQ(PartsOf(Scalar::kFloat, readings, true).method.ulp, 0.25);
    readings.truth_error = 2 * kUlp;
    EXPECT_EQ(PartsOf(Scalar::kFloat, readings, true).method.ulp, 0);
    readings.truth_error = kInf;
    readings.method = kNan;
    EXPECT_EQ(PartsOf(Scalar::kFloat, readings, true).method.ulp, 0);
}

TEST(Parts, OfANaNAreInfiniteButAgainstANaN) {
    EXPECT_EQ(Of(1, kNan, kNan, kNan).method.ulp, kInf);
    EXPECT_EQ(Of(1, kNan, kNan, kNan).rounding.ulp, 0);
    EXPECT_EQ(Of(1, kNan, kNan, kNan).driver.ulp, 0);
    EXPECT_EQ(Of(1, 1, kNan, kNan).rounding.ulp, kInf);
    EXPECT_EQ(Of(1, 1, 1, kNan).driver.ulp, kInf);
    EXPECT_EQ(Of(1, 1, 1, kNan).rounding.ulp, 0);
    EXPECT_EQ(Of(kNan, kNan, kNan, 1).method.ulp, 0);
    EXPECT_EQ(Of(kNan, kNan, kNan, 1).driver.ulp, kInf);
    EXPECT_EQ(Of(kNan, kNan, kNan, kNan).driver.ulp, 0);
    EXPECT_EQ(Of(kNan, 1.5, 1.5, 1.5).method.ulp, kInf);
}

TEST(Parts, WithoutATruthAreInUlpOfTheMethod) {
    const Parts parts =
        PartsOf(Scalar::kFloat, {std::nullopt, 0, 1.5, 1.5 + 2 * kUlp, 1.5 + 3 * kUlp}, true);
    EXPECT_EQ(parts.method.ulp, 0);
    EXPECT_EQ(parts.rounding.ulp, 2);
    EXPECT_EQ(parts.driver.ulp, 1);
    EXPECT_EQ(Of(kNan, kNan, 1.5, 1.5 + 4 * kUlp).driver.ulp, 4);
}

TEST(Parts, OfAnInfinityAreInfiniteButBeyondTheLargestFloat) {
    EXPECT_EQ(Of(kInf, kInf, kInf, kInf).driver.ulp, 0);
    EXPECT_EQ(Of(kInf, kInf, kInf, -kInf).driver.ulp, kInf);
    EXPECT_EQ(Of(1, 1, 1, kInf).driver.ulp, kInf);
    EXPECT_EQ(Of(kInf, 1e300, kInf, kInf).method.ulp, 0);
    EXPECT_EQ(Of(kInf, -1e300, kInf, kInf).method.ulp, kInf);
    EXPECT_EQ(Of(1e39, 1e39, kInf, kInf).rounding.ulp, 0);
    EXPECT_EQ(Of(1e39, 1e39, kInf, kLargest).driver.ulp, 1);
    EXPECT_EQ(Of(1e39, 1e39, kInf, -kLargest).driver.ulp, kInf);
}

TEST(Parts, HoldNoDriverToSubnormalResults) {
    EXPECT_EQ(Of(1e-40, 1e-40, 1e-40, 0).driver.ulp, 0);
    EXPECT_EQ(Of(1e-40, 1e-40, 1e-40, -0.0).driver.ulp, 0);
    EXPECT_GT(Of(1e-40, 1e-40, 1e-40, 0, false).driver.ulp, 1);
    EXPECT_GT(Of(1e-40, 1e-40, 1e-40, 2e-40).driver.ulp, 1);
    EXPECT_GT(Of(0x1p-126, 0x1p-126, 0x1p-126, 0).driver.ulp, 1);
    // Rounded to the least normal number, but subnormal before.
    EXPECT_EQ(Of(0x1p-126, 0x1.ffffffffp-127, 0x1p-126, 0).driver.ulp, 0);
}

TEST(Parts, OfZerosOfBothSignsAreNothing) {
    const Parts parts = Of(0, -0.0, 0, -0.0);
    EXPECT_EQ(parts.method.ulp, 0);
    EXPECT_EQ(parts.rounding.ulp, 0);
    EXPECT_EQ(parts.driver.ulp, 0);
}

TEST(Parts, OfWhatIsNoFloatAreRightOrWrong) {
    const Parts parts = PartsOf(Scalar::kInt, {7.0, 0, 7, 8, 8}, true);
    EXPECT_EQ(parts.method.ulp, 0);
    EXPECT_EQ(parts.rounding.ulp, kInf);
    EXPECT_EQ(parts.rounding.absolute, 1);
    EXPECT_EQ(parts.driver.ulp, 0);
}

TEST(Culprit, IsTheLargestPart) {
    EXPECT_EQ(Blamed(1.5, 1.75, 1.75, 1.75f, kAnything), Culprit::kMethod);
    EXPECT_EQ(Blamed(1.5, 1.5, 1.75, 1.75f, kAnything), Culprit::kRounding);
    EXPECT_EQ(Blamed(1.5, 1.5, 1.5, 1.75f, Interval(1, 1.6f)), Culprit::kDriver);
    EXPECT_EQ(Blamed(1.5, 1.5, 1.5, 1.75f, Interval(1, 2)), Culprit::kDriverAllowed);
    EXPECT_EQ(Blamed(1.5, 1.5, 1.5, 1.75f, kAnything), Culprit::kDriverUnstated);
    // Where a device is outside, but this is the lesser part of the error.
    EXPECT_EQ(Blamed(1, 1.5, 1.5, 1.625f, Interval(1.5f, 1.5f)), Culprit::kMethod);
}

TEST(Culprit, OfEqualPartsIsTheFirst) {
    EXPECT_EQ(Blamed(1.25, 1.5, 1.75, 1.5f, kAnything), Culprit::kMethod);
    EXPECT_EQ(Blamed(1.25, 1.25, 1.5, 1.25f, kAnything), Culprit::kRounding);
    EXPECT_EQ(Blamed(1, kNan, 1, static_cast<float>(kNan), kAnything), Culprit::kMethod);
    EXPECT_EQ(Blamed(1, 1, kNan, 1, kAnything), Culprit::kRounding);
}

TEST(Culprit, IsWhoeverMakesTheNaN) {
    const auto nan = static_cast<float>(kNan);
    EXPECT_EQ(Blamed(1, kNan, kNan, nan, kAnything), Culprit::kMethod);
    EXPECT_EQ(Blamed(1, 1, kNan, nan, kAnything), Culprit::kRounding);
    EXPECT_EQ(Blamed(1, 1, 1, nan, Interval(1, 1)), Culprit::kDriver);
    EXPECT_EQ(Blamed(1, 1, 1, nan, kAnything), Culprit::kDriverUnstated);
    EXPECT_EQ(Blamed(kNan, 1, 1, 1, kAnything), Culprit::kMethod);
}

TEST(Culprit, HasAName) {
    EXPECT_EQ(CulpritName(Culprit::kMethod), "method");
    EXPECT_EQ(CulpritName(Culprit::kRounding), "rounding");
    EXPECT_EQ(CulpritName(Culprit::kDriver), "driver");
    EXPECT_EQ(CulpritName(Culprit::kDriverAllowed), "driver, within the specification");
    EXPECT_EQ(CulpritName(Culprit::kDriverUnstated), "driver, where the specification is silent");
}

class LawCulprit : public ::testing::Test {
  protected:
    LawCulprit() { law_.relation = Relation::kEqual; }

    Culprit Of(const Sides<double>& method, const Sides<float>& strict, const Sides<float>& device,
               const Sides<Allowed>& allowed = {}) const {
        return CulpritOfLaw(law_, Scalar::kFloat, method, {Word(strict.left), Word(strict.right)},
                            {Word(device.left), Word(device.right)}, allowed);
    }

    Law law_;
};

TEST_F(LawCulprit, IsTheFirstThatBreaksIt) {
    EXPECT_EQ(Of({1, 2}, {1, 2}, {1, 2}), Culprit::kMethod);
    EXPECT_EQ(Of({1, 2}, {1, 1}, {1, 2}), Culprit::kMethod);
    EXPECT_EQ(Of({1, 1}, {1, 2}, {1, 2}), Culprit::kRounding);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {1, 2}), Culprit::kDriverUnstated);
    EXPECT_EQ(Of({kNan, 1}, {1, 1}, {1, 2}), Culprit::kMethod);
}

TEST_F(LawCulprit, IsADriverWhereEitherSideIsOutside) {
    const Allowed one = Interval(1, 1);
    const Allowed up_to_two = Interval(1, 2);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {1, 2}, {one, one}), Culprit::kDriver);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {2, 1}, {one, one}), Culprit::kDriver);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {1, 2}, {one, up_to_two}), Culprit::kDriverAllowed);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {1, 2}, {kAnything, up_to_two}), Culprit::kDriverUnstated);
    EXPECT_EQ(Of({1, 1}, {1, 1}, {1, 2}, {kAnything, one}), Culprit::kDriver);
}

TEST_F(LawCulprit, IsNoMethodWhoseSidesRoundAlike) {
    EXPECT_EQ(Of({1, 1 + 0x1p-40}, {1, 2}, {1, 2}), Culprit::kRounding);
    law_.relation = Relation::kLess;
    // Strictly less, though both become the same float.
    EXPECT_EQ(Of({1, 1 + 0x1p-40}, {1, 1}, {1, 1}), Culprit::kRounding);
    EXPECT_EQ(Of({1 + 0x1p-40, 1}, {1, 1}, {1, 1}), Culprit::kMethod);
}

TEST_F(LawCulprit, GrantsTheLawsTolerance) {
    law_.within.ulp = 4;
    EXPECT_EQ(Of({1.5, 1.5 + 3 * kUlp}, {1.5f, 2}, {1.5f, 2}), Culprit::kRounding);
    EXPECT_EQ(Of({1.5, 1.5 + 5 * kUlp}, {1.5f, 2}, {1.5f, 2}), Culprit::kMethod);
}

TEST(LawByMethod, KnowsIntegers) {
    Law law;
    law.relation = Relation::kLessEqual;
    EXPECT_TRUE(JudgeLawByMethod(law, Scalar::kInt, {-3, 4}).accepted);
    EXPECT_FALSE(JudgeLawByMethod(law, Scalar::kInt, {4, -3}).accepted);
    EXPECT_FALSE(JudgeLawByMethod(law, Scalar::kUint, {4294967295.0, 0}).accepted);
    EXPECT_FALSE(JudgeLawByMethod(law, Scalar::kBool, {1, 0}).accepted);
}

}  // namespace
}  // namespace etalon
