// ImageSource: where an image for a sampler comes from, and how it is read.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "case/expression.h"
#include "case/place.h"
#include "image/image.h"
#include "image/sampling.h"

namespace etalon {

// Exactly one of files and channels is not empty.
struct ImageSource {
    std::string name;                  // of the sampler
    std::vector<std::string> files;    // one, or a cube's six
    std::vector<Expression> channels;  // over ImageSymbols, bound to them; together they fill red,
                                       // green, blue, alpha; absent ones are 0, 0, 0, 1
    std::uint32_t width = 0;           // with channels
    std::uint32_t height = 0;
    ImageShape shape = ImageShape::kFlat;
    bool levels = false;             // all of them, or one
    std::optional<bake::Plan> bake;  // then the image is that map of what is read or computed
    Sampling sampling;
    Place place;
};

// What an image's expressions are over. Flat: u and v, the texel's centre in 0..1, and its column i
// and row j. Cube: x, y and z, the unit vector through the texel's centre.
std::vector<Symbol> ImageSymbols(ImageShape shape);

}  // namespace etalon
