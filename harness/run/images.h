// Images for a call's samplers: from files, and from expressions.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "case/image_source.h"
#include "probe/call.h"

namespace etalon {

// Reads or computes the image, and bakes the map of it that is asked for; files are
// relative to `base`. Values of expressions are rounded to binary32, and must be finite in it.
Result<Image> MakeImage(const ImageSource& source, const std::filesystem::path& base);

// Adds images to the call; two for one sampler are an error.
Status<> AddImages(std::span<const ImageSource> sources, const std::filesystem::path& base,
                   Call& call);

// Adds what --with names, "scene.glsl" or "height=map.png", to the call; paths are relative to
// `base`.
Status<> AddWith(const std::vector<std::string>& with, const std::filesystem::path& base,
                 Call& call);

}  // namespace etalon
