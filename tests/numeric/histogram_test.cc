#include "numeric/histogram.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "numeric/acceptance.h"
#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kLast = UlpHistogram::kBins - 1;

TEST(UlpHistogram, BinsReachUpToTheirBoundAndNotBeyond) {
    EXPECT_EQ(UlpHistogram::BinOf(0), 0u);
    EXPECT_EQ(UlpHistogram::BinOf(kInfinity), kLast);
    EXPECT_EQ(UlpHistogram::BinOf(std::numeric_limits<double>::quiet_NaN()), kLast);
    EXPECT_EQ(UlpHistogram::BinOf(std::numeric_limits<double>::denorm_min()), 1u);
    EXPECT_EQ(UlpHistogram::BinOf(0x1p277), kLast - 1);
    for (std::size_t bin = 1; bin < kLast - 1; ++bin) {
        const double upper = UlpHistogram::Upper(bin);
        EXPECT_EQ(UlpHistogram::BinOf(upper), bin) << upper;
        EXPECT_EQ(UlpHistogram::BinOf(std::nextafter(upper, kInfinity)), bin + 1) << upper;
        EXPECT_EQ(UlpHistogram::BinOf(std::nextafter(upper, 0)), bin) << upper;
    }
    EXPECT_EQ(UlpHistogram::Upper(0), 0);
    EXPECT_EQ(UlpHistogram::Upper(1), 0x1p-6);
    EXPECT_EQ(UlpHistogram::Upper(kLast - 2), 0x1p24);
    EXPECT_EQ(UlpHistogram::Upper(kLast - 1), kInfinity);
}

TEST(UlpHistogram, Adds) {
    UlpHistogram a;
    a.Add(0);
    a.Add(0.5);
    UlpHistogram b;
    b.Add(0.5);
    b.Add(kInfinity);
    a.Add(b);
    EXPECT_EQ(a.Total(), 4u);
    EXPECT_EQ(a.counts()[0], 1u);
    EXPECT_EQ(a.counts()[UlpHistogram::BinOf(0.5)], 2u);
    EXPECT_EQ(a.counts()[kLast], 1u);
}

// The fast door counts what Judge says of each value by itself: of ordinary values, of refused and
// special ones, and of what is left over at the end.
TEST(UlpHistogram, CountsWhatJudgeSays) {
    for (const auto ulp : {std::optional<double>(1e9), std::optional<double>(2), {}}) {
        Acceptance rule;
        rule.ulp = ulp;
        std::vector<float> values;
        std::vector<double> truths;
        for (std::uint64_t k = 0; k < 5001; ++k) {
            const double truth = Uniform(1, k) * std::ldexp(1.0, static_cast<int>(k % 300) - 150);
            const double error = std::ldexp(Uniform(2, k), static_cast<int>(k % 13) - 8);
            truths.push_back(truth);
            values.push_back(static_cast<float>(truth + error * Ulp(truth)));
            if (k > 2500 && k % 97 == 0) {
                values.back() = std::numeric_limits<float>::quiet_NaN();
            }
        }
        UlpHistogram expected;
        for (std::size_t k = 0; k < values.size(); ++k) {
            expected.Add(Judge(rule, values[k], truths[k], 0).ulp_error);
        }
        Summary plain;
        JudgeAll(rule, values, truths, 0, 0, 0, plain);
        Summary summary;
        UlpHistogram histogram;
        JudgeAll(rule, values, truths, 0, 0, 0, summary, &histogram);
        EXPECT_EQ(histogram.counts(), expected.counts());
        EXPECT_EQ(summary, plain);
        const std::vector<double> errors(truths.size(), 0);
        UlpHistogram by_rows;
        JudgeAll(rule, values, truths, errors, 0, summary, &by_rows);
        EXPECT_EQ(by_rows.counts(), expected.counts());
    }
}

// Whatever the parts and their order, the whole is the same; of equal errors the first counts.
TEST(Summary, PartsAddUpToTheWhole) {
    Acceptance rule;
    rule.ulp = 1;
    constexpr std::size_t kRows = 600;
    Summary whole;
    Summary parts[3];
    for (std::size_t k = 0; k < kRows; ++k) {
        // Errors of 0 to 3 ulp, each many times over.
        const float value = FromBits(ToBits(1.5f) + static_cast<std::uint32_t>(k / 5 % 4));
        const Judgement judgement = Judge(rule, value, 1.5, 0);
        whole.Add(k, judgement);
        parts[k * 3 / kRows].Add(k, judgement);
    }
    EXPECT_EQ(whole.worst_ulp_at, 15u);
    EXPECT_EQ(whole.first_refused, 10u);
    const int orders[][3] = {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}};
    for (const auto& order : orders) {
        Summary sum;
        for (const int part : order) {
            sum.Add(parts[part]);
        }
        EXPECT_EQ(sum, whole);
    }
    Summary none;
    none.Add(Summary());
    EXPECT_EQ(none, Summary());
}

}  // namespace
}  // namespace etalon
