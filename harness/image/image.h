// Image: texels in binary32 as a shader's sampler reads them, flat or a cube, with its levels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace etalon {

// What no image goes beyond, so that a mistyped size is an error and not an exhausted machine.
inline constexpr std::uint32_t kMostImageSide = 1u << 14;
inline constexpr std::uint64_t kMostTexels = 1u << 24;  // of level 0, over all faces

enum class ImageShape : std::uint8_t { kFlat, kCube };

struct Image {
    std::uint32_t width = 0;  // of level 0
    std::uint32_t height = 0;
    // Level by level, in it face by face (+x, -x, +y, -y, +z, -z), in it row by row, the first row
    // at v = 0, in it r, g, b, a of each texel.
    std::vector<float> rgba;
    std::uint32_t levels = 1;
    ImageShape shape = ImageShape::kFlat;
};

struct ImageSize {
    std::uint32_t width = 0;
    std::uint32_t height = 0;

    std::size_t texels() const { return std::size_t{width} * height; }
};

// Half of the level above, rounded down, and at least 1.
ImageSize LevelSize(const Image& image, std::uint32_t level);

std::uint32_t FaceCount(const Image& image);

// The number of levels down to one of 1 x 1.
std::uint32_t FullLevels(const Image& image);

// Where a level's values begin in `rgba`.
std::size_t LevelStart(const Image& image, std::uint32_t level);

// True where the numbers are in their ranges and `rgba` has exactly the values they tell of.
bool IsWhole(const Image& image);

// True where two images are the same bits.
bool AreSame(const Image& a, const Image& b);

// The direction through a point of a cube's face, not normalised: its largest component is 1 or -1.
// s and t are 0..1 over the face; both APIs define this one layout (OpenGL 4.5, table 8.19).
struct Direction {
    double x = 0;
    double y = 0;
    double z = 0;
};
Direction CubeDirection(std::uint32_t face, double s, double t);

}  // namespace etalon
