// Bake: from an image of heights the image of a map that a search of the relief reads.
//
// Heights are z = scale * sample + level of the image's red channel, in the relief's box of height
// one, -0.5 .. 0.5; they repeat and are bilinear. Lengths in a map are in box heights.
//
//   distance      how far the solid is, in `slices` slices upwards; safe: see distance_map.h
//   cone          the ratio of radius to height of an empty cone: see cone_map.h
//   relaxed-cone  the same of a cone that is entered once
//   max-mip       the greatest heights of blocks: see max_mip.h
//   horizon       tangents of the least free elevation, in `bearings` bearings: see horizon_map.h
//
// Slices and bearings are tiles of the image's size, the first at column and row 0, TileColumns of
// them to a row. Of a max-mip level 0 is at column and row 0; the others stand right of it, level 1
// at row 0 and each further one upon the one before.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "bake/heights.h"
#include "base/result.h"
#include "image/image.h"

namespace etalon::bake {

enum class Kind : std::uint8_t { kDistance, kCone, kRelaxedCone, kMaxMip, kHorizon };

// The kinds' names, in the order of Kind.
std::span<const std::string_view> KindNames();
std::optional<Kind> KindNamed(std::string_view name);
std::string KindNamesText();  // for a message: "distance, cone, ..."

// The level with which the values of an image file, 0 to 1, fill the box.
inline constexpr double kFileLevel = -0.5;

struct Plan {
    Kind kind = Kind::kDistance;
    std::optional<std::uint64_t> slices = {};      // of a distance map; 32
    std::optional<std::uint64_t> bearings = {};    // of a horizon map; 16
    std::optional<double> texels_per_height = {};  // texels as long as the box is high; a tenth of
                                                   // the image's width
    bool published = false;  // a distance or cone map as published, which may be wrong between
                             // its points
    double scale = 1;
    double level = 0;
};

std::uint32_t TileColumns(std::uint32_t tiles);

// The map, alike in red, green and blue; alpha is 1. Fails with a reason that names no place where
// the plan does not fit the kind or the image, or a height is beyond the box.
Result<Image> Bake(const Image& heights, const Plan& plan, const PartDone& done = {});

}  // namespace etalon::bake
