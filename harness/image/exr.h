// OpenEXR in memory.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "image/image.h"

namespace etalon {

bool IsExr(std::string_view bytes);

// The reason of an error does not name the file.
Result<Image> DecodeExr(std::string_view bytes);
Result<std::string> EncodeExr(const Image& image);

}  // namespace etalon
