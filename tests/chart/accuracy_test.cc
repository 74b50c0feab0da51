#include "chart/accuracy.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// A case of one input, its row's number, whose outputs have these truths.
PreparedCase CaseOf(const std::vector<std::vector<double>>& truths, const Acceptance& accept = {}) {
    PreparedCase prepared;
    prepared.table.variables = {{"i", "float", 0, 1}};
    prepared.table.columns = {{"i", Scalar::kFloat}};
    prepared.table.rows = truths.front().size();
    for (std::uint64_t row = 0; row < prepared.table.rows; ++row) {
        prepared.table.words.push_back(ToBits(static_cast<float>(row)));
    }
    for (std::size_t c = 0; c < truths.size(); ++c) {
        JudgedColumn column;
        column.name = truths.size() == 1 ? "result" : "result." + std::string(1, "xyz"[c]);
        column.column = c;
        column.accept = accept;
        column.truth.values = truths[c];
        column.truth.errors.assign(truths[c].size(), 0.0);
        prepared.judged.push_back(column);
    }
    return prepared;
}

Gathered ResultsOf(const std::vector<std::vector<float>>& columns) {
    Gathered results(columns.front().size(), columns.size());
    std::vector<std::uint32_t> words;
    for (const std::vector<float>& column : columns) {
        for (const float value : column) {
            words.push_back(ToBits(value));
        }
    }
    results.Take(0, static_cast<std::uint32_t>(columns.front().size()), words);
    return results;
}

ChartAccuracy Measure(const PreparedCase& prepared, const std::vector<std::vector<float>>& results,
                      ErrorMeasure measure = ErrorMeasure::kAbsolute) {
    Errors errors = ErrorsOf(prepared, ResultsOf(results), measure);
    return AccuracyOf(errors);
}

TEST(AccuracyTest, AsComputedByHand) {
    const PreparedCase prepared = CaseOf({{1, 2, -4, kNan, 0}});
    const ChartAccuracy accuracy = Measure(prepared, {{1, 2.5f, -3.75f, 9, 0}});
    EXPECT_EQ(accuracy.rows, 5u);
    EXPECT_EQ(accuracy.judged, 4u);
    EXPECT_EQ(accuracy.undecided, 1u);
    EXPECT_EQ(accuracy.worst, 0.5);
    EXPECT_EQ(accuracy.p999, 0.5);
    EXPECT_DOUBLE_EQ(accuracy.rms, std::sqrt((0.25 + 0.0625) / 4));
    EXPECT_EQ(accuracy.bits, 3);  // half of a truth of at most 4
    EXPECT_EQ(accuracy.not_finite, 0u);
    ASSERT_TRUE(accuracy.shown.has_value());
    EXPECT_EQ(accuracy.shown->inputs[0].second.decimal, "1");
    EXPECT_EQ(accuracy.shown->actual.decimal, "2.5");
    EXPECT_EQ(accuracy.shown->expected->decimal, "2");
}

TEST(AccuracyTest, InItsMeasure) {
    const PreparedCase prepared = CaseOf({{1, 4, -2}});
    const std::vector<std::vector<float>> results = {{1.25f, 4.5f, -2}};
    EXPECT_EQ(Measure(prepared, results).worst, 0.5);
    const ChartAccuracy relative = Measure(prepared, results, ErrorMeasure::kRelative);
    EXPECT_EQ(relative.worst, 0.25);
    EXPECT_EQ(relative.shown->inputs[0].second.decimal, "0");
    EXPECT_EQ(relative.bits, 3);  // of the absolute error whatever the measure
    EXPECT_EQ(Measure(prepared, results, ErrorMeasure::kUlp).worst, 0.25 / 0x1p-24);
    EXPECT_EQ(Measure(CaseOf({{0}}), {{0.5f}}, ErrorMeasure::kRelative).worst, kInfinity);
    EXPECT_EQ(Measure(CaseOf({{0}}), {{0}}, ErrorMeasure::kRelative).worst, 0);
}

TEST(AccuracyTest, ThePercentileLeavesOneInAThousand) {
    std::vector<double> truths(2000, 1.0);
    std::vector<float> results(2000, 1.0f);
    results[7] = 5;
    results[8] = 4;
    results[9] = 3;
    EXPECT_EQ(Measure(CaseOf({truths}), {results}).p999, 2);
    EXPECT_EQ(Measure(CaseOf({truths}), {results}).worst, 4);
    truths.resize(999);
    results.resize(999);
    EXPECT_EQ(Measure(CaseOf({truths}), {results}).p999, 4);  // too few for one to be left
}

TEST(AccuracyTest, TheGreatestComponentCounts) {
    const PreparedCase prepared = CaseOf({{1, kNan, kNan}, {2, 3, kNan}});
    const ChartAccuracy accuracy = Measure(prepared, {{1.5f, 7, 7}, {2.25f, 3, 7}});
    EXPECT_EQ(accuracy.judged, 2u);
    EXPECT_EQ(accuracy.undecided, 1u);
    EXPECT_EQ(accuracy.worst, 0.5);
    EXPECT_EQ(accuracy.shown->output, "result.x");
    EXPECT_DOUBLE_EQ(accuracy.rms, std::sqrt(0.25 / 2));
}

