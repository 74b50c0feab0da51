// Texture: an image of a program on the device, with its sampler.
#pragma once

#include <memory>
#include <vector>

#include "device/vulkan/gpu.h"

namespace etalon {

struct Texture {
    vk::raii::Image image = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    vk::raii::ImageView view = nullptr;
    vk::raii::Sampler sampler = nullptr;
};

// The images of all programs on a device. They stay as long as it does, and one that comes again,
// with the same content and sampling and for the same stage, is not uploaded again.
class Textures {
  public:
    // Uploads and waits. Throws vk::SystemError; fails where the device cannot filter the format or
    // hold the size.
    DeviceResult<std::shared_ptr<const Texture>> Take(Gpu& gpu, Stage stage,
                                                      const BoundImage& bound);

  private:
    // SwiftShader completes a cube where it draws and not where it dispatches: were a texture
    // shared by both stages, what a program sees would depend on the programs before it.
    struct Known {
        std::shared_ptr<const Image> image;
        Sampling sampling;
        Stage stage;
        std::shared_ptr<const Texture> texture;
    };
    std::vector<Known> known_;
};

}  // namespace etalon
