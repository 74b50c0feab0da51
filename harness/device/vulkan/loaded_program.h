// LoadedProgram: a program as the device holds it: pipeline, descriptors and images.
#pragma once

#include <memory>
#include <vector>

#include "device/vulkan/gpu.h"
#include "device/vulkan/texture.h"

namespace etalon {

class LoadedProgram {
  public:
    // Throws vk::SystemError. The program must suit the device (see capability.h).
    static DeviceResult<LoadedProgram> Build(Gpu& gpu, Textures& textures, const Program& program);

    std::uint32_t input_words() const { return input_words_; }
    std::uint32_t output_words() const { return output_words_; }

    // Makes the program read and write these buffers. `generation` tells one pair of buffers from
    // the next: a repeated one costs nothing.
    void UseBuffers(const Gpu& gpu, vk::Buffer inputs, vk::Buffer outputs,
                    std::uint64_t generation);

    // Records the evaluation of `rows` rows, up to where the host may read.
    void Record(const Gpu& gpu, vk::raii::CommandBuffer& commands, std::uint32_t rows) const;

  private:
    LoadedProgram() = default;
    void CreateLayout(const Gpu& gpu);
    void CreateDescriptors(const Gpu& gpu);
    void CreateComputePipeline(const Gpu& gpu, const Program& program);
    void CreateFragmentPipeline(const Gpu& gpu, const Program& program);

    Stage stage_ = Stage::kCompute;
    std::uint32_t input_words_ = 0;
    std::uint32_t output_words_ = 0;
    std::vector<std::shared_ptr<const Texture>> textures_;
    vk::raii::DescriptorSetLayout set_layout_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    vk::raii::Pipeline pipeline_ = nullptr;
    vk::raii::DescriptorPool pool_ = nullptr;
    vk::raii::DescriptorSet set_ = nullptr;
    std::uint64_t generation_ = 0;  // of the buffers in set_; 0 where it has none
};

}  // namespace etalon
