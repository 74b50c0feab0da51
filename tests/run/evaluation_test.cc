#include "run/evaluation.h"

#include <gmock/gmock.h>

#include <bit>
#include <set>
#include <thread>

#include "compile/compile.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class EvaluationTest : public testing::Test {
  protected:
    // `f` takes a float.
    void Define(const std::string& source, const std::string& expression = "f(x)") {
        call_ = Call{};
        call_.source = folder_.Write("f" + std::to_string(++sources_) + ".glsl", source);
        call_.arguments = {{"x", "float", true, false}};
        call_.wanted = {{"result", expression, "CALL"}};
        const Result<Signature> signature = Inspect(call_);
        ASSERT_TRUE(signature) << signature.error().message;
        signature_ = *signature;
    }
    Evaluation& Of(const std::string& recipe = "spirv") {
        return evaluations_.Of(call_, signature_, *ParseRecipe(recipe),
                               {inputs_, inputs_.size(), 1});
    }
    static float Float(std::uint32_t word) { return std::bit_cast<float>(word); }

    Folder folder_;
    std::vector<std::uint32_t> inputs_ = {std::bit_cast<std::uint32_t>(1.0f),
                                          std::bit_cast<std::uint32_t>(3.0f)};
    int sources_ = 0;  // files do not change in a run
    Call call_;
    Signature signature_;
    Evaluations evaluations_{std::make_shared<Programs>()};
};

TEST_F(EvaluationTest, HoldsTheProgramByThreePrecisions) {
    Define("vec2 f(float x) { return vec2(x / 3.0, (x + 1e20) - 1e20); }\n");
    Evaluation& evaluation = Of();
    const Result<Evaluation::Values>& values = evaluation.Get();
    ASSERT_TRUE(values) << values.error().message;
    ASSERT_EQ(values->strict.size(), 4u);
    EXPECT_EQ(Float(values->strict[0]), 1.0f / 3.0f);
    EXPECT_EQ(Float(values->strict[1]), 1.0f);
    EXPECT_EQ(Float(values->strict[2]), 0);
    EXPECT_EQ(values->method.At(0, Scalar::kFloat), 1.0 / 3.0);
    EXPECT_EQ(values->method.At(3, Scalar::kFloat), 0);
    // 128 bits hold both addends.
    EXPECT_EQ(evaluation.MethodAt(0, 0, Scalar::kFloat), 1.0 / 3.0);
    EXPECT_EQ(evaluation.MethodAt(0, 1, Scalar::kFloat), 1);
    EXPECT_EQ(evaluation.MethodAt(1, 1, Scalar::kFloat), 3);
}

TEST_F(EvaluationTest, KnowsWhatIsNoFloat) {
    Define("int f(float x) { return -2 * int(x); }\n");
    Evaluation& evaluation = Of();
    ASSERT_TRUE(evaluation.Get());
    EXPECT_EQ(evaluation.Get()->method.At(1, Scalar::kInt), -6);
    EXPECT_EQ(evaluation.MethodAt(1, 0, Scalar::kInt), -6);
}

TEST_F(EvaluationTest, BoundsEachOutput) {
    Define("float f(float x) { return x / 3.0; }\n");
    for (const char* name : {"vulkan-1.3", "glsl-4.60"}) {
        const auto& bounds = Of().BoundsBy(*evaluate::FindProfile(name));
        ASSERT_TRUE(bounds) << bounds.error().message;
        const std::vector<Allowed>& allowed = bounds->allowed;
        ASSERT_EQ(allowed.size(), 2u);
        ASSERT_EQ(allowed[0].kind, Allowed::Kind::kNumber);
        EXPECT_LT(allowed[0].low, 1.0f / 3.0f);
        EXPECT_GT(allowed[0].high, 1.0f / 3.0f);
        EXPECT_THAT(bounds->is_void, ElementsAre(false, false));
        EXPECT_EQ(Excess(allowed[1], std::bit_cast<std::uint32_t>(1.0f)), 0);
        EXPECT_GT(Excess(allowed[1], std::bit_cast<std::uint32_t>(1.001f)), 0);
    }
    Define("int f(float x) { return 2 * int(x); }\n");
    const auto& words = Of().BoundsBy(*evaluate::FindProfile("vulkan-1.3"));
    ASSERT_TRUE(words) << words.error().message;
    EXPECT_EQ(words->allowed[1].kind, Allowed::Kind::kWord);
    EXPECT_EQ(words->allowed[1].word, 6u);
}

TEST_F(EvaluationTest, FollowsTheProgramThatARecipeMeans) {
    Define("float f(float x) { return x; }\n");
    Evaluation& plain = Of();
    for (const char* recipe : {"spirv+O", "spirv+Os", "spirv+baked", "spirv+fragment", "glsl",
                               "glsl+precise", "glsl+baked+fragment"}) {
        EXPECT_EQ(&Of(recipe), &plain) << recipe;
    }
    Evaluation& precise = Of("spirv+precise");
    EXPECT_NE(&precise, &plain);
    EXPECT_EQ(&Of("spirv+O+precise"), &precise);
    std::vector<std::uint32_t> others = inputs_;
    others.swap(inputs_);
    EXPECT_NE(&Of(), &plain);
}

TEST_F(EvaluationTest, SaysWhyThereIsNone) {
    Define("float f(float x) { return dFdx(x); }\n");
    EXPECT_EQ(Of().Get().error().message, "its sources compile for fragment shaders only");
    EXPECT_EQ(Of().BoundsBy(*evaluate::FindProfile("vulkan-1.3")).error().message,
              "its sources compile for fragment shaders only");
    Define("float f(float x) { while (x > 0.0) { x += 1.0; } return x; }\n");
    EXPECT_THAT(Of().Get().error().message, HasSubstr("a loop does not end"));
}

TEST_F(EvaluationTest, IsMadeAnewWhereItWasForgotten) {
    Define("float f(float x) { return x; }\n");
    (void)Of().Get();
    inputs_[0] = inputs_[1];
    EXPECT_EQ(Float(Of().Get()->strict[0]), 1.0f);
    evaluations_.Forget(inputs_);
    EXPECT_EQ(Float(Of().Get()->strict[0]), 3.0f);
}

TEST_F(EvaluationTest, IsMadeOnceForAllThreads) {
    Define("float f(float x) { return x; }\n");
    std::vector<const void*> seen(8);
    std::vector<std::thread> threads;
    for (const void*& place : seen) {
        threads.emplace_back([&] { place = &Of().Get(); });
    }
    for (std::thread& thread : threads) {
        thread.join();
    }
    EXPECT_THAT(seen, testing::Each(seen[0]));
}

TEST(ProfileOf, IsTheOneOfTheInterface) {
    DeviceInfo device;
    const auto name = [&device](const std::string& of) {
        device.name = of;
        return ProfileOf(device).name;
    };
    EXPECT_EQ(name("vulkan:llvmpipe@new"), "vulkan-1.3");
    EXPECT_EQ(name("osmesa:softpipe"), "glsl-4.60");
    EXPECT_EQ(name("egl:zink"), "glsl-4.60");
    EXPECT_EQ(name("cpu"), "vulkan-1.3");
    EXPECT_EQ(name("null:echo"), "vulkan-1.3");
}

}  // namespace
}  // namespace etalon
