// The injector itself: each kind of fault is found at each of its places, and does what it says.
#include "evaluate/faults.h"

#include <gmock/gmock.h>

#include <bit>

#include "evaluate/probed.h"
#include "spirv/read.h"

namespace etalon {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

// What the module returns for x and y.
float Returned(const std::vector<std::uint32_t>& spirv, float x, float y) {
    Result<spirv::Module> module = spirv::ReadModule(spirv);
    EXPECT_TRUE(module.ok()) << module.error().message;
    const auto plan = evaluate::MakePlan(std::move(*module));
    EXPECT_TRUE(plan.ok()) << plan.error().message;
    evaluate::Evaluator<float> evaluator(*plan, {});
    const std::vector<std::uint32_t> in = {std::bit_cast<std::uint32_t>(x),
                                           std::bit_cast<std::uint32_t>(y)};
    std::vector<std::uint32_t> out(1);
    EXPECT_TRUE(evaluator.Run({1, in, out}).ok());
    return std::bit_cast<float>(out[0]);
}

// What faults of a kind make of "float f(float x, float y)".
std::vector<float> Returned(Fault::Kind kind, const std::string& body, float x, float y,
                            const std::string& recipe = "spirv") {
    const Probed probed("float f(float x, float y) { " + body + " }\n", "f(x, y)",
                        {"float x", "float y"}, recipe);
    EXPECT_EQ(probed.error(), "");
    std::vector<float> returned;
    for (const Fault& fault : FaultsOf(probed.program().spirv)) {
        if (fault.kind == kind) {
            EXPECT_THAT(fault.what, testing::StartsWith(std::string(NameOf(kind)) + " at SPIR-V "));
            returned.push_back(Returned(fault.spirv, x, y));
        }
    }
    return returned;
}

TEST(Faults, SwapOperandsOfWhatIsNotCommutative) {
    constexpr auto kKind = Fault::Kind::kOperandsSwapped;
    EXPECT_THAT(Returned(kKind, "return x - y;", 5, 3), ElementsAre(-2.0f));
    EXPECT_THAT(Returned(kKind, "return x / y;", 2, 8), ElementsAre(4.0f));
    EXPECT_THAT(Returned(kKind, "return (x - y) / y;", 6, 2), UnorderedElementsAre(-2.0f, 0.5f));
    EXPECT_THAT(Returned(kKind, "return x < y ? 1.0 : 2.0;", 6, 2),
                UnorderedElementsAre(1.0f, 1.0f));
    EXPECT_THAT(Returned(kKind, "return pow(x, y);", 2, 3), ElementsAre(9.0f));
    EXPECT_THAT(Returned(kKind, "return vec2(x, y).x;", 2, 3), ElementsAre(3.0f));
    EXPECT_THAT(Returned(kKind, "return x + y * max(x, y) - 0.0 * x;", 2, 3), ElementsAre(-11.0f));
    EXPECT_THAT(Returned(kKind, "return x + y * max(x, y);", 2, 3), IsEmpty());
}

TEST(Faults, MoveConstantsByEightUlp) {
    constexpr auto kKind = Fault::Kind::kConstantOff;
    EXPECT_THAT(Returned(kKind, "return x * 1.0 + y * 0.5;", 1, 2),
                UnorderedElementsAre(2.0f + 0x1p-20f, 2.0f + 0x1p-20f));
    EXPECT_THAT(Returned(kKind, "return x - 1.0;", 1, 2), ElementsAre(-0x1p-20f));
    EXPECT_THAT(Returned(kKind, "return x + y;", 1, 2), IsEmpty());
}

TEST(Faults, DropNegations) {
    constexpr auto kKind = Fault::Kind::kNegationDropped;
    EXPECT_THAT(Returned(kKind, "return -x;", 3, 1), ElementsAre(3.0f));
    EXPECT_THAT(Returned(kKind, "return x - y;", 5, 3), ElementsAre(8.0f));
    EXPECT_THAT(Returned(kKind, "return -x - y;", 5, 3), UnorderedElementsAre(2.0f, -2.0f));
}

TEST(Faults, FuseWhatMustNotBeContracted) {
    constexpr auto kKind = Fault::Kind::kFused;
    // (1 + 2^-12)^2 = 1 + 2^-11 + 2^-24, of which a product keeps all but the last.
    const float x = 1.0f + 0x1p-12f;
    const float kept = 1.0f + 0x1p-11f;
    const std::string precise = "spirv+precise";
    EXPECT_THAT(Returned(kKind, "return x * x - y;", x, kept, precise), ElementsAre(0x1p-24f));
    EXPECT_THAT(Returned(kKind, "return y - x * x;", x, kept, precise), ElementsAre(-0x1p-24f));
    EXPECT_THAT(Returned(kKind, "return x * x + y;", x, -kept, precise), ElementsAre(0x1p-24f));
    EXPECT_THAT(Returned(kKind, "return y + x * x;", x, -kept, precise), ElementsAre(0x1p-24f));
    EXPECT_THAT(Returned(kKind, "return x * x - y * y;", x, x, precise),
                UnorderedElementsAre(0x1p-24f, -0x1p-24f));
    EXPECT_THAT(Returned(kKind, "precise float r = x * x - y; return r;", x, kept),
                ElementsAre(0x1p-24f));
    EXPECT_THAT(Returned(kKind, "return x * x - y;", x, kept), IsEmpty());
}

TEST(Faults, DropTheLastIteration) {
    constexpr auto kKind = Fault::Kind::kIterationDropped;
    EXPECT_THAT(Returned(kKind, "for (int i = 0; i < 4; ++i) { x += y; } return x;", 10, 3),
                ElementsAre(19.0f));
    EXPECT_THAT(Returned(kKind, "return x;", 10, 3), IsEmpty());
}

TEST(Faults, LeaveModulesThatRun) {
    const Probed probed(
        "vec3 f(vec3 v, vec3 n) {\n"
        "  for (int i = 0; i < 3; ++i) { v = v - 2.0 * dot(v, n) * n; }\n"
        "  return -v.x < n.y ? v / 3.0 : refract(v, n, 0.5); }\n",
        "f(v, n)", {"vec3 v", "vec3 n"}, "spirv+precise");
    ASSERT_EQ(probed.error(), "");
    std::vector<Fault::Kind> kinds;
    for (const Fault& fault : FaultsOf(probed.program().spirv)) {
        const Result<spirv::Module> module = spirv::ReadModule(fault.spirv);
        EXPECT_TRUE(module.ok()) << fault.what << ": " << module.error().message;
        kinds.push_back(fault.kind);
    }
    EXPECT_THAT(kinds, testing::IsSupersetOf(
                           {Fault::Kind::kOperandsSwapped, Fault::Kind::kConstantOff,
                            Fault::Kind::kNegationDropped, Fault::Kind::kIterationDropped}));
    EXPECT_THAT(kinds, Each(testing::AnyOfArray(kFaultKinds)));
}

}  // namespace
}  // namespace etalon
