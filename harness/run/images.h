// Images for samplers, and the words of --with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "probe/call.h"

namespace etalon {

// Reads PNG, JPEG, TGA, BMP, PSD, GIF, PIC, PNM (8 and 16 bit, as 0..1) and HDR, with the first row
// at v = 0.
Result<Image> ReadImage(const std::filesystem::path& path);

// Adds what --with names, "scene.glsl" or "height=map.png", to the call; paths are relative to
// `base`.
Status<> AddWith(const std::vector<std::string>& with, const std::filesystem::path& base,
                 Call& call);

}  // namespace etalon
