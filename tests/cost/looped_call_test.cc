#include "cost/looped_call.h"

#include <gmock/gmock.h>

#include "cost/subject.h"
#include "evaluate/evaluate.h"
#include "spirv/read.h"

namespace etalon {
namespace {

class LoopedCallTest : public testing::Test {
  protected:
    // The words of the loop's outputs at the subject's first row, by the host.
    std::vector<std::uint32_t> Run(const PreparedCase& subject, unsigned slots, unsigned calls,
                                   std::uint32_t turns) {
        const auto looped = LoopCall(subject, folder_.path() / "loop.glsl", slots, calls);
        EXPECT_TRUE(looped) << looped.error().message;
        const auto program = Compile(looped->call, looped->signature, Recipe{}, Target{}, {});
        EXPECT_TRUE(program) << program.error().reason;
        auto plan = evaluate::MakePlan(*spirv::ReadModule(program->spirv));
        EXPECT_TRUE(plan);
        std::vector<std::uint32_t> inputs;
        for (std::size_t column = 0; column < subject.table.columns.size(); ++column) {
            inputs.push_back(subject.table.At(0, column));
        }
        inputs.push_back(turns);
        std::vector<std::uint32_t> outputs(program->output_words);
        EXPECT_TRUE(evaluate::Evaluator<float>(*plan, {}).Run({1, inputs, outputs}));
        EXPECT_EQ(outputs[looped->done_column], turns);
        return outputs;
    }
    float Sum(const PreparedCase& subject, unsigned slots, unsigned calls, std::uint32_t turns) {
        return std::bit_cast<float>(Run(subject, slots, calls, turns)[0]);
    }

    Folder folder_;
};

TEST_F(LoopedCallTest, YieldsTheLastSlot) {
    const PreparedCase subject =
        SubjectOf(folder_, "f", {"float f(float x) { return 16.0 * x; }", "f(x)", {0.25f}});
    EXPECT_EQ(Sum(subject, 1, 1, 8), 4);
    EXPECT_EQ(Sum(subject, 1, 0, 8), 0.25f);
    EXPECT_EQ(Sum(subject, 4, 4, 8), 4);
    EXPECT_EQ(Sum(subject, 4, 3, 8), 0.25f);
}

TEST_F(LoopedCallTest, TakesEveryTypeAndEveryOutput) {
    SubjectText text{
        "struct Pair { vec2 v; bool b; };\n"
        "Pair f(float x, int n, bool b, out uint u)\n"
        "{ u = uint(n) + 1u; return Pair(vec2(x, 2.0 * x), !b); }\n",
        "f(x, n, b, u)"};
    text.arguments = {{"x", "float", true, false},
                      {"n", "int", true, false},
                      {"b", "bool", true, false},
                      {"u", "uint", false, true}};
    text.columns = {{std::bit_cast<std::uint32_t>(0.5f)}, {3}, {0}};
    const PreparedCase subject = SubjectOf(folder_, "f", text);
    EXPECT_EQ(Sum(subject, 2, 2, 5), 0.5f + 1 + 1 + 4);
}

TEST_F(LoopedCallTest, TakesUniformsAndInouts) {
    SubjectText text{"uniform float level;\nvoid f(inout float x) { x += level; }", "f(x)"};
    text.arguments = {{"x", "float", true, true}, {"level", "float", true, false}};
    text.columns = {{std::bit_cast<std::uint32_t>(0.5f)}, {std::bit_cast<std::uint32_t>(2.0f)}};
    const PreparedCase subject = SubjectOf(folder_, "f", text);
    // Each turn begins with the row's own inputs.
    EXPECT_EQ(Sum(subject, 1, 1, 4), 2.5f);
}

TEST_F(LoopedCallTest, StandsAfterWhatItCalls) {
    PreparedCase subject;
    subject.call.source = folder_.Write(
        "f.glsl", "float solid_height(float x);\nfloat f(float x) { return solid_height(x); }\n");
    subject.call.with = {folder_.Write(
        "scene.glsl", "const float kLevel = 2.0;\nfloat solid_height(float x) { return kLevel; }")};
    subject.call.arguments = {{"x", "float", true, false}};
    subject.call.wanted = {{"result", "f(x)", "CALL"}};
    subject.signature = *Inspect(subject.call);
    subject.table.columns = {{"x"}};
    subject.table.words = {std::bit_cast<std::uint32_t>(1.0f)};
    subject.table.rows = 1;
    EXPECT_EQ(Sum(subject, 1, 1, 3), 2);
    // Where the source needs what comes with it.
    subject.call.source = folder_.Write("g.glsl", "float f(float x) { return kLevel * x; }\n");
    subject.signature = *Inspect(subject.call);
    EXPECT_TRUE(subject.signature.dialect.with_first);
    EXPECT_EQ(Sum(subject, 1, 1, 3), 2);
}

}  // namespace
}  // namespace etalon
