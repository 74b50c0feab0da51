#include "evaluate/profile.h"

#include <algorithm>
#include <array>

namespace etalon::evaluate {
namespace {

constexpr Profile Glsl() {
    Profile profile;
    profile.name = "glsl-4.60";
    profile.source = "OpenGL Shading Language 4.60, Range and Precision";
    profile.bounds_trigonometry = false;
    profile.defines_negative_modulus = false;
    profile.weight_absolute = 1.0;
    return profile;
}

constexpr Profile Vulkan13() {
    Profile profile;
    profile.name = "vulkan-1.3";
    profile.source = "Vulkan 1.3.250, Precision and Operation of SPIR-V Instructions";
    return profile;
}

constexpr std::array kProfiles = {Glsl(), Vulkan13()};

}  // namespace

const Profile* FindProfile(std::string_view name) {
    const auto* found = std::find_if(kProfiles.begin(), kProfiles.end(),
                                     [&](const Profile& one) { return one.name == name; });
    return found == kProfiles.end() ? nullptr : found;
}

std::vector<std::string_view> ProfileNames() {
    std::vector<std::string_view> names;
    for (const Profile& profile : kProfiles) {
        names.push_back(profile.name);
    }
    return names;
}

}  // namespace etalon::evaluate
