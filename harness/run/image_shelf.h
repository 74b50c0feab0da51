// Keeps images that were computed: cases of one family take the same maps of the same heights.
#pragma once

#include <filesystem>
#include <memory>

#include "base/result.h"
#include "case/image_source.h"
#include "image/image.h"

namespace etalon {

// MakeImage of the source. An image that no file goes into is made once for as long as something
// holds it or it is among the latest, 256 MiB of them. May be called from several threads.
Result<std::shared_ptr<const Image>> SharedImage(const ImageSource& source,
                                                 const std::filesystem::path& base);

}  // namespace etalon
