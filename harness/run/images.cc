#include "run/images.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <memory>

#include "base/file.h"

namespace etalon {
namespace {

constexpr int kChannels = 4;

std::size_t Values(int width, int height) {
    return std::size_t{kChannels} * static_cast<std::size_t>(width) *
           static_cast<std::size_t>(height);
}

}  // namespace

Result<Image> ReadImage(const std::filesystem::path& path) {
    ETALON_TRY(bytes, ReadFile(path));
    const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    int width = 0;
    int height = 0;
    int channels = 0;
    Image image;
    if (stbi_is_hdr_from_memory(data, size) != 0) {
        const std::unique_ptr<float, void (*)(void*)> pixels(
            stbi_loadf_from_memory(data, size, &width, &height, &channels, kChannels),
            stbi_image_free);
        if (pixels != nullptr) {
            image.rgba.assign(pixels.get(), pixels.get() + Values(width, height));
        }
    } else {
        const std::unique_ptr<stbi_us, void (*)(void*)> pixels(
            stbi_load_16_from_memory(data, size, &width, &height, &channels, kChannels),
            stbi_image_free);
        if (pixels != nullptr) {
            image.rgba.resize(Values(width, height));
            std::transform(pixels.get(), pixels.get() + image.rgba.size(), image.rgba.begin(),
                           [](stbi_us value) { return static_cast<float>(value) / 65535.0f; });
        }
    }
    if (image.rgba.empty()) {
        return Error{path.string() + ": is not an image (" + stbi_failure_reason() + ")"};
    }
    image.width = static_cast<std::uint32_t>(width);
    image.height = static_cast<std::uint32_t>(height);
    return image;
}

Status<> AddWith(const std::vector<std::string>& with, const std::filesystem::path& base,
                 Call& call) {
    for (const std::string& one : with) {
        const std::size_t equals = one.find('=');
        if (equals == std::string::npos) {
            call.with.push_back(base / one);
            continue;
        }
        ETALON_TRY(image, ReadImage(base / one.substr(equals + 1)));
        call.images.push_back(
            {one.substr(0, equals), std::make_shared<const Image>(std::move(image))});
    }
    return Ok();
}

}  // namespace etalon
