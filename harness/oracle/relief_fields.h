// Height fields made of texels, each under a name: what a scene's image, its oracle and its test
// share to the last bit.
//
// A field is a square of texels that repeats in both directions. Heights are z in the box of a
// relief, -0.5 .. 0.5, and multiples of 2^-12, so that a float, and even a half, holds them
// exactly.
//
//   smooth        128 x 128  a sum of sines; gradient at most 0.066 box heights per texel
//   bricks        128 x 128  a running bond whose edges rise 0.375 in one texel; gradient 0.53
//   noise         128 x 128  value noise of two octaves; gradient 0.13
//   ridges        128 x 128  a grid of ridges one texel wide and 0.8 high; gradient 1.13
//   steps         128 x 128  eight terraces, each 0.11 higher in one texel, up and down again
//   spike         128 x 128  one texel of 0.5 in a plane of -0.43
//   flat          128 x 128  -0.125 everywhere
//   film          128 x 128  waves cut off at the box's top: two fifths of its texels are 0.5
//   tiny              8 x 8  noise from texel to texel, -0.4375 .. 0.4375
//   plane         128 x 128  -0.137 everywhere
//   ramp          128 x 128  -0.42 to 0.42 along i and down again; gradient 0.013
//   sine_one      128 x 128  one wave along i, -0.4 .. 0.4; gradient 0.020
//   sine_four     128 x 128  four waves; gradient 0.078
//   sine_sixteen  128 x 128  sixteen waves, of eight texels each; gradient 0.28
//   cap           128 x 128  four caps of spheres, 48 texels wide and 0.75 high; gradient 0.075
//   ripples       128 x 128  four waves along i, -0.145 .. -0.105; gradient 0.0040
//
// No level of bricks, ridges, steps and the plane is where a search in 8, 16, 24 or 32 equal steps
// samples: on the level itself the last bit decides what is met.
//
//   relief.texel_smooth(i, j), ...  the texel in column i and row j; any integers
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

class HeightField {
  public:
    // Fills the texels; `size` is a power of two.
    HeightField(std::string_view name, int size, double (*height)(int i, int j));

    std::string_view name() const { return name_; }
    int size() const { return size_; }

    double Texel(std::int64_t i, std::int64_t j) const {
        const auto mask = static_cast<std::uint64_t>(size_) - 1;
        return texels_[(static_cast<std::uint64_t>(j) & mask) * (mask + 1) +
                       (static_cast<std::uint64_t>(i) & mask)];
    }

  private:
    std::string_view name_;
    int size_;
    std::vector<double> texels_;
};

inline constexpr std::size_t kHeightFields = 16;

// All fields, kHeightFields of them.
std::span<const HeightField> HeightFields();

std::vector<Function> ReliefFieldFunctions();

}  // namespace etalon::oracle
