// Devices that part from the strict reading in known ways: the evaluator, with a module that has
// been changed after it was given to the device.
#include "run/parting.h"

#include <gmock/gmock.h>

#include <bit>

#include "compile/compile.h"
#include "evaluate/evaluate.h"
#include "evaluate/probed.h"
#include "spirv/read.h"
#include "spirv/watch.h"

namespace etalon {
namespace {

using Kind = Parting::Kind;
using Words = std::vector<std::uint32_t>;
// Changes the words of a program, as a faulty compiler would.
using Fault = std::function<void(Words&)>;

constexpr const char* kSource =
    "float f(float x) { float a = x * x; float b = a + 3.0; vec2 v = vec2(b, x) * 0.7;\n"
    "  for (int i = 0; i < 3; ++i) { v.x = v.x - v.y; }\n"
    "  if (v.x < 2.0) { return exp(v.x); }\n"
    "  return sqrt(v.x) / v.y; }\n";

class PartingTest : public testing::Test {
  protected:
    PartingTest()
        : probed_(kSource, "f(x)", {"float x"}), input_{std::bit_cast<std::uint32_t>(4.2f)} {
        EXPECT_EQ(probed_.error(), "");
        trace_ = *evaluate::TraceRow(probed_.plan(), {}, input_, probed_.program().output_words);
    }

    Words Run(const Program& program) const {
        Result<spirv::Module> module = spirv::ReadModule(program.spirv);
        EXPECT_TRUE(module.ok()) << module.error().message;
        Words outputs(program.output_words);
        evaluate::Evaluator<float> evaluator(*evaluate::MakePlan(std::move(*module)), {});
        const Status<> done = evaluator.Run({1, input_, outputs});
        EXPECT_TRUE(done.ok()) << done.error().message;
        return outputs;
    }
    // Of a device with that fault, in watched programs too.
    Parting PartingOf(const Fault& fault) const {
        const auto faulty = [&](Program program) {
            fault(program.spirv);
            return Run(program);
        };
        return FindParting(probed_.program(), probed_.plan()->module, trace_,
                           faulty(probed_.program()),
                           [&](const Program& program) -> Result<Words, EvaluationFailure> {
                               ++runs_;
                               return faulty(program);
                           });
    }

    // Replaces the operation of its n-th occurrence.
    static void Replace(Words& words, spv::Op from, spv::Op to, int occurrence = 0) {
        for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
            if (static_cast<spv::Op>(words[at] & 0xffffu) == from && occurrence-- == 0) {
                words[at] = (words[at] & 0xffff0000u) | static_cast<std::uint32_t>(to);
                return;
            }
        }
        FAIL() << "no such instruction";
    }
    // How many leaves a program tells.
    std::size_t Told(const Words& words) const {
        const auto calls = [](const Words& in) {
            constexpr auto kCall = static_cast<std::uint32_t>(spv::Op::OpFunctionCall) | 6u << 16;
            return static_cast<std::size_t>(std::count(in.begin(), in.end(), kCall));
        };
        return calls(words) - calls(probed_.program().spirv);
    }

