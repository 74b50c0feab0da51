#include "device/vulkan/loaded_program.h"

#include <array>
#include <span>

#include "device/vulkan/triangle.h"

namespace etalon {
namespace {

constexpr std::uint32_t kStorageBindings = 2;
static_assert(kStorageBindings == kFirstImageBinding);

std::uint32_t GroupsFor(std::uint32_t rows, std::uint32_t group) {
    return (rows + group - 1) / group;
}

vk::raii::ShaderModule MakeModule(const Gpu& gpu, std::span<const std::uint32_t> words) {
    return {gpu.device,
            vk::ShaderModuleCreateInfo({}, words.size() * sizeof(std::uint32_t), words.data())};
}

}  // namespace

DeviceResult<LoadedProgram> LoadedProgram::Build(Gpu& gpu, Textures& textures,
                                                 const Program& program) {
    LoadedProgram loaded;
    loaded.stage_ = program.stage;
    loaded.input_words_ = program.input_words;
    loaded.output_words_ = program.output_words;
    for (const BoundImage& image : program.images) {
        ETALON_TRY(texture, textures.Take(gpu, program.stage, image));
        loaded.textures_.push_back(std::move(texture));
    }
    loaded.CreateLayout(gpu);
    loaded.CreateDescriptors(gpu);
    if (program.stage == Stage::kCompute) {
        loaded.CreateComputePipeline(gpu, program);
    } else {
        loaded.CreateFragmentPipeline(gpu, program);
    }
    return loaded;
}

void LoadedProgram::CreateLayout(const Gpu& gpu) {
    const vk::ShaderStageFlags stage = stage_ == Stage::kCompute
                                           ? vk::ShaderStageFlagBits::eCompute
                                           : vk::ShaderStageFlagBits::eFragment;
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t binding = 0; binding < kStorageBindings; ++binding) {
        bindings.emplace_back(binding, vk::DescriptorType::eStorageBuffer, 1, stage);
    }
    for (const auto& texture : textures_) {
        const auto binding = static_cast<std::uint32_t>(bindings.size());
        bindings.emplace_back(binding, vk::DescriptorType::eCombinedImageSampler, stage,
                              *texture->sampler);
    }
    set_layout_ = vk::raii::DescriptorSetLayout(gpu.device, {{}, bindings});
    layout_ = vk::raii::PipelineLayout(gpu.device, {{}, *set_layout_});
}

void LoadedProgram::CreateDescriptors(const Gpu& gpu) {
    std::vector<vk::DescriptorPoolSize> sizes = {
        {vk::DescriptorType::eStorageBuffer, kStorageBindings}};
    if (!textures_.empty()) {
        sizes.emplace_back(vk::DescriptorType::eCombinedImageSampler,
                           static_cast<std::uint32_t>(textures_.size()));
    }
    pool_ = vk::raii::DescriptorPool(
        gpu.device, {vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes});
    set_ = std::move(vk::raii::DescriptorSets(gpu.device, {*pool_, *set_layout_})[0]);
    for (std::size_t i = 0; i < textures_.size(); ++i) {
        const vk::DescriptorImageInfo image({}, *textures_[i]->view,
                                            vk::ImageLayout::eShaderReadOnlyOptimal);
        const auto binding = kFirstImageBinding + static_cast<std::uint32_t>(i);
        gpu.device.updateDescriptorSets(
            vk::WriteDescriptorSet(*set_, binding, 0, vk::DescriptorType::eCombinedImageSampler,
                                   image),
            {});
    }
}

void LoadedProgram::CreateComputePipeline(const Gpu& gpu, const Program& program) {
    const vk::raii::ShaderModule module = MakeModule(gpu, program.spirv);
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module,
                                                  "main");
    pipeline_ =
        vk::raii::Pipeline(gpu.device, nullptr, vk::ComputePipelineCreateInfo({}, stage, *layout_));
}

void LoadedProgram::CreateFragmentPipeline(const Gpu& gpu, const Program& program) {
    const vk::raii::ShaderModule vertex = MakeModule(gpu, kTriangle);
    const vk::raii::ShaderModule fragment = MakeModule(gpu, program.spirv);
    const std::array stages = {
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
        vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment,
                                          "main")};
    const vk::PipelineVertexInputStateCreateInfo vertex_input;
    const vk::PipelineInputAssemblyStateCreateInfo assembly({},
                                                            vk::PrimitiveTopology::eTriangleList);
    const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.lineWidth = 1.0f;
    const vk::PipelineMultisampleStateCreateInfo samples({}, vk::SampleCountFlagBits::e1);
    const vk::PipelineColorBlendStateCreateInfo blend;
    const std::array dynamic_states = {vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic({}, dynamic_states);
    const vk::GraphicsPipelineCreateInfo create({}, stages, &vertex_input, &assembly, nullptr,
                                                &viewport, &rasterization, &samples, nullptr,
                                                &blend, &dynamic, *layout_, *gpu.render_pass);
    pipeline_ = vk::raii::Pipeline(gpu.device, nullptr, create);
}

void LoadedProgram::UseBuffers(const Gpu& gpu, vk::Buffer inputs, vk::Buffer outputs,
                               std::uint64_t generation) {
    if (generation == generation_) {
        return;
    }
    const std::array buffers = {vk::DescriptorBufferInfo(inputs, 0, VK_WHOLE_SIZE),
                                vk::DescriptorBufferInfo(outputs, 0, VK_WHOLE_SIZE)};
    gpu.device.updateDescriptorSets(
        vk::WriteDescriptorSet(*set_, 0, 0, vk::DescriptorType::eStorageBuffer, {}, buffers), {});
    generation_ = generation;
}

void LoadedProgram::Record(const Gpu& gpu, vk::raii::CommandBuffer& commands,
                           std::uint32_t rows) const {
    const bool compute = stage_ == Stage::kCompute;
    const auto point = compute ? vk::PipelineBindPoint::eCompute : vk::PipelineBindPoint::eGraphics;
    commands.bindPipeline(point, *pipeline_);
    commands.bindDescriptorSets(point, *layout_, 0, *set_, {});
    if (compute) {
        commands.dispatch(GroupsFor(rows, kLocalSize), 1, 1);
    } else {
        const std::uint32_t lines = GroupsFor(rows, kFragmentWidth);
        const vk::Rect2D area({0, 0}, {kFragmentWidth, lines});
        commands.setViewport(0, vk::Viewport(0, 0, static_cast<float>(kFragmentWidth),
                                             static_cast<float>(lines), 0, 1));
        commands.setScissor(0, area);
        commands.beginRenderPass({*gpu.render_pass, *gpu.framebuffer, area},
                                 vk::SubpassContents::eInline);
        commands.draw(3, 1, 0, 0);
        commands.endRenderPass();
    }
    // A fence alone does not make shader writes visible to the host.
    commands.pipelineBarrier(
        compute ? vk::PipelineStageFlagBits::eComputeShader
                : vk::PipelineStageFlagBits::eFragmentShader,
        vk::PipelineStageFlagBits::eHost, {},
        vk::MemoryBarrier(vk::AccessFlagBits::eShaderWrite, vk::AccessFlagBits::eHostRead), {}, {});
}

}  // namespace etalon
