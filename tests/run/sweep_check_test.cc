#include "run/sweep_check.h"

#include <gmock/gmock.h>

#include <cmath>

#include "numeric/ulp.h"
#include "support/folder.h"

namespace etalon {
namespace {

class SweepCheckTest : public testing::Test {
  protected:
    // Of a case whose function is never run: the test makes up its results.
    SweepPlan Plan(const std::string& oracle, const std::string& accept,
                   const std::string& type = "float", const SweepScope& scope = {}) {
        folder_.Write("f.glsl", type + " f(float n, float x) { return " + type + "(x); }\n");
        folder_.Write("cases/c.toml", "source = \"f.glsl\"\ncall = \"f(n, x)\"\noracle = \"" +
                                          oracle + "\"\naccept = " + accept +
                                          "\n[domain]\nn = { values = [1.5, 1.25] }\n"
                                          "x = { range = [-1.0, 1.0], count = 9 }\n");
        auto plan = PlanSweep(*ReadCase(folder_.path(), "c"), scope);
        EXPECT_TRUE(plan) << plan.error().message;
        return *plan;
    }

    static SweepBlock Block(std::uint64_t setting, float first, std::uint32_t rows) {
        return {setting, 1000, OrderedBits(first), rows};
    }

    static std::vector<std::uint32_t> Floats(const SweepBlock& block) {
        std::vector<std::uint32_t> floats(block.rows);
        FillFloats(block.first_float, floats);
        return floats;
    }

    // The oracle in its general form.
    static std::vector<Expression::Value> Truths(const SweepPlan& plan, const SweepBlock& block,
                                                 const std::vector<std::uint32_t>& floats,
                                                 bool flush) {
        const std::vector<double> n(floats.size(), FromBits(plan.settings.At(block.setting, 0)));
        std::vector<double> x;
        for (const std::uint32_t word : floats) {
            x.push_back(flush ? Flush(FromBits(word)) : FromBits(word));
        }
        const double* const inputs[] = {n.data(), x.data()};
        std::vector<Expression::Value> values;
        plan.oracles[0].expression.Evaluate(inputs, floats.size(), values);
        return values;
    }

    // Judges each value by itself, and its truth by the general form.
    static SweptColumn OneByOne(const SweepPlan& plan, const SweepBlock& block,
                                std::span<const std::uint32_t> words) {
        SweptColumn column;
        const JudgedColumn& output = plan.oracles[0].outputs[0];
        const std::vector<std::uint32_t> floats = Floats(block);
        const auto plain = Truths(plan, block, floats, false);
        const auto flushed = Truths(plan, block, floats, true);
        for (std::uint32_t row = 0; row < block.rows; ++row) {
            Truth truth;
            truth.values = {plain[row].value};
            truth.errors = {plain[row].error};
            if (FromBits(floats[row]) != Flush(FromBits(floats[row]))) {
                truth.alternatives = {{0, flushed[row].value, flushed[row].error}};
            }
            const Judgement judgement =
                JudgeValue(output.accept, output.scalar, words[row], truth, 0);
            column.summary.Add(block.first_row + row, judgement);
            column.histogram.Add(judgement.ulp_error);
        }
        return column;
    }

    static void ExpectSame(const SweptColumn& found, const SweptColumn& expected) {
        EXPECT_EQ(found.summary.judged, expected.summary.judged);
        EXPECT_EQ(found.summary.refused, expected.summary.refused);
        EXPECT_EQ(found.summary.first_refused, expected.summary.first_refused);
        EXPECT_EQ(found.summary.worst_ulp_at, expected.summary.worst_ulp_at);
        EXPECT_EQ(found.summary.worst_used_at, expected.summary.worst_used_at);
        EXPECT_EQ(found.histogram.counts(), expected.histogram.counts());
    }

    Folder folder_;
};

TEST(FillFloats, GoesThroughBothZeros) {
    std::vector<std::uint32_t> words(5);
    FillFloats(OrderedBits(-0.0f) - 1, words);
    EXPECT_THAT(words, testing::ElementsAre(0x80000001u, 0x80000000u, 0u, 1u, 2u));
}

// An oracle by its name and an expression, at ordinary floats and across the subnormals and zeros,
// of results that are right but for some: what is found is what each value yields by itself, on any
// number of threads.
TEST_F(SweepCheckTest, FindsWhatEachValueYields) {
    for (const char* oracle : {"fresnel.reflectance(1, n, x)", "sqrt(x * x + n)"}) {
        const SweepPlan plan = Plan(oracle, "{ ulp = 3 }", "float", {.from = "-0.001"});
        for (const float first : {0.25f, FromBits(0x007fe000u), -0x1p-140f}) {
            const SweepBlock block = Block(1, first, 70'001);
            const std::vector<std::uint32_t> floats = Floats(block);
            std::vector<std::uint32_t> words;
            for (const Expression::Value& truth : Truths(plan, block, floats, false)) {
                words.push_back(ToBits(static_cast<float>(truth.value)) +
                                static_cast<std::uint32_t>(words.size()) * 7919 % 4);
            }
            words[40'000] += 9;
            words[60'000] += 9;
            const SweptColumn expected = OneByOne(plan, block, words);
            EXPECT_GE(expected.summary.refused, 2u);
            for (const unsigned threads : {1u, 2u, 5u}) {
                const auto found = CheckBlock(plan, block, words, threads);
                ASSERT_EQ(found.size(), 1u);
                ExpectSame(found[0], expected);
                ASSERT_TRUE(found[0].worst_ulp);
                const std::uint64_t row = found[0].worst_ulp->row - block.first_row;
                EXPECT_EQ(found[0].worst_ulp->inputs[1], floats[row]);
                EXPECT_EQ(found[0].worst_ulp->actual, words[row]);
            }
        }
    }
}

TEST_F(SweepCheckTest, JudgesIntegersAndNaNs) {
    const SweepPlan ints = Plan("floor(x)", "{ exact = true }", "int");
    const SweepBlock block = Block(0, 0.5f, 3000);
    std::vector<std::uint32_t> words(block.rows, 0);
    words[1234] = 1;
    const auto found = CheckBlock(ints, block, words, 2);
    EXPECT_EQ(found[0].summary.refused, 1u);
    EXPECT_EQ(found[0].first_refused->row, 1000 + 1234u);
    EXPECT_EQ(found[0].first_refused->inputs[1], ToBits(0.5f) + 1234);
    EXPECT_EQ(found[0].histogram.counts().back(), 1u);
    ExpectSame(found[0], OneByOne(ints, block, words));

    const SweepPlan floats = Plan("fresnel.reflectance(1, n, x)", "{ ulp = 1e6 }");
    words.assign(block.rows, ToBits(0.04f));
    words[2047] = words[2500] = 0x7fc00000u;
    const auto with_nan = CheckBlock(floats, block, words, 1);
    EXPECT_EQ(with_nan[0].summary.worst_ulp_at, 1000 + 2047u);
    EXPECT_EQ(with_nan[0].histogram.counts().back(), 2u);
    ExpectSame(with_nan[0], OneByOne(floats, block, words));
}

}  // namespace
}  // namespace etalon