    Probed probed_;
    Words input_;
    evaluate::Trace trace_;
    mutable int runs_ = 0;
};

TEST_F(PartingTest, AStrictDevicePartsNowhere) {
    const Parting parting = PartingOf([](Words&) {});
    EXPECT_EQ(parting.kind, Kind::kNowhere);
    EXPECT_EQ(runs_, 1);
}

TEST_F(PartingTest, TheFirstOperationThatDiffersIsNamed) {
    // a, b, v.x, v.y, then three differences
    const Parting product =
        PartingOf([](Words& w) { Replace(w, spv::Op::OpFMul, spv::Op::OpFAdd); });
    EXPECT_EQ(product.kind, Kind::kOperation);
    EXPECT_EQ(product.step, 0u);
    EXPECT_EQ(std::bit_cast<float>(product.word), 4.2f + 4.2f);
    const Parting sum = PartingOf([](Words& w) { Replace(w, spv::Op::OpFAdd, spv::Op::OpFSub); });
    EXPECT_EQ(sum.kind, Kind::kOperation);
    EXPECT_EQ(sum.step, 1u);
    EXPECT_FALSE(sum.is_in_parts);
    const Parting loop = PartingOf([](Words& w) { Replace(w, spv::Op::OpFSub, spv::Op::OpFMul); });
    EXPECT_EQ(loop.kind, Kind::kOperation);
    EXPECT_EQ(loop.step, 3u);
}

// A constant that is off by eight ulp, where it is used.
TEST_F(PartingTest, AWrongConstantIsFound) {
    const Parting parting = PartingOf([](Words& words) {
        const auto three =
            std::find(words.begin(), words.end(), std::bit_cast<std::uint32_t>(3.0f));
        ASSERT_NE(three, words.end());
        *three += 8;
    });
    EXPECT_EQ(parting.kind, Kind::kOperation);
    EXPECT_EQ(parting.step, 1u);
    EXPECT_EQ(parting.leaf, 0u);
}

TEST_F(PartingTest, AnotherWayIsNoticed) {
    const Parting parting = PartingOf(
        [](Words& w) { Replace(w, spv::Op::OpFOrdLessThan, spv::Op::OpFOrdGreaterThan); });
    // The comparison itself is an operation that differs.
    EXPECT_EQ(parting.kind, Kind::kOperation);
    EXPECT_TRUE(trace_.steps[parting.step].numbers.empty());
    // The comparison stands, and what follows is swapped.
    const Parting branch = PartingOf([](Words& words) {
        std::size_t compared = 0;
        for (std::size_t at = 5; at < words.size(); at += words[at] >> 16) {
            const auto op = static_cast<spv::Op>(words[at] & 0xffffu);
            if (op == spv::Op::OpFOrdLessThan) {
                compared = words[at + 2];
            } else if (op == spv::Op::OpBranchConditional && words[at + 1] == compared) {
                std::swap(words[at + 2], words[at + 3]);
            }
        }
    });
    EXPECT_EQ(branch.kind, Kind::kWay);
}

TEST_F(PartingTest, ADifferenceThatVanishesWhenWatchedIsNotInvented) {
    const Parting parting = PartingOf([this](Words& words) {
        if (Told(words) == 0) {
            Replace(words, spv::Op::OpFAdd, spv::Op::OpFSub);
        }
    });
    EXPECT_EQ(parting.kind, Kind::kUnseen);
    EXPECT_EQ(parting.tried, parting.instructions);
    EXPECT_GT(parting.instructions, 4u);
}

TEST_F(PartingTest, OneAtATimeIsTriedWhereWatchingAllChangesTheResult) {
    const Parting parting = PartingOf([this](Words& words) {
        constexpr std::size_t kMany = 3;
        if (Told(words) < kMany) {
            Replace(words, spv::Op::OpFAdd, spv::Op::OpFSub);
        }
    });
    EXPECT_EQ(parting.kind, Kind::kOperation);
    EXPECT_TRUE(parting.is_in_parts);
    EXPECT_EQ(parting.step, 1u);
}

TEST_F(PartingTest, ADeviceThatFailsIsNotBlamed) {
    const Parting parting =
        FindParting(probed_.program(), probed_.plan()->module, trace_, trace_.outputs,
                    [](const Program&) -> Result<Words, EvaluationFailure> {
                        return EvaluationFailure{EvaluationFailure::Kind::kCrash, "signal 11"};
                    });
    EXPECT_EQ(parting.kind, Kind::kFailed);
    EXPECT_EQ(parting.reason, "signal 11");
}

TEST(IsSameFloat, KnowsZerosAndNans) {
    EXPECT_TRUE(IsSameFloat(0, 0x80000000u));
    EXPECT_TRUE(IsSameFloat(0x7fc00000u, 0xffc00001u));
    EXPECT_FALSE(IsSameFloat(0x3f800000u, 0x3f800001u));
    EXPECT_FALSE(IsSameFloat(0x3f800000u, 0x7fc00000u));
}

}  // namespace
}  // namespace etalon
