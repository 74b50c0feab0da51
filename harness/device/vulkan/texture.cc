#include "device/vulkan/texture.h"

#include <cstring>
#include <optional>
#include <string>

#include "device/vulkan/host_buffer.h"

namespace etalon {
namespace {

constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Sfloat;
constexpr vk::ImageSubresourceRange kWhole(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);

std::optional<std::string> WhyNot(const Gpu& gpu, const BoundImage& bound) {
    const std::string subject = "image '" + bound.name + "': ";
    const vk::FormatFeatureFlags needs = vk::FormatFeatureFlagBits::eSampledImage |
                                         vk::FormatFeatureFlagBits::eSampledImageFilterLinear |
                                         vk::FormatFeatureFlagBits::eTransferDst;
    const vk::FormatProperties offers = gpu.physical.getFormatProperties(kFormat);
    if ((offers.optimalTilingFeatures & needs) != needs) {
        return subject + "the device cannot filter binary32";
    }
    const std::uint32_t most = gpu.limits.maxImageDimension2D;
    const Image& image = *bound.image;
    if (image.width == 0 || image.height == 0 || image.width > most || image.height > most) {
        return subject + std::to_string(image.width) + " x " + std::to_string(image.height) +
               " is outside of the device's 1 to " + std::to_string(most);
    }
    return std::nullopt;
}

void Move(vk::raii::CommandBuffer& commands, vk::Image image, vk::ImageLayout from,
          vk::ImageLayout to) {
    // Every stage and access: an upload happens once for a program.
    const vk::AccessFlags any = vk::AccessFlagBits::eMemoryRead | vk::AccessFlagBits::eMemoryWrite;
    commands.pipelineBarrier(vk::PipelineStageFlagBits::eAllCommands,
                             vk::PipelineStageFlagBits::eAllCommands, {}, {}, {},
                             vk::ImageMemoryBarrier(any, any, from, to, VK_QUEUE_FAMILY_IGNORED,
                                                    VK_QUEUE_FAMILY_IGNORED, image, kWhole));
}

}  // namespace

DeviceResult<Texture> UploadTexture(Gpu& gpu, const BoundImage& bound) {
    ETALON_CHECK(bound.image != nullptr);
    const Image& source = *bound.image;
    ETALON_CHECK(source.rgba.size() == std::size_t{4} * source.width * source.height);
    if (const auto reason = WhyNot(gpu, bound)) {
        return Unsupported(*reason);
    }
    const vk::Extent3D extent(source.width, source.height, 1);
    Texture texture;
    texture.image = vk::raii::Image(
        gpu.device, vk::ImageCreateInfo(
                        {}, vk::ImageType::e2D, kFormat, extent, 1, 1, vk::SampleCountFlagBits::e1,
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

    const HostBuffer staging(gpu, source.rgba.size() * sizeof(float),
                             vk::BufferUsageFlagBits::eTransferSrc, HostBuffer::Use::kWrite);
    std::memcpy(staging.words(), source.rgba.data(), staging.bytes());
    staging.Flush();
    gpu.Execute([&](vk::raii::CommandBuffer& commands) {
        Move(commands, *texture.image, vk::ImageLayout::eUndefined,
             vk::ImageLayout::eTransferDstOptimal);
        commands.copyBufferToImage(
            staging.buffer(), *texture.image, vk::ImageLayout::eTransferDstOptimal,
            vk::BufferImageCopy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, extent));
        Move(commands, *texture.image, vk::ImageLayout::eTransferDstOptimal,
             vk::ImageLayout::eShaderReadOnlyOptimal);
    });
    texture.view = vk::raii::ImageView(
        gpu.device,
        vk::ImageViewCreateInfo({}, *texture.image, vk::ImageViewType::e2D, kFormat, {}, kWhole));
    texture.sampler = vk::raii::Sampler(
        gpu.device,
        vk::SamplerCreateInfo({}, vk::Filter::eLinear, vk::Filter::eLinear,
                              vk::SamplerMipmapMode::eNearest, vk::SamplerAddressMode::eRepeat,
                              vk::SamplerAddressMode::eRepeat, vk::SamplerAddressMode::eRepeat));
    return texture;
}

}  // namespace etalon
