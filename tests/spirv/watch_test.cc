// What is watched, and that a watched module is one. That it tells the truth: tests/run/parting.
#include "spirv/watch.h"

#include <gmock/gmock.h>

#include "compile/spirv.h"
#include "evaluate/probed.h"
#include "spirv/read.h"

namespace etalon::spirv {
namespace {

constexpr const char* kSource =
    "struct S { float a; int n; vec2 v; };\n"
    "float f(float x) { S s; s.a = x * x; s.n = int(x); s.v = vec2(x) + x; mat2 m = mat2(x) * x;\n"
    "  bvec2 less = lessThan(s.v, m[0]); bool any_less = any(less); uint u = uint(x);\n"
    "  return any_less ? s.a : float(s.n) + float(u); }\n";

TEST(Watchable, IsWhatComputesWithNumbers) {
    const Probed probed(kSource, "f(x)", {"float x"});
    ASSERT_EQ(probed.error(), "");
    const Module& module = probed.plan()->module;
    std::vector<std::string> ops;
    for (const Function& function : module.functions) {
        for (const Block& block : function.blocks) {
            for (const Instruction& instruction : block.instructions) {
                if (IsWatchable(module, instruction)) {
                    ops.push_back(OpName(instruction.op));
                }
            }
        }
    }
    EXPECT_THAT(ops, testing::ElementsAre("OpFMul", "OpConvertFToS", "OpFAdd",
                                          "OpMatrixTimesScalar", "OpFOrdLessThan", "OpConvertFToU",
                                          "OpConvertSToF", "OpConvertUToF", "OpFAdd"));
    EXPECT_EQ(Watchable(module).size(), ops.size());
}

TEST(Watch, YieldsAValidModuleForEachClient) {
    const Probed probed(kSource, "f(x)", {"float x"});
    ASSERT_EQ(probed.error(), "");
    const Module& module = probed.plan()->module;
    const std::size_t count = Watchable(module).size();
    for (std::uint32_t i = 0; i <= count; ++i) {
        // Each alone; at last none.
        std::vector<std::uint32_t> chosen;
        if (i < count) {
            chosen.push_back(i);
        }
        const auto watched = Watch(probed.program().spirv, module, {1, 100}, chosen);
        ASSERT_TRUE(watched.ok()) << watched.error().message;
        const Status<> valid = ValidateSpirv(*watched, Target{});
        EXPECT_TRUE(valid.ok()) << i << ": " << valid.error().message;
        EXPECT_TRUE(ReadModule(*watched).ok());
    }
}

TEST(Watch, StaysWithinItsPlace) {
    const Probed probed(
        "float f(float x) { for (int i = 0; i < 50; ++i) { x += 1.0; } return x; }\n", "f(x)",
        {"float x"});
    ASSERT_EQ(probed.error(), "");
    const WatchPlace place{1, 4};
    const std::uint32_t first = 0;
    const auto watched = Watch(probed.program().spirv, probed.plan()->module, place, {&first, 1});
    ASSERT_TRUE(watched.ok());
    Result<Module> module = ReadModule(*watched);
    ASSERT_TRUE(module.ok()) << module.error().message;
    std::vector<std::uint32_t> outputs(1 + place.Words());
    const std::uint32_t input = 0;
    evaluate::Evaluator<float> evaluator(*evaluate::MakePlan(std::move(*module)), {});
    // The evaluator refuses what is outside of the buffer.
    const Status<> done = evaluator.Run({1, {&input, 1}, outputs});
    ASSERT_TRUE(done.ok()) << done.error().message;
    EXPECT_EQ(std::bit_cast<float>(outputs[0]), 50.0f);
    EXPECT_EQ(outputs[1], 50u);
    EXPECT_EQ(std::bit_cast<float>(outputs[3]), 1.0f);
    EXPECT_EQ(std::bit_cast<float>(outputs[9]), 4.0f);
}

TEST(Watch, NeedsOutputs) {
    const Probed probed("float f(float x) { return x + 1.0; }\n", "f(x)", {"float x"});
    std::vector<std::uint32_t> words = probed.program().spirv;
    for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
        if (words[at] == (static_cast<std::uint32_t>(spv::Op::OpDecorate) | 4u << 16) &&
            words[at + 2] == static_cast<std::uint32_t>(spv::Decoration::Binding)) {
            words[at + 3] = 7;
        }
    }
    const std::uint32_t first = 0;
    const auto watched = Watch(words, probed.plan()->module, {1, 4}, {&first, 1});
    ASSERT_FALSE(watched.ok());
    EXPECT_EQ(watched.error().message, "the module has no outputs at binding 1");
}

}  // namespace
}  // namespace etalon::spirv
