// Recipe: how a probe's source reaches a device.
//
// As text: the form, then what is added, joined by '+': "spirv", "spirv+O", "spirv+Os+precise",
// "glsl+baked", "glsl+fragment". The parts always stand in this order. "plain" in place of the form
// leaves it to the device.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "base/result.h"
#include "probe/program.h"

namespace etalon {

struct Recipe {
    enum class Optimise : std::uint8_t { kNone, kSpeed, kSize };

    Form form = Form::kSpirv;
    Optimise optimise =
        Optimise::kNone;  // SPIRV-Tools' passes for speed (+O) or size (+Os); SPIR-V only
    bool precise =
        false;  // SPIR-V: every operation is NoContraction; text: the result is declared precise
    bool baked = false;             // the inputs are constants of the program
    Stage stage = Stage::kCompute;  // +fragment
    bool plain = false;             // the device is to choose `form`

    bool operator==(const Recipe&) const = default;
};

std::string RecipeText(const Recipe& recipe);
Result<Recipe> ParseRecipe(std::string_view text);

}  // namespace etalon
