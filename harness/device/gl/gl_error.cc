#include "device/gl/gl_error.h"

#include <string>

namespace etalon {
namespace {

std::string ErrorName(GLenum error) {
    switch (error) {
        case GL_INVALID_ENUM:
            return "GL_INVALID_ENUM";
        case GL_INVALID_VALUE:
            return "GL_INVALID_VALUE";
        case GL_INVALID_OPERATION:
            return "GL_INVALID_OPERATION";
        case GL_INVALID_FRAMEBUFFER_OPERATION:
            return "GL_INVALID_FRAMEBUFFER_OPERATION";
        case GL_OUT_OF_MEMORY:
            return "GL_OUT_OF_MEMORY";
        case GL_CONTEXT_LOST:
            return "GL_CONTEXT_LOST";
        default:
            return "GL error " + std::to_string(error);
    }
}

}  // namespace

DeviceResult<Nothing> CheckGl(const GlFunctions& gl, const char* step) {
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) {
        return Ok();
    }
    // A lost context goes on reporting errors: bounded.
    for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
    }
    const bool lost = error == GL_OUT_OF_MEMORY || error == GL_CONTEXT_LOST;
    return DeviceFailure{lost ? DeviceFailure::Kind::kLost : DeviceFailure::Kind::kRejected,
                         "the driver reported " + ErrorName(error) + " when " + step};
}

}  // namespace etalon
