#include "probe/recipe.h"

#include <gmock/gmock.h>

namespace etalon {
namespace {

using testing::StartsWith;

TEST(Recipe, ReadsBackWhatItWrites) {
    int count = 0;
    for (const Form form : {Form::kSpirv, Form::kGlsl}) {
        for (const auto optimise :
             {Recipe::Optimise::kNone, Recipe::Optimise::kSpeed, Recipe::Optimise::kSize}) {
            for (int bits = 0; bits < 8; ++bits) {
                if (form == Form::kGlsl && optimise != Recipe::Optimise::kNone) {
                    continue;
                }
                const Recipe recipe{form, optimise, (bits & 1) != 0, (bits & 2) != 0,
                                    (bits & 4) != 0 ? Stage::kFragment : Stage::kCompute};
                const auto read = ParseRecipe(RecipeText(recipe));
                ASSERT_TRUE(read) << RecipeText(recipe);
                EXPECT_EQ(*read, recipe) << RecipeText(recipe);
                ++count;
            }
        }
    }
    EXPECT_EQ(count, 32);
}

TEST(Recipe, HasOneOrderOfWords) {
    EXPECT_EQ(RecipeText(Recipe{}), "spirv");
    EXPECT_EQ(RecipeText({Form::kSpirv, Recipe::Optimise::kSize, true, true, Stage::kFragment}),
              "spirv+Os+precise+baked+fragment");
    EXPECT_EQ(RecipeText(*ParseRecipe("glsl+fragment+baked")), "glsl+baked+fragment");
    EXPECT_EQ(RecipeText(*ParseRecipe("plain+fragment+O")), "plain+O+fragment");
}

TEST(Recipe, RefusesTheRest) {
    for (const char* text :
         {"", "+", "spir", "spirv+", "glsl+O", "glsl+Os", "spirv+glsl", "O", "spirv+o",
          "spirv baked", "+baked", "SPIRV", "spirv++O", "plain+", "spirv+plain"}) {
        const auto recipe = ParseRecipe(text);
        ASSERT_FALSE(recipe) << text;
        EXPECT_THAT(recipe.error().message, StartsWith("unknown recipe '" + std::string(text) +
                                                       "': it is spirv, glsl or plain"));
    }
}

}  // namespace
}  // namespace etalon
