// Fits recipes to devices.
#pragma once

#include <string_view>
#include <vector>

#include "base/result.h"
#include "compile/compile.h"
#include "device/device.h"
#include "probe/recipe.h"

namespace etalon {

// Whose programs the device takes.
Target TargetOf(const DeviceInfo& device);

// The recipe as this device can run it: the fragment stage where it has no compute; for a plain one
// the form that the device's default recipe has, and SPIR-V for the optimiser. Fails, with the
// reason for a skip, where it cannot.
Result<Recipe> FitRecipe(const Recipe& recipe, const DeviceInfo& device);

// What is run where nobody asks for recipes: one for a probe, all of a set for a case.
Recipe DefaultRecipe(const DeviceInfo& device);
std::vector<Recipe> DefaultRecipes(const DeviceInfo& device);

// Two of the set, for a run that is quick: the default recipe and one of the others, whose turn the
// name of the case decides. Over many cases each comes as often.
std::vector<Recipe> QuickRecipes(const DeviceInfo& device, std::string_view case_path);

}  // namespace etalon
