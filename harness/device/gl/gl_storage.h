// Programs that read and write storage buffers: compute, and fragment SPIR-V.
#pragma once

#include <memory>

#include "device/gl/gl_functions.h"
#include "device/gl/gl_images.h"
#include "device/gl/gl_info.h"
#include "device/gl/gl_program.h"

namespace etalon {

// What such programs share: the two buffers, and what a fragment program is drawn with.
class Storage {
  public:
    Storage(const GlFunctions& gl, const GlLimits& limits, GlTextures& textures);

    DeviceResult<std::unique_ptr<GlProgram>> Load(const Program& program);

  private:
    friend class StorageProgram;

    // Reserves room, in words, for the next batch.
    DeviceResult<Nothing> Reserve(std::size_t input_words, std::size_t output_words);
    // Makes what only fragment programs need, once.
    DeviceResult<Nothing> PrepareDrawing();

    const GlFunctions& gl_;
    const GlLimits limits_;
    GlTextures& textures_;
    GLuint inputs_ = 0;
    GLuint outputs_ = 0;
    std::size_t input_capacity_ = 0;
    std::size_t output_capacity_ = 0;
    GLuint vertex_program_ = 0;
    GLuint framebuffer_ = 0;
};

}  // namespace etalon
