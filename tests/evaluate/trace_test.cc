// A row, operation by operation: what stands in each step, and that the way is that of binary32.
#include "evaluate/trace.h"

#include <gmock/gmock.h>
#include <spirv/unified1/GLSL.std.450.h>

#include <cmath>

#include "evaluate/probed.h"

namespace etalon::evaluate {
namespace {

using testing::DoubleNear;

Trace TraceOf(const Probed& probed, const std::vector<float>& inputs) {
    EXPECT_EQ(probed.error(), "");
    std::vector<std::uint32_t> words;
    for (const float x : inputs) {
        words.push_back(std::bit_cast<std::uint32_t>(x));
    }
    Result<Trace> trace = TraceRow(probed.plan(), {}, words, probed.program().output_words);
    EXPECT_TRUE(trace.ok()) << trace.error().message;
    // Whatever it tells beside, it is the evaluator's strict result.
    std::vector<std::vector<float>> columns;
    for (const float x : inputs) {
        columns.push_back({x});
    }
    std::vector<std::vector<std::uint32_t>> rows;
    for (const std::uint32_t word : words) {
        rows.push_back({word});
    }
    const auto strict = probed.Words<float>(rows);
    EXPECT_TRUE(strict.ok());
    EXPECT_EQ(trace->outputs, *strict);
    return *trace;
}

TEST(Trace, TellsTheStepsOfADifference) {
    const Probed probed("float f(float r, float a) { return r - sqrt(r * r - a * a); }\n",
                        "f(r, a)", {"float r", "float a"});
    const float a = 0x1.a1d89ap-4f;
    const Trace trace = TraceOf(probed, {50, a});
    ASSERT_EQ(trace.steps.size(), 5u);
    const std::vector<spv::Op> ops = {spv::Op::OpFMul, spv::Op::OpFMul, spv::Op::OpFSub,
                                      spv::Op::OpExtInst, spv::Op::OpFSub};
    for (std::size_t i = 0; i < ops.size(); ++i) {
        EXPECT_EQ(trace.steps[i].instruction->op, ops[i]) << i;
        ASSERT_EQ(trace.steps[i].numbers.size(), 1u);
    }
    EXPECT_EQ(trace.steps[1].numbers[0].value, a * a);
    const double square = double{a} * a;  // exact in binary64
    EXPECT_EQ(trace.steps[1].numbers[0].exact.ToDouble(), square);
    EXPECT_EQ(trace.steps[2].operands[0][0].origin, (Origin{0, 0}));
    EXPECT_EQ(trace.steps[2].operands[1][0].origin, (Origin{1, 0}));
    const TracedNumber& last = trace.steps[4].numbers[0];
    EXPECT_EQ(last.value, 50 - trace.steps[3].numbers[0].value);
    EXPECT_EQ(last.exact.ToDouble(), trace.exact[0].ToDouble());
    const long double exact = 50 - std::sqrt(2500 - static_cast<long double>(square));
    EXPECT_NEAR(last.exact.ToDouble() / static_cast<double>(exact), 1, 1e-12);
    // (50 + 49.9999) / 0.000104
    EXPECT_NEAR(last.amplification * last.exact.ToDouble(), 100, 0.01);
    EXPECT_THAT(trace.steps[0].numbers[0].amplification, DoubleNear(2, 1e-6));
    EXPECT_THAT(trace.steps[3].numbers[0].amplification, DoubleNear(0.5, 1e-6));
    EXPECT_EQ(last.from, (std::vector<Origin>{{3, 0}}));
    EXPECT_EQ(trace.origins[0], (Origin{4, 0}));
}

// x + 1 - 1 loses what the branch asks for.
TEST(Trace, GoesTheWayOfBinary32) {
    const Probed probed(
        "float f(float x) { float y = (x + 1.0) - 1.0;\n"
        "  if (y > 0.0) { return 2.0 * x; }\n"
        "  return 3.0 * x; }\n",
        "f(x)", {"float x"});
    const Trace trace = TraceOf(probed, {0x1p-30f});
    ASSERT_EQ(trace.steps.size(), 4u);
    ASSERT_EQ(trace.steps[2].words.size(), 1u);
    EXPECT_EQ(trace.steps[2].words[0].value, 0u);
    EXPECT_EQ(trace.steps[2].words[0].exact, 1u);
    EXPECT_EQ(trace.steps[1].numbers[0].exact.ToDouble(), 0x1p-30);
    EXPECT_EQ(trace.exact[0].ToDouble(), 3 * 0x1p-30);
    ASSERT_NE(trace.steps[1].stored, nullptr);
    EXPECT_EQ(trace.steps[1].stored->op, spv::Op::OpStore);
}

TEST(Trace, FollowsNumbersThroughVariablesLoopsAndCalls) {
    const Probed probed(
        "void twice(inout vec3 v) { v = v + v; }\n"
        "float f(float x) { vec3 all[2]; all[0] = vec3(x); all[1] = vec3(0.0);\n"
        "  for (int i = 0; i < 3; ++i) { twice(all[i & 1]); }\n"
        "  mat2 m = mat2(all[0].x, all[0].y, all[1].x, 1.0);\n"
        "  return transpose(m)[0].x; }\n",
        "f(x)", {"float x"});
    const Trace trace = TraceOf(probed, {3});
    ASSERT_EQ(trace.steps.size(), 3u);
    EXPECT_EQ(trace.origins[0], (Origin{2, 0}));
    EXPECT_EQ(trace.steps[2].operands[0][0].origin, (Origin{0, 0}));
    EXPECT_EQ(trace.steps[1].operands[0][0].origin, Origin{});
    EXPECT_EQ(trace.exact[0].ToDouble(), 12);
}

TEST(Trace, TakesTheChosenOneOfTwoAsTheSource) {
    const Probed probed(
        "float f(float x) { return max(x * 3.0, x * 5.0) + (x > 9.0 ? x : 0.0); }\n", "f(x)",
        {"float x"});
    const Trace trace = TraceOf(probed, {2});
    ASSERT_EQ(trace.steps.size(), 5u);
    EXPECT_EQ(trace.steps[2].numbers[0].from, (std::vector<Origin>{{1, 0}}));
}

TEST(Trace, KeepsANumberThatIsMovedByItsBits) {
    const Probed probed(
        "float f(float x) { float third = x / 3.0;\n"
        "  int bits = min(floatBitsToInt(third), 0x7f7fffff);\n"
        "  return intBitsToFloat(bits) - x; }\n",
        "f(x)", {"float x"});
    const Trace trace = TraceOf(probed, {1});
    ASSERT_EQ(trace.steps.size(), 2u);
    EXPECT_EQ(trace.steps[1].operands[0][0].origin, (Origin{0, 0}));
    EXPECT_NEAR(trace.exact[0].ToDouble(), -2.0 / 3, 1e-15);
}

TEST(Trace, LeadsIntegersAndExponents) {
    const Probed probed(
        "float f(float x) { int e; float s = frexp(x * 1.1, e); float whole;\n"
        "  float part = modf(x * 1.1, whole);\n"
        "  return ldexp(s, e) + part + float(int(whole)); }\n",
        "f(x)", {"float x"});
    const Trace trace = TraceOf(probed, {7.5});
    const double product = 7.5 * double{1.1f};
    EXPECT_NEAR(trace.exact[0].ToDouble(), 2 * product, 1e-14);
}

TEST(Trace, FailsAsTheEvaluatorDoes) {
    const Probed endless("float f(float x) { while (x > 0.0) { x += 1.0; } return x; }\n", "f(x)",
                         {"float x"});
    const std::uint32_t one = 0x3f800000;
    Limits limits;
    limits.steps = 100;
    const Result<Trace> trace = TraceRow(endless.plan(), {}, {&one, 1}, 1, limits);
    ASSERT_FALSE(trace.ok());
    EXPECT_THAT(trace.error().message,
                testing::HasSubstr("in f: a loop does not end within 100 steps"));
}

TEST(Trace, IsCutWhereThePathIsTooLong) {
    const Probed probed(
        "float f(float x) { for (int i = 0; i < 200000; ++i) { x += 1.0; } return x; }\n", "f(x)",
        {"float x"});
    const Trace trace = TraceOf(probed, {0});
    EXPECT_TRUE(trace.is_cut);
    EXPECT_EQ(trace.steps.size(), kMostTraced);
    EXPECT_EQ(std::bit_cast<float>(trace.outputs[0]), 200000.0f);
}

}  // namespace
}  // namespace etalon::evaluate
