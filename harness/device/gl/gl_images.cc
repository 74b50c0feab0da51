#include "device/gl/gl_images.h"

#include "device/gl/gl_error.h"

namespace etalon {

GLuint MakeTexture(const GlFunctions& gl, GLint filter, GLint wrap) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(GL_TEXTURE_2D, texture);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
    gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    return texture;
}

DeviceResult<GlImages> GlImages::Upload(const GlFunctions& gl, const GlLimits& limits,
                                        const std::vector<BoundImage>& images) {
    if (kFirstImageBinding + images.size() > limits.texture_units) {
        return Unsupported("the program has " + std::to_string(images.size()) +
                           " images, the device takes " +
                           std::to_string(limits.texture_units - kFirstImageBinding));
    }
    GlImages uploaded;
    gl.ActiveTexture(GL_TEXTURE0);
    for (const BoundImage& bound : images) {
        const Image& image = *bound.image;
        ETALON_CHECK(image.width > 0 && image.height > 0);
        ETALON_CHECK(image.rgba.size() == std::size_t{4} * image.width * image.height);
        if (image.width > limits.texture_size || image.height > limits.texture_size) {
            return Unsupported("the image '" + bound.name +
                               "' is larger than the device's limit of " +
                               std::to_string(limits.texture_size));
        }
        uploaded.textures_.push_back(MakeTexture(gl, GL_LINEAR, GL_REPEAT));
        gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<GLsizei>(image.width),
                      static_cast<GLsizei>(image.height), 0, GL_RGBA, GL_FLOAT, image.rgba.data());
        ETALON_TRY_STEP(CheckGl(gl, "uploading an image"));
    }
    return uploaded;
}

void GlImages::NameSamplers(const GlFunctions& gl, GLuint program,
                            const std::vector<BoundImage>& images) {
    gl.UseProgram(program);
    for (std::size_t i = 0; i < images.size(); ++i) {
        gl.Uniform1i(gl.GetUniformLocation(program, images[i].name.c_str()),
                     static_cast<GLint>(kFirstImageBinding + i));
    }
}

void GlImages::Bind(const GlFunctions& gl) const {
    for (std::size_t i = 0; i < textures_.size(); ++i) {
        gl.ActiveTexture(GL_TEXTURE0 + kFirstImageBinding + static_cast<GLenum>(i));
        gl.BindTexture(GL_TEXTURE_2D, textures_[i]);
    }
}

}  // namespace etalon
