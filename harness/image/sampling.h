// Sampling: what a shader finds between and beyond an image's texels.
#pragma once

#include <cstdint>

namespace etalon {

enum class Filter : std::uint8_t { kLinear, kNearest };
enum class Wrap : std::uint8_t { kRepeat, kClamp };

// The filter holds between texels and between levels alike: linear is bilinear in an image of one
// level, trilinear in one of several. The wrap has no meaning for a cube.
struct Sampling {
    Filter filter = Filter::kLinear;
    Wrap wrap = Wrap::kRepeat;

    bool operator==(const Sampling&) const = default;
};

}  // namespace etalon
