#include "run/fit.h"

#include <gmock/gmock.h>

#include <map>

namespace etalon {
namespace {

using testing::ElementsAre;

DeviceInfo With(std::vector<std::string> features, std::uint32_t glsl_version = 0) {
    DeviceInfo info;
    info.name = "some:device";
    info.features = std::move(features);
    info.glsl_version = glsl_version;
    return info;
}

const DeviceInfo kVulkan = With({"compute", "fragment", "spirv"});
const DeviceInfo kNewGl = With({"glsl", "compute", "fragment", "spirv"}, 450);
const DeviceInfo kOldGl = With({"glsl", "fragment"}, 330);

std::string Fitted(const std::string& recipe, const DeviceInfo& device) {
    const auto fitted = FitRecipe(*ParseRecipe(recipe), device);
    return fitted ? RecipeText(*fitted) : "error: " + fitted.error().message;
}

std::vector<std::string> Texts(const std::vector<Recipe>& recipes) {
    std::vector<std::string> texts;
    for (const Recipe& recipe : recipes) {
        texts.push_back(RecipeText(recipe));
    }
    return texts;
}

TEST(FitRecipe, TakesTheFragmentStageWhereThereIsNoOther) {
    EXPECT_EQ(Fitted("glsl", kNewGl), "glsl");
    EXPECT_EQ(Fitted("glsl+baked", kOldGl), "glsl+baked+fragment");
    EXPECT_EQ(Fitted("glsl+fragment", kNewGl), "glsl+fragment");
}

TEST(FitRecipe, ChoosesTheFormOfAPlainRecipe) {
    EXPECT_EQ(Fitted("plain", kVulkan), "spirv");
    EXPECT_EQ(Fitted("plain", kNewGl), "glsl");
    EXPECT_EQ(Fitted("plain", kOldGl), "glsl+fragment");
    EXPECT_EQ(Fitted("plain+fragment", kVulkan), "spirv+fragment");
    EXPECT_EQ(Fitted("plain+fragment", kNewGl), "glsl+fragment");
    EXPECT_EQ(Fitted("plain+O", kVulkan), "spirv+O");
    EXPECT_EQ(Fitted("plain+O", kNewGl), "spirv+O");
    EXPECT_EQ(Fitted("plain+O", kOldGl), "error: some:device takes no SPIR-V");
}

TEST(FitRecipe, SaysWhyItCannot) {
    EXPECT_EQ(Fitted("spirv", kOldGl), "error: some:device takes no SPIR-V");
    EXPECT_EQ(Fitted("glsl", kVulkan), "error: some:device takes no GLSL text");
    EXPECT_EQ(Fitted("spirv+fragment", With({"spirv", "compute"})),
              "error: some:device has no fragment stage for probes");
    EXPECT_EQ(Fitted("spirv", With({"spirv"})),
              "error: some:device has no fragment stage for probes");
    EXPECT_EQ(Fitted("glsl+precise", kOldGl),
              "error: 'precise' needs GLSL 4.00, some:device takes 330");
    EXPECT_EQ(Fitted("spirv+precise", kNewGl), "spirv+precise");
}

TEST(DefaultRecipes, FitTheirDevice) {
    for (const DeviceInfo& device : {kVulkan, kNewGl, kOldGl, With({"spirv", "compute"})}) {
        for (const Recipe& recipe : DefaultRecipes(device)) {
            const auto fitted = FitRecipe(recipe, device);
            ASSERT_TRUE(fitted) << fitted.error().message;
            EXPECT_EQ(*fitted, recipe);
        }
        EXPECT_EQ(DefaultRecipes(device).front(), DefaultRecipe(device));
    }
    EXPECT_THAT(Texts(DefaultRecipes(kVulkan)),
                ElementsAre("spirv", "spirv+baked", "spirv+O", "spirv+Os", "spirv+precise",
                            "spirv+fragment"));
    EXPECT_THAT(Texts(DefaultRecipes(kNewGl)),
                ElementsAre("glsl", "glsl+baked", "spirv", "spirv+O", "glsl+fragment"));
    EXPECT_THAT(Texts(DefaultRecipes(kOldGl)), ElementsAre("glsl+fragment", "glsl+baked+fragment"));
}

TEST(QuickRecipes, TakeTurnsOverTheCases) {
    std::map<std::string, int> seen;
    for (int i = 0; i < 500; ++i) {
        const auto texts = Texts(QuickRecipes(kVulkan, "optics/case" + std::to_string(i)));
        ASSERT_EQ(texts.size(), 2u);
        EXPECT_EQ(texts[0], "spirv");
        ++seen[texts[1]];
    }
    EXPECT_EQ(seen.size(), 5u);
    for (const auto& [text, times] : seen) {
        EXPECT_GT(times, 60) << text;
    }
    EXPECT_EQ(Texts(QuickRecipes(kVulkan, "a/b")), Texts(QuickRecipes(kVulkan, "a/b")));
    EXPECT_EQ(QuickRecipes(kOldGl, "a/b"), DefaultRecipes(kOldGl));
}

TEST(TargetOf, IsOpenGlWhereTextIsTaken) {
    EXPECT_EQ(TargetOf(kVulkan).client, Target::Client::kVulkan);
    EXPECT_EQ(TargetOf(kVulkan).glsl_version, 450u);
    EXPECT_EQ(TargetOf(kNewGl).client, Target::Client::kOpenGl);
    EXPECT_EQ(TargetOf(kOldGl).glsl_version, 330u);
}

}  // namespace
}  // namespace etalon
