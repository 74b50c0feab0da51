#include "evaluate/count.h"

#include <gmock/gmock.h>
#include <spirv/unified1/GLSL.std.450.h>

#include <bit>
#include <spirv/unified1/spirv.hpp11>

#include "evaluate/probed.h"

namespace etalon::evaluate {
namespace {

// A step as long as the longest, of the instruction.
Operations Counted(std::uint32_t code) {
    Plan plan;
    plan.literals = {4, 4};
    Step step;
    step.code = code;
    step.components = 4;
    step.extra = 4;
    step.literals = 2;
    return OperationsOf(plan, step);
}

TEST(Count, KnowsEveryInstruction) {
    // One without a count would stop here.
#define ETALON_OPERATION(name) (void)Counted(static_cast<std::uint32_t>(spv::Op::Op##name));
#include "evaluate/operations.def"
#undef ETALON_OPERATION
#define ETALON_GLSL_OPERATION(name) \
    EXPECT_NE(Counted(kGlslCode + GLSLstd450##name), Operations{}) << #name;
#include "evaluate/glsl_operations.def"
#undef ETALON_GLSL_OPERATION
    EXPECT_EQ(Counted(static_cast<std::uint32_t>(spv::Op::OpLoad)), Operations{});
    EXPECT_EQ(Counted(static_cast<std::uint32_t>(spv::Op::OpFAdd))[OperationClass::kArithmetic], 4);
    EXPECT_DEATH((void)Counted(static_cast<std::uint32_t>(spv::Op::OpImageWrite)), "");
}

TEST(Count, CountsEveryFunctionByTheRowsThatEnterIt) {
    // Not optimised: calls and their blocks stay.
    const Probed probed(
        "float root(float x) { return sqrt(x); }\n"
        "float f(float x, int n)\n{\n"
        "    if (x < 0.0) {\n        return 0.0;\n    }\n"
        "    for (int i = 0; i < n; ++i) {\n        x = root(x) + root(2.0 * x);\n    }\n"
        "    return x;\n}\n",
        "f(x, n)", {"float x", "int n"});
    ASSERT_EQ(probed.error(), "");
    const std::vector<std::uint32_t> inputs = {std::bit_cast<std::uint32_t>(1.0f),
                                               std::bit_cast<std::uint32_t>(-1.0f),
                                               std::bit_cast<std::uint32_t>(2.0f),
                                               3,
                                               5,
                                               0};
    const auto counted = CountOperations(probed.plan(), {}, 3, inputs, 1);
    ASSERT_TRUE(counted) << counted.error().message;
    const auto specials = [&](std::size_t row) {
        return (*counted)[row][OperationClass::kSpecial];
    };
    EXPECT_EQ(specials(0), 6);
    EXPECT_EQ(specials(1), 0);
    EXPECT_EQ(specials(2), 0);
    const auto turns = [&](OperationClass kind) {
        return ((*counted)[0][kind] - (*counted)[2][kind]);
    };
    EXPECT_EQ(turns(OperationClass::kArithmetic), 3 * 2);
    EXPECT_EQ(turns(OperationClass::kComparison), 3);
    EXPECT_EQ(turns(OperationClass::kInteger), 3);
}

TEST(Count, CountsRowsOfSeveralGroups) {
    const Probed probed(
        "float f(int n) { float x = 1.0; for (int i = 0; i < n; ++i) { x = exp(x); } return x; }",
        "f(n)", {"int n"});
    ASSERT_EQ(probed.error(), "");
    std::vector<std::uint32_t> inputs;
    for (std::uint32_t row = 0; row < 1000; ++row) {
        inputs.push_back(row % 17);
    }
    const auto counted = CountOperations(probed.plan(), {}, 1000, inputs, 1);
    ASSERT_TRUE(counted);
    for (std::uint32_t row = 0; row < 1000; ++row) {
        ASSERT_EQ((*counted)[row][OperationClass::kSpecial], row % 17);
    }
}

}  // namespace
}  // namespace etalon::evaluate
