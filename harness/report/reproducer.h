// Reproducers: one value of one program on one implementation, as a file that other tools run and
// that needs nothing of Etalon. It tells whether the value is one that a specification allows.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

// What a program returned for its only row, and what it may. All words are as in probe/program.h:
// binding 0 holds the number of rows and the inputs, binding 1 the outputs.
struct Reproduction {
    std::vector<std::string> notes;  // lines for a reader
    std::vector<std::uint32_t> inputs;
    std::uint32_t outputs = 1;  // words
    std::uint32_t output = 0;   // the one that is held to what is allowed
    // Of a float, from low to high; zeros of both signs are one value and an infinite end is
    // allowed itself. Of anything else both are the only word.
    bool is_float = true;
    std::uint32_t low = 0;
    std::uint32_t high = 0;
};

// For piglit's shader_runner: passes where the value is allowed. `glsl` is a compute shader of
// GLSL 4.50; `version` is what the implementation takes, at least 330, of which a 3.30 needs the
// extensions for compute shaders and storage buffers.
std::string ShaderTest(const Reproduction& reproduction, std::string_view glsl,
                       std::uint32_t version);

// A C program for the Vulkan loader ("cc FILE.c -lvulkan"): exit status 0 where the value is
// allowed, 1 where it is not, 2 where it could not run. It takes the first device whose name
// contains `device`, or its first argument. `spirv` is a compute module with entry point "main".
std::string VulkanProgram(const Reproduction& reproduction, std::span<const std::uint32_t> spirv,
                          std::string_view device);

// Whether a file's text is one of these.
bool IsReproducer(std::string_view text);

}  // namespace etalon
