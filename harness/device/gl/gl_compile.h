// From shaders to a linked program.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "device/device.h"
#include "device/gl/gl_functions.h"

namespace etalon {

struct ShaderSource {
    GLenum stage = GL_COMPUTE_SHADER;
    std::string_view text;                 // GLSL; used where `spirv` is empty
    std::span<const std::uint32_t> spirv;  // entry point "main"
};

// Compiles and links. A separable program is a part of a program pipeline. kRejected with the
// compiler's or linker's whole log where the driver refuses.
DeviceResult<GLuint> BuildProgram(const GlFunctions& gl, std::span<const ShaderSource> sources,
                                  bool separable);

}  // namespace etalon
