// Images from files.
#pragma once

#include <filesystem>

#include "base/result.h"
#include "image/image.h"

namespace etalon {

// Reads PNG and PSD (8 and 16 bit, as 0..1), JPEG, TGA, BMP, GIF, PIC and PNM (8 bit), HDR and
// OpenEXR, with the first row at v = 0. Grey is red, green and blue alike, an absent alpha is 1,
// any other absent channel of an OpenEXR file 0. Fails, naming the path, on what is no image and
// beyond the limits of image.h.
Result<Image> ReadImage(const std::filesystem::path& path);

}  // namespace etalon
