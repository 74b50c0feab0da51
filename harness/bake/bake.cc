#include "bake/bake.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "bake/cone_map.h"
#include "bake/distance_map.h"
#include "bake/heights.h"
#include "bake/horizon_map.h"
#include "bake/max_mip.h"
#include "base/format.h"

namespace etalon::bake {
namespace {

constexpr std::array<std::string_view, 5> kNames = {"distance", "cone", "relaxed-cone", "max-mip",
                                                    "horizon"};
constexpr std::size_t kChannels = 4;
constexpr std::uint32_t kSlices = 32;
constexpr std::uint32_t kBearings = 16;
constexpr std::uint64_t kMostTiles = 4096;
constexpr double kReach = 64;  // of a horizon, in box heights: that of a ray in the shaders

enum class Rounding : std::uint8_t { kNearest, kDown };  // down: for what must not be too great

float Rounded(double value, Rounding rounding) {
    const auto nearest = static_cast<float>(value);
    return rounding == Rounding::kDown && nearest > value
               ? std::nextafter(nearest, -std::numeric_limits<float>::infinity())
               : nearest;
}

Image Blank(std::uint32_t width, std::uint32_t height) {
    Image image;
    image.width = width;
    image.height = height;
    image.rgba.resize(kChannels * std::size_t{width} * height);
    for (std::size_t i = kChannels - 1; i < image.rgba.size(); i += kChannels) {
        image.rgba[i] = 1;
    }
    return image;
}

// Puts a block of values, row by row, into the image.
void Put(Image& image, std::span<const double> values, std::uint32_t width, std::uint32_t column,
         std::uint32_t row, Rounding rounding) {
    for (std::size_t k = 0; k < values.size(); ++k) {
        const std::size_t texel = (row + k / width) * image.width + column + k % width;
        std::fill_n(image.rgba.data() + kChannels * texel, kChannels - 1,
                    Rounded(values[k], rounding));
    }
}

class Baker {
  public:
    Baker(const Image& image, const Plan& plan, const PartDone& done)
        : image_(image), plan_(plan), done_(done) {}

    Result<Image> Bake() {
        ETALON_TRY_STEP(CheckPlan());
        ETALON_TRY(heights, ReadHeights());
        switch (plan_.kind) {
            case Kind::kDistance:
                return Tiles(Distances(heights), Rounding::kDown);
            case Kind::kCone:
                return Tiles(
                    plan_.published ? SampledCones(heights, done_) : SafeCones(heights, done_),
                    Rounding::kDown);
            case Kind::kRelaxedCone:
                return Tiles(plan_.published ? SampledRelaxedCones(heights, done_)
                                             : SafeRelaxedCones(heights, done_),
                             Rounding::kDown);
            case Kind::kHorizon:
                return Tiles(
                    HorizonTangents(heights, static_cast<int>(tiles_), kReach * unit_, done_),
                    Rounding::kNearest);
            case Kind::kMaxMip:
                break;
        }
        return Levels(MaxLevels(heights));
    }

  private:
    Status<> CheckPlan() {
        const bool has_slices = plan_.kind == Kind::kDistance;
        const bool has_bearings = plan_.kind == Kind::kHorizon;
        const std::string kind(KindNames()[static_cast<std::size_t>(plan_.kind)]);
        if (plan_.slices && !has_slices) {
            return Error{"a map of kind " + kind + " has no slices"};
        }
        if (plan_.bearings && !has_bearings) {
            return Error{"a map of kind " + kind + " has no bearings"};
        }
        if (plan_.published && (has_bearings || plan_.kind == Kind::kMaxMip)) {
            return Error{"there is one map of kind " + kind + ": none is 'published'"};
        }
        const std::uint64_t tiles = has_slices     ? plan_.slices.value_or(kSlices)
                                    : has_bearings ? plan_.bearings.value_or(kBearings)
                                                   : 1;
        if (tiles < 1 || tiles > kMostTiles) {
            return Error{
                format("{} must be 1 to {}", has_slices ? "slices" : "bearings", kMostTiles)};
        }
        tiles_ = static_cast<std::uint32_t>(tiles);
        unit_ = plan_.texels_per_height.value_or(0.1 * image_.width);
        if (plan_.kind == Kind::kMaxMip) {
            unit_ = 1;  // without lengths along the field: its heights stay as they are
        }
        if (!(unit_ >= 0x1p-10 && unit_ <= 0x1p20)) {
            return Error{"texels per height must be 2^-10 to 2^20"};
        }
        if (image_.shape != ImageShape::kFlat) {
            return Error{"heights must be a flat image"};
        }
        const bool has_levels = plan_.kind == Kind::kMaxMip;
        if (has_levels &&
            !(std::has_single_bit(image_.width) && std::has_single_bit(image_.height))) {
            return Error{format("a max-mip needs sides that are powers of two, not {} x {}",
                                image_.width, image_.height)};
        }
        const std::uint64_t columns = TileColumns(tiles_);
        const std::uint64_t width = columns * image_.width;
        const std::uint64_t height = (tiles_ + columns - 1) / columns * image_.height;
        // A max-mip's levels stand beside each other: half as wide again.
        if (std::max(width, height) * (has_levels ? 2 : 1) > kMostImageSide ||
            width * height * (has_levels ? 2 : 1) > kMostTexels) {
            return Error{format("the map would have {} tiles of {} x {} texels, too many", tiles_,
                                image_.width, image_.height)};
        }
        return Ok();
    }

