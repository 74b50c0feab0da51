#include "device/vulkan/texture.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

#include "device/vulkan/host_buffer.h"

namespace etalon {
namespace {

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;

vk::ImageSubresourceRange WholeOf(const Image& image) {
    return {vk::ImageAspectFlagBits::eColor, 0, image.levels, 0, FaceCount(image)};
}

std::optional<std::string> WhyNot(const Gpu& gpu, const BoundImage& bound) {
    const std::string subject = "image '" + bound.name + "': ";
    vk::FormatFeatureFlags needs =
        vk::FormatFeatureFlagBits::eSampledImage | vk::FormatFeatureFlagBits::eTransferDst;
    if (bound.sampling.filter == Filter::kLinear) {
        needs |= vk::FormatFeatureFlagBits::eSampledImageFilterLinear;
    }
    const vk::FormatProperties offers = gpu.physical.getFormatProperties(kFormat);
    if ((offers.optimalTilingFeatures & needs) != needs) {
        return subject + "the device cannot filter binary32";
    }
    const Image& image = *bound.image;
    const std::uint32_t most = image.shape == ImageShape::kCube ? gpu.limits.maxImageDimensionCube
                                                                : gpu.limits.maxImageDimension2D;
    if (std::max(image.width, image.height) > most) {
        return subject + std::to_string(image.width) + " x " + std::to_string(image.height) +
               " is outside of the device's 1 to " + std::to_string(most);
    }
    return std::nullopt;
}

void Move(vk::raii::CommandBuffer& commands, const Texture& texture, const Image& source,
          vk::ImageLayout from, vk::ImageLayout to) {
    // Every stage and access: an upload happens once for an image.
    const vk::AccessFlags any = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
    commands.pipelineBarrier(
        vk::PipelineStageFlagBits::eAllCommands, vk::PipelineStageFlagBits::eAllCommands, {}, {},
        {},
        vk::ImageMemoryBarrier(any, any, from, to, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED,
                               *texture.image, WholeOf(source)));
}

void Allocate(const Gpu& gpu, const Image& source, Texture& texture) {
    const bool is_cube = source.shape == ImageShape::kCube;
    texture.image = vk::raii::Image(
        gpu.device, vk::ImageCreateInfo(
                        is_cube ? vk::ImageCreateFlagBits::eCubeCompatible : vk::ImageCreateFlags(),
                        vk::ImageType::e2D, kFormat, vk::Extent3D(source.width, source.height, 1),
                        source.levels, FaceCount(source), vk::SampleCountFlagBits::e1,
                        vk::ImageTiling::eOptimal,
                        vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst));
    const vk::MemoryRequirements needs = texture.image.getMemoryRequirements();
    auto type = gpu.MemoryType(needs.memoryTypeBits, vk::MemoryPropertyFlagBits::eDeviceLocal);
    if (!type) {
        type = gpu.MemoryType(needs.memoryTypeBits, {});
    }
    ETALON_CHECK(type.has_value());
    texture.memory = vk::raii::DeviceMemory(gpu.device, {needs.size, *type});
    texture.image.bindMemory(*texture.memory, 0);
}

// A level's faces lie in the buffer one after the other, as Vulkan's layers do.
void Fill(Gpu& gpu, const Image& source, const Texture& texture) {
    const HostBuffer staging(gpu, source.rgba.size() * sizeof(float),
                             vk::BufferUsageFlagBits::eTransferSrc, HostBuffer::Use::kWrite);
    std::memcpy(staging.words(), source.rgba.data(), source.rgba.size() * sizeof(float));
    staging.Flush();
    std::vector<vk::BufferImageCopy> levels;
    for (std::uint32_t level = 0; level < source.levels; ++level) {
        const ImageSize size = LevelSize(source, level);
        levels.emplace_back(LevelStart(source, level) * sizeof(float), 0, 0,
                            vk::ImageSubresourceLayers(vk::ImageAspectFlagBits::eColor, level, 0,
                                                       FaceCount(source)),
                            vk::Offset3D(), vk::Extent3D(size.width, size.height, 1));
    }
    gpu.Execute([&](vk::raii::CommandBuffer& commands) {
        Move(commands, texture, source, vk::ImageLayout::eUndefined,
             vk::ImageLayout::eTransferDstOptimal);
        commands.copyBufferToImage(staging.buffer(), *texture.image,
                                   vk::ImageLayout::eTransferDstOptimal, levels);
        Move(commands, texture, source, vk::ImageLayout::eTransferDstOptimal,
             vk::ImageLayout::eShaderReadOnlyOptimal);
    });
}

vk::SamplerCreateInfo SamplerOf(const Sampling& sampling) {
    const bool linear = sampling.filter == Filter::kLinear;
    const vk::Filter filter = linear ? vk::Filter::eLinear : vk::Filter::eNearest;
    const vk::SamplerAddressMode wrap = sampling.wrap == Wrap::kRepeat
                                            ? vk::SamplerAddressMode::eRepeat
                                            : vk::SamplerAddressMode::eClampToEdge;
    vk::SamplerCreateInfo create(
        {}, filter, filter,
        linear ? vk::SamplerMipmapMode::eLinear : vk::SamplerMipmapMode::eNearest, wrap, wrap,
        wrap);
    create.maxLod = VK_LOD_CLAMP_NONE;
    return create;
}

}  // namespace

DeviceResult<std::shared_ptr<const Texture>> Textures::Take(Gpu& gpu, Stage stage,
                                                            const BoundImage& bound) {
    ETALON_CHECK(bound.image != nullptr && IsWhole(*bound.image));
    for (const Known& known : known_) {
        if (known.stage == stage && known.sampling == bound.sampling &&
            AreSame(*known.image, *bound.image)) {
            return known.texture;
        }
    }
    if (const auto reason = WhyNot(gpu, bound)) {
        return Unsupported(*reason);
    }
    const Image& source = *bound.image;
    Texture texture;
    Allocate(gpu, source, texture);
    Fill(gpu, source, texture);
    const auto type =
        source.shape == ImageShape::kCube ? vk::ImageViewType::eCube : vk::ImageViewType::e2D;
    texture.view = vk::raii::ImageView(
        gpu.device,
        vk::ImageViewCreateInfo({}, *texture.image, type, kFormat, {}, WholeOf(source)));
    texture.sampler = vk::raii::Sampler(gpu.device, SamplerOf(bound.sampling));
    known_.push_back(
        {bound.image, bound.sampling, stage, std::make_shared<const Texture>(std::move(texture))});
    return known_.back().texture;
}

}  // namespace etalon
