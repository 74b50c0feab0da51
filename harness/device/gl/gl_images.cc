#include "device/gl/gl_images.h"

#include <algorithm>

#include "device/gl/gl_error.h"

namespace etalon {
namespace {

GLuint MakeTexture(const GlFunctions& gl, GLenum target, std::uint32_t levels,
                   const Sampling& sampling) {
    GLuint texture = 0;
    gl.GenTextures(1, &texture);
    gl.BindTexture(target, texture);
    const bool linear = sampling.filter == Filter::kLinear;
    const GLint between_texels = linear ? GL_LINEAR : GL_NEAREST;
    const GLint between_levels = linear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST_MIPMAP_NEAREST;
    const GLint wrap = sampling.wrap == Wrap::kRepeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    gl.TexParameteri(target, GL_TEXTURE_MIN_FILTER, levels > 1 ? between_levels : between_texels);
    gl.TexParameteri(target, GL_TEXTURE_MAG_FILTER, between_texels);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_S, wrap);
    gl.TexParameteri(target, GL_TEXTURE_WRAP_T, wrap);
    gl.TexParameteri(target, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels - 1));
    return texture;
}

}  // namespace

GLuint MakeTexture(const GlFunctions& gl) {
    return MakeTexture(gl, GL_TEXTURE_2D, 1, {Filter::kNearest, Wrap::kClamp});
}

DeviceResult<std::vector<GlTexture>> GlTextures::Take(const std::vector<BoundImage>& images) {
    if (kFirstImageBinding + images.size() > limits_.texture_units) {
        return Unsupported("the program has " + std::to_string(images.size()) +
                           " images, the device takes " +
                           std::to_string(limits_.texture_units - kFirstImageBinding));
    }
    std::vector<GlTexture> textures;
    for (const BoundImage& bound : images) {
        ETALON_TRY(texture, TakeOne(bound));
        textures.push_back(texture);
    }
    return textures;
}

DeviceResult<GlTexture> GlTextures::TakeOne(const BoundImage& bound) {
    ETALON_CHECK(bound.image != nullptr && IsWhole(*bound.image));
    for (const Known& known : known_) {
        if (known.sampling == bound.sampling && AreSame(*known.image, *bound.image)) {
            return known.texture;
        }
    }
    ETALON_TRY(texture, Upload(bound));
    known_.push_back({bound.image, bound.sampling, texture});
    return texture;
}

DeviceResult<GlTexture> GlTextures::Upload(const BoundImage& bound) const {
    const Image& image = *bound.image;
    const bool is_cube = image.shape == ImageShape::kCube;
    const std::uint32_t most = is_cube ? limits_.cube_size : limits_.texture_size;
    if (std::max(image.width, image.height) > most) {
        return Unsupported("the image '" + bound.name + "' is larger than the device's limit of " +
                           std::to_string(most));
    }
    GlTexture texture;
    texture.target = is_cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    gl_.ActiveTexture(GL_TEXTURE0);
    texture.name = MakeTexture(gl_, texture.target, image.levels, bound.sampling);
    const float* values = image.rgba.data();
    for (std::uint32_t level = 0; level < image.levels; ++level) {
        const ImageSize size = LevelSize(image, level);
        for (std::uint32_t face = 0; face < FaceCount(image); ++face) {
            const GLenum part = is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X + face : texture.target;
            gl_.TexImage2D(part, static_cast<GLint>(level), GL_RGBA32F,
                           static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height), 0,
                           GL_RGBA, GL_FLOAT, values);
            values += 4 * size.texels();
        }
    }
    ETALON_TRY_STEP(CheckGl(gl_, "uploading an image"));
    return texture;
}

void NameSamplers(const GlFunctions& gl, GLuint program, const std::vector<BoundImage>& images) {
    gl.UseProgram(program);
    for (std::size_t i = 0; i < images.size(); ++i) {
        gl.Uniform1i(gl.GetUniformLocation(program, images[i].name.c_str()),
                     static_cast<GLint>(kFirstImageBinding + i));
    }
}

void BindTextures(const GlFunctions& gl, const std::vector<GlTexture>& textures) {
    for (std::size_t i = 0; i < textures.size(); ++i) {
        gl.ActiveTexture(GL_TEXTURE0 + kFirstImageBinding + static_cast<GLenum>(i));
        gl.BindTexture(textures[i].target, textures[i].name);
    }
}

}  // namespace etalon
