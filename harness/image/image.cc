#include "image/image.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "base/check.h"

namespace etalon {
namespace {

constexpr std::size_t kChannels = 4;
constexpr std::uint32_t kCubeFaces = 6;

}  // namespace

ImageSize LevelSize(const Image& image, std::uint32_t level) {
    ETALON_CHECK(level < 32);
    return {std::max(image.width >> level, 1u), std::max(image.height >> level, 1u)};
}

std::uint32_t FaceCount(const Image& image) {
    return image.shape == ImageShape::kCube ? kCubeFaces : 1;
}

std::uint32_t FullLevels(const Image& image) {
    return static_cast<std::uint32_t>(std::bit_width(std::max(image.width, image.height)));
}

std::size_t LevelStart(const Image& image, std::uint32_t level) {
    std::size_t texels = 0;
    for (std::uint32_t above = 0; above < level; ++above) {
        texels += LevelSize(image, above).texels();
    }
    return kChannels * FaceCount(image) * texels;
}

bool IsWhole(const Image& image) {
    const bool known = image.shape == ImageShape::kFlat ||
                       (image.shape == ImageShape::kCube && image.width == image.height);
    // First the one product that cannot overflow.
    return known && image.width > 0 && image.height > 0 && image.levels > 0 &&
           image.levels <= FullLevels(image) && LevelSize(image, 0).texels() <= image.rgba.size() &&
           image.rgba.size() == LevelStart(image, image.levels);
}

bool AreSame(const Image& a, const Image& b) {
    return a.width == b.width && a.height == b.height && a.levels == b.levels &&
           a.shape == b.shape && a.rgba.size() == b.rgba.size() &&
           std::memcmp(a.rgba.data(), b.rgba.data(), a.rgba.size() * sizeof(float)) == 0;
}

Direction CubeDirection(std::uint32_t face, double s, double t) {
    const double a = 2 * s - 1;
    const double b = 2 * t - 1;
    switch (face) {
        case 0:
            return {1, -b, -a};
        case 1:
            return {-1, -b, a};
        case 2:
            return {a, 1, b};
        case 3:
            return {a, -1, -b};
        case 4:
            return {a, -b, 1};
        default:
            return {-a, -b, -1};
    }
}

}  // namespace etalon
