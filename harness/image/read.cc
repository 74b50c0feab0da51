#include "image/read.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <string_view>

#include "base/file.h"
#include "image/exr.h"

namespace etalon {
namespace {

constexpr int kChannels = 4;

template <typename Value>
using Pixels = std::unique_ptr<Value, void (*)(void*)>;

Result<Image> DecodeOther(std::string_view bytes) {
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const auto size =
        static_cast<int>(std::min<std::size_t>(bytes.size(), std::numeric_limits<int>::max()));
    int width = 0;
    int height = 0;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0) {
        return Error{std::string("is not an image (") + stbi_failure_reason() + ")"};
    }
    const std::uint64_t texels =
        static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (static_cast<std::uint32_t>(std::max(width, height)) > kMostImageSide ||
        texels > kMostTexels) {
        return Error{"has " + std::to_string(width) + " x " + std::to_string(height) +
                     " texels, too many"};
    }
    // stb 2.27 takes the 16-bit values of a PNM for 8-bit ones when it adds the absent channels.
    const bool is_pnm = bytes.starts_with("P5") || bytes.starts_with("P6");
    if (is_pnm && stbi_is_16_bit_from_memory(data, size) != 0) {
        return Error{"is a PNM file of 16 bits, which cannot be read; PNG and OpenEXR can"};
    }
    Image image;
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    const std::size_t values = kChannels * texels;
    if (stbi_is_hdr_from_memory(data, size) != 0) {
        const Pixels<float> pixels(
            stbi_loadf_from_memory(data, size, &width, &height, &channels, kChannels),
            stbi_image_free);
        if (pixels != nullptr) {
            image.rgba.assign(pixels.get(), pixels.get() + values);
        }
    } else {
        const Pixels<stbi_us> pixels(
            stbi_load_16_from_memory(data, size, &width, &height, &channels, kChannels),
            stbi_image_free);
        if (pixels != nullptr) {
            image.rgba.resize(values);
            std::transform(pixels.get(), pixels.get() + values, image.rgba.begin(),
                           [](stbi_us value) { return static_cast<float>(value) / 65535.0f; });
        }
    }
    if (image.rgba.empty()) {
        return Error{std::string("is not an image (") + stbi_failure_reason() + ")"};
    }
    return image;
}

}  // namespace

Result<Image> ReadImage(const std::filesystem::path& path) {
    ETALON_TRY(bytes, ReadFile(path));
    Result<Image> image = IsExr(bytes) ? DecodeExr(bytes) : DecodeOther(bytes);
    if (!image) {
        return Error{path.string() + ": " + image.error().message};
    }
    return image;
}

}  // namespace etalon
