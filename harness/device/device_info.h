// What a device tells of itself: plain data, for everybody.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

struct DeviceInfo {
    std::string name;         // "vulkan:llvmpipe"; the driver's --driver name follows as "@NAME"
    std::string description;  // as the implementation calls itself
    std::string driver;       // name of the driver
    std::string version;      // of the driver
    std::string api;          // "Vulkan 1.3.230", "OpenGL 4.5 core"
    std::string compiler;     // "LLVM 15.0.6, 256 bits" where the implementation says, else empty
    std::vector<std::string>
        features;  // what a program may use: "compute", "fragment", "spirv", "glsl", "float64", ...
    std::vector<std::string> float_controls;  // "SignedZeroInfNanPreserve", "RoundingModeRTE", ...
    std::uint32_t glsl_version = 0;           // for GLSL text: 450, 330; 0 where text is not taken
    std::uint32_t max_rows = 1u << 20;        // in one Run
    std::uint32_t siblings = 1;  // devices that this candidate offers in all (see backends.h)
    bool on_host = false;        // computes on the host's processors, which it shares with all else
    bool slow = false;           // interprets shaders: a quick run has fewer rows for it

    bool Has(std::string_view feature) const {
        return std::find(features.begin(), features.end(), feature) != features.end();
    }
};

}  // namespace etalon
