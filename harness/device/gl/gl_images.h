// A program's images as textures.
#pragma once

#include <cstdint>
#include <vector>

#include "device/device.h"
#include "device/gl/gl_functions.h"
#include "device/gl/gl_info.h"

namespace etalon {

// The textures of Program::images; image i belongs to the unit kFirstImageBinding + i.
class GlImages {
  public:
    static DeviceResult<GlImages> Upload(const GlFunctions& gl, const GlLimits& limits,
                                         const std::vector<BoundImage>& images);

    // Points the samplers of GLSL text, which are known by their names, at the images' units.
    // SPIR-V has bindings.
    static void NameSamplers(const GlFunctions& gl, GLuint program,
                             const std::vector<BoundImage>& images);

    void Bind(const GlFunctions& gl) const;

  private:
    std::vector<GLuint> textures_;
};

// A new texture of one level, bound to the active unit.
GLuint MakeTexture(const GlFunctions& gl, GLint filter, GLint wrap);

}  // namespace etalon