    Result<Heights> ReadHeights() const {
        std::vector<double> texels;
        for (std::size_t texel = 0; texel < LevelSize(image_, 0).texels(); ++texel) {
            const double z =
                plan_.scale * static_cast<double>(image_.rgba[kChannels * texel]) + plan_.level;
            if (!(std::fabs(z) <= 0.5)) {
                return Error{
                    format("the height {:.6g} at column {} of row {} is beyond the box, "
                           "-0.5 to 0.5: scale and level bring it there",
                           z, texel % image_.width, texel / image_.width)};
            }
            texels.push_back(z * unit_);
        }
        return Heights(static_cast<int>(image_.width), static_cast<int>(image_.height),
                       std::move(texels));
    }

    std::vector<double> Distances(const Heights& heights) const {
        const auto measure = plan_.published ? SampledDistances : SafeDistances;
        std::vector<double> distances =
            measure(heights, -0.5 * unit_, 0.5 * unit_, static_cast<int>(tiles_), done_).distances;
        for (double& distance : distances) {
            distance /= unit_;
        }
        return distances;
    }

    Image Tiles(std::span<const double> values, Rounding rounding) const {
        const std::uint32_t columns = TileColumns(tiles_);
        const std::size_t texels = LevelSize(image_, 0).texels();
        Image map = Blank(columns * image_.width, (tiles_ + columns - 1) / columns * image_.height);
        for (std::uint32_t tile = 0; tile < tiles_; ++tile) {
            Put(map, values.subspan(tile * texels, texels), image_.width,
                tile % columns * image_.width, tile / columns * image_.height, rounding);
        }
        return map;
    }

    Image Levels(const std::vector<MaxLevel>& levels) const {
        int upon = 0;
        for (std::size_t k = 1; k < levels.size(); ++k) {
            upon += levels[k].height;
        }
        const auto side = static_cast<std::uint32_t>(upon);
        const bool alone = levels.size() == 1;
        Image map = Blank(image_.width + (alone ? 0 : std::max(image_.width / 2, 1u)),
                          std::max(image_.height, side));
        std::uint32_t column = 0;
        std::uint32_t row = 0;
        for (const MaxLevel& level : levels) {
            Put(map, level.most, static_cast<std::uint32_t>(level.width), column, row,
                Rounding::kNearest);
            row = column == 0 ? 0 : row + static_cast<std::uint32_t>(level.height);
            column = image_.width;
        }
        return map;
    }

    const Image& image_;
    const Plan& plan_;
    const PartDone& done_;
    std::uint32_t tiles_ = 1;
    double unit_ = 1;  // texels to a box height
};

}  // namespace

std::span<const std::string_view> KindNames() {
    return kNames;
}

std::optional<Kind> KindNamed(std::string_view name) {
    const auto found = std::ranges::find(kNames, name);
    return found == kNames.end() ? std::nullopt
                                 : std::optional(static_cast<Kind>(found - kNames.begin()));
}

std::string KindNamesText() {
    return format("{}", fmt::join(kNames, ", "));
}

std::uint32_t TileColumns(std::uint32_t tiles) {
    std::uint32_t columns = 1;
    while (columns * columns < tiles) {
        ++columns;
    }
    return columns;
}

Result<Image> Bake(const Image& heights, const Plan& plan, const PartDone& done) {
    return Baker(heights, plan, done).Bake();
}

}  // namespace etalon::bake
