// Images into files.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/image.h"

namespace etalon {

// Writes level 0 of a flat image as OpenEXR: binary32, no bit of a value lost. Fails, naming the
// path, where it cannot be written.
Status<> WriteExr(const std::filesystem::path& path, const Image& image);

}  // namespace etalon
