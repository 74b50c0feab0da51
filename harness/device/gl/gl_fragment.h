// Fragment programs in GLSL text: inputs from a texture, outputs to colour attachments; for
// contexts without storage buffers.
#pragma once

#include <memory>
#include <vector>

#include "device/gl/gl_functions.h"
#include "device/gl/gl_images.h"
#include "device/gl/gl_info.h"
#include "device/gl/gl_program.h"

namespace etalon {

// What such programs share: the inputs' texture and the targets, grown as needed.
class Targets {
  public:
    Targets(const GlFunctions& gl, const GlLimits& limits, GlTextures& textures,
            std::uint32_t glsl_version);

    DeviceResult<std::unique_ptr<GlProgram>> Load(const Program& program);

  private:
    friend class FragmentProgram;

    // Reserves `input_lines` lines of the inputs' texture, and `count` targets of `lines` lines to
    // draw to.
    DeviceResult<Nothing> Reserve(std::uint32_t input_lines, std::uint32_t count,
                                  std::uint32_t lines);

    const GlFunctions& gl_;
    const GlLimits limits_;
    GlTextures& textures_;
    const std::uint32_t glsl_version_;
    GLuint inputs_ = 0;
    std::uint32_t input_capacity_ = 0;  // lines
    GLuint framebuffer_ = 0;
    std::vector<GLuint> targets_;
    std::uint32_t capacity_ = 0;            // lines of each target
    std::vector<std::uint32_t> read_back_;  // one target's pixels
};

}  // namespace etalon
