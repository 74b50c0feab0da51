// Images as textures.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "device/device.h"
#include "device/gl/gl_functions.h"
#include "device/gl/gl_info.h"

namespace etalon {

struct GlTexture {
    GLenum target = GL_TEXTURE_2D;
    GLuint name = 0;
};

// The images of all programs on a context. They stay as long as it does, and one that comes again,
// with the same content and sampling, is not uploaded again.
class GlTextures {
  public:
    GlTextures(const GlFunctions& gl, const GlLimits& limits) : gl_(gl), limits_(limits) {}

    // The textures of Program::images; image i belongs to the unit kFirstImageBinding + i.
    DeviceResult<std::vector<GlTexture>> Take(const std::vector<BoundImage>& images);

  private:
    struct Known {
        std::shared_ptr<const Image> image;
        Sampling sampling;
        GlTexture texture;
    };

    DeviceResult<GlTexture> TakeOne(const BoundImage& bound);
    DeviceResult<GlTexture> Upload(const BoundImage& bound) const;

    const GlFunctions& gl_;
    const GlLimits limits_;
    std::vector<Known> known_;
};

// Points the samplers of GLSL text, which are known by their names, at the images' units. SPIR-V
// has bindings.
void NameSamplers(const GlFunctions& gl, GLuint program, const std::vector<BoundImage>& images);

void BindTextures(const GlFunctions& gl, const std::vector<GlTexture>& textures);

// A new flat texture of one level, unfiltered, bound to the active unit.
GLuint MakeTexture(const GlFunctions& gl);

}  // namespace etalon
