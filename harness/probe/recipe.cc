#include "probe/recipe.h"

namespace etalon {

std::string RecipeText(const Recipe& recipe) {
    std::string text = recipe.plain ? "plain" : recipe.form == Form::kSpirv ? "spirv" : "glsl";
    if (recipe.optimise != Recipe::Optimise::kNone) {
        text += recipe.optimise == Recipe::Optimise::kSpeed ? "+O" : "+Os";
    }
    if (recipe.precise) {
        text += "+precise";
    }
    if (recipe.baked) {
        text += "+baked";
    }
    if (recipe.stage == Stage::kFragment) {
        text += "+fragment";
    }
    return text;
}

Result<Recipe> ParseRecipe(std::string_view text) {
    const std::string whole(text);
    Recipe recipe;
    bool first = true;
    bool more = true;
    while (more) {
        const std::size_t plus = text.find('+');
        const std::string_view word = text.substr(0, plus);
        more = plus != std::string_view::npos;
        text.remove_prefix(more ? plus + 1 : text.size());
        if (first && word == "spirv") {
            recipe.form = Form::kSpirv;
        } else if (first && word == "glsl") {
            recipe.form = Form::kGlsl;
        } else if (first && word == "plain") {
            recipe.plain = true;
        } else if (!first && (word == "O" || word == "Os") && recipe.form == Form::kSpirv &&
                   recipe.optimise == Recipe::Optimise::kNone) {
            recipe.optimise = word == "O" ? Recipe::Optimise::kSpeed : Recipe::Optimise::kSize;
        } else if (!first && word == "precise") {
            recipe.precise = true;
        } else if (!first && word == "baked") {
            recipe.baked = true;
        } else if (!first && word == "fragment") {
            recipe.stage = Stage::kFragment;
        } else {
            return Error{
                "unknown recipe '" + whole +
                "': it is spirv, glsl or plain, then any of +O or +Os (not for glsl), +precise, "
                "+baked, +fragment"};
        }
        first = false;
    }
    return recipe;
}

}  // namespace etalon
