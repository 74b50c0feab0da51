#include "run/fit.h"

namespace etalon {

Target TargetOf(const DeviceInfo& device) {
    Target target;
    target.client = device.Has("glsl") ? Target::Client::kOpenGl : Target::Client::kVulkan;
    target.glsl_version = device.glsl_version == 0 ? 450 : device.glsl_version;
    return target;
}

Result<Recipe> FitRecipe(const Recipe& recipe, const DeviceInfo& device) {
    Recipe fit = recipe;
    if (recipe.plain) {
        fit.plain = false;
        fit.form =
            recipe.optimise == Recipe::Optimise::kNone ? DefaultRecipe(device).form : Form::kSpirv;
    }
    const std::string form = fit.form == Form::kSpirv ? "spirv" : "glsl";
    if (!device.Has(form)) {
        return Error{device.name + " takes no " + (form == "spirv" ? "SPIR-V" : "GLSL text")};
    }
    if (fit.stage == Stage::kCompute && !device.Has("compute")) {
        fit.stage = Stage::kFragment;
    }
    if (fit.stage == Stage::kFragment && !device.Has("fragment")) {
        return Error{device.name + " has no fragment stage for probes"};
    }
    if (fit.form == Form::kGlsl && fit.precise && device.glsl_version < 400) {
        return Error{"'precise' needs GLSL 4.00, " + device.name + " takes " +
                     std::to_string(device.glsl_version)};
    }
    return fit;
}

Recipe DefaultRecipe(const DeviceInfo& device) {
    Recipe recipe;
    recipe.form = device.Has("glsl") ? Form::kGlsl : Form::kSpirv;
    recipe.stage = device.Has("compute") ? Stage::kCompute : Stage::kFragment;
    return recipe;
}

std::vector<Recipe> DefaultRecipes(const DeviceInfo& device) {
    std::vector<Recipe> recipes;
    Recipe recipe = DefaultRecipe(device);
    recipes.push_back(recipe);
    recipe.baked = true;
    recipes.push_back(recipe);
    if (device.Has("spirv") && device.Has("compute")) {
        recipe = Recipe{};
        if (device.Has("glsl")) {
            recipes.push_back(recipe);
        }
        recipe.optimise = Recipe::Optimise::kSpeed;
        recipes.push_back(recipe);
        if (!device.Has("glsl")) {
            recipe.optimise = Recipe::Optimise::kSize;
            recipes.push_back(recipe);
            recipe = Recipe{};
            recipe.precise = true;
            recipes.push_back(recipe);
        }
    }
    if (device.Has("compute") && device.Has("fragment")) {
        recipe = DefaultRecipe(device);
        recipe.stage = Stage::kFragment;
        recipes.push_back(recipe);
    }
    return recipes;
}

std::vector<Recipe> QuickRecipes(const DeviceInfo& device, std::string_view case_path) {
    std::vector<Recipe> recipes = DefaultRecipes(device);
    if (recipes.size() > 2) {
        // FNV-1a: the same turn on every machine.
        std::uint32_t hash = 2166136261u;
        for (const char c : case_path) {
            hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        }
        recipes = {recipes.front(), recipes[1 + hash % (recipes.size() - 1)]};
    }
    return recipes;
}

}  // namespace etalon