TEST(AccuracyTest, WhatIsNotFiniteIsCountedAndInfinitelyWrong) {
    const PreparedCase prepared = CaseOf({{1, 1, kInfinity}});
    const float infinity = std::numeric_limits<float>::infinity();
    const ChartAccuracy accuracy =
        Measure(prepared, {{std::nanf(""), infinity, infinity}}, ErrorMeasure::kRelative);
    EXPECT_EQ(accuracy.not_finite, 2u);
    EXPECT_EQ(accuracy.worst, kInfinity);
    EXPECT_EQ(accuracy.rms, kInfinity);
    EXPECT_EQ(accuracy.bits, -kInfinity);
}

TEST(AccuracyTest, WhatIsExactHasAllBits) {
    EXPECT_EQ(Measure(CaseOf({{1, 2}}), {{1, 2}}).bits, kInfinity);
    EXPECT_TRUE(std::isnan(Measure(CaseOf({{kNan}}), {{1}}).worst));
}

TEST(AccuracyTest, AnOracleWithoutABoundIsUndecided) {
    PreparedCase prepared = CaseOf({{1, 1}});
    prepared.judged[0].truth.errors[0] = kInfinity;
    const ChartAccuracy accuracy = Measure(prepared, {{5, 2}});
    EXPECT_EQ(accuracy.undecided, 1u);
    EXPECT_EQ(accuracy.worst, 1);
}

Acceptance Search(double missed, double wrong) {
    Acceptance accept;
    accept.absolute = 1e-6;
    accept.shares = Shares{missed, wrong, 0.5};
    return accept;
}

TEST(AccuracyTest, ASearchHasErrorsOfItsRightHitsAlone) {
    //                      right  right  missed  phantom other  none  undecided NaN
    const std::vector<double> truths = {0.25, 0.5, 0.5, -1, 4, -1, kNan, 1};
    const std::vector<float> results = {0.25f, 0.75f, -1, 0.5f, 1, -2, 3, std::nanf("")};
    const PreparedCase prepared = CaseOf({truths}, Search(0.2, 0.5));
    Errors errors = ErrorsOf(prepared, ResultsOf({results}), ErrorMeasure::kAbsolute);
    EXPECT_TRUE(errors.shares_held);
    const ChartAccuracy accuracy = AccuracyOf(errors);
    EXPECT_EQ(accuracy.judged, 7u);
    EXPECT_EQ(accuracy.worst, 0.25);
    EXPECT_DOUBLE_EQ(accuracy.rms, std::sqrt(0.0625 / 2));
    EXPECT_EQ(accuracy.bits, 1);
    EXPECT_EQ(accuracy.missed, 1.0 / 5);
    EXPECT_EQ(accuracy.wrong, 3.0 / 7);
    EXPECT_EQ(accuracy.not_finite, 1u);
    EXPECT_EQ(accuracy.shown->inputs[0].second.decimal, "3");  // the first wrong one
    const PreparedCase strict = CaseOf({truths}, Search(0.19, 0.5));
    EXPECT_FALSE(ErrorsOf(strict, ResultsOf({results}), ErrorMeasure::kAbsolute).shares_held);
    const PreparedCase stricter = CaseOf({truths}, Search(0.2, 0.4));
    EXPECT_FALSE(ErrorsOf(stricter, ResultsOf({results}), ErrorMeasure::kAbsolute).shares_held);
}

TEST(AccuracyTest, ScenesArePooled) {
    const PreparedCase first = CaseOf({{1, 1, 1}});
    const PreparedCase second = CaseOf({{8}});
    Errors errors = ErrorsOf(first, ResultsOf({{1.5f, 1, 1}}), ErrorMeasure::kAbsolute);
    errors.shown_scene = "first";
    Errors other = ErrorsOf(second, ResultsOf({{6}}), ErrorMeasure::kAbsolute);
    other.shown_scene = "second";
    errors.Add(other);
    EXPECT_EQ(errors.shown_scene, "second");
    const ChartAccuracy accuracy = AccuracyOf(errors);
    EXPECT_EQ(accuracy.rows, 4u);
    EXPECT_EQ(accuracy.worst, 2);
    EXPECT_DOUBLE_EQ(accuracy.rms, std::sqrt((0.25 + 4) / 4));  // not the mean of two
    EXPECT_EQ(accuracy.bits, 2);
}

TEST(AccuracyTest, AWrongHitOfAnySceneIsShown) {
    const auto errors_of = [](double truth, float result, const char* scene) {
        Errors errors = ErrorsOf(CaseOf({{truth}}, Search(0, 0)), ResultsOf({{result}}),
                                 ErrorMeasure::kAbsolute);
        errors.shown_scene = scene;
        return errors;
    };
    const Errors right = errors_of(0.5, 0.75f, "right");
    const Errors missed = errors_of(0.5, -1, "missed");
    const Errors wrong = errors_of(5, 1, "wrong");
    for (const auto& [first, second, third, shown] :
         {std::tuple(right, missed, wrong, "wrong"), std::tuple(wrong, missed, right, "wrong"),
          std::tuple(missed, right, right, "missed"), std::tuple(right, right, missed, "missed")}) {
        Errors all;
        all.Add(first);
        all.Add(second);
        all.Add(third);
        EXPECT_EQ(all.shown_scene, shown);
        EXPECT_FALSE(all.shares_held);
    }
}

TEST(AccuracyTest, WhatIsRefusedIsCounted) {
    Acceptance accept;
    accept.absolute = 0.1;
    Errors errors = ErrorsOf(CaseOf({{1, 1, 1}}, accept), ResultsOf({{1, 1.05f, 1.5f}}),
                             ErrorMeasure::kAbsolute);
    EXPECT_EQ(errors.refused, 1u);
}

}  // namespace
}  // namespace etalon
