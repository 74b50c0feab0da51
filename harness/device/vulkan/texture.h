// Texture: an image of a program on the device, with its sampler.
#pragma once

#include "device/vulkan/gpu.h"

namespace etalon {

struct Texture {
    vk::raii::Image image = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::ImageView view = nullptr;
    vk::raii::Sampler sampler = nullptr;
};

// Uploads and waits. Throws vk::SystemError; fails where the device cannot filter the format or
// hold the size.
DeviceResult<Texture> UploadTexture(Gpu& gpu, const BoundImage& bound);

}  // namespace etalon
