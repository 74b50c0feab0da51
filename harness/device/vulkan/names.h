// What a Vulkan implementation calls itself, made into the kit's words.
#pragma once

#include <string>
#include <string_view>

namespace etalon {

// A device's name as one word: the text before a parenthesis, lower case, words joined by '-',
// without "device" and trademark signs. "llvmpipe (LLVM 15.0.6, 256 bits)" -> "llvmpipe",
// "NVIDIA H200" -> "nvidia-h200". "unknown" where nothing is left.
std::string Slug(std::string_view device_name);

// The shader compiler, "LLVM 15.0.6, 256 bits", where a parenthesis of the device's name or else of
// the driver's own words names one; else empty.
std::string CompilerOf(std::string_view device_name, std::string_view driver_words);

}  // namespace etalon
