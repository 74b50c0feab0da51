#include "device/vulkan/host_buffer.h"

#include <array>

namespace etalon {
namespace {

using Flag = vk::MemoryPropertyFlagBits;

// Vulkan guarantees a type that is visible and coherent for every buffer.
std::uint32_t ChooseType(const Gpu& gpu, std::uint32_t bits, HostBuffer::Use use) {
    const vk::MemoryPropertyFlags coherent = Flag::eHostVisible | Flag::eHostCoherent;
    const std::array wishes = {coherent | Flag::eHostCached,
                               Flag::eHostVisible | Flag::eHostCached};
    if (use == HostBuffer::Use::kRead) {
        for (const vk::MemoryPropertyFlags wish : wishes) {
            if (const auto type = gpu.MemoryType(bits, wish)) {
                return *type;
            }
        }
    }
    const auto type = gpu.MemoryType(bits, coherent);
    ETALON_CHECK(type.has_value());
    return *type;
}

}  // namespace

HostBuffer::HostBuffer(const Gpu& gpu, std::uint64_t bytes, vk::BufferUsageFlags usage, Use use)
    : bytes_(bytes),
      buffer_(gpu.device, vk::BufferCreateInfo({}, bytes, usage)),
      device_(&gpu.device) {
    const vk::MemoryRequirements needs = buffer_.getMemoryRequirements();
    const std::uint32_t type = ChooseType(gpu, needs.memoryTypeBits, use);
    memory_ = vk::raii::DeviceMemory(gpu.device, {needs.size, type});
    buffer_.bindMemory(*memory_, 0);
    words_ = static_cast<std::uint32_t*>(memory_.mapMemory(0, VK_WHOLE_SIZE));
    coherent_ = static_cast<bool>(gpu.memory.memoryTypes[type].propertyFlags & Flag::eHostCoherent);
}

void HostBuffer::Flush() const {
    if (!coherent_) {
        device_->flushMappedMemoryRanges(vk::MappedMemoryRange(*memory_, 0, VK_WHOLE_SIZE));
    }
}

void HostBuffer::Invalidate() const {
    if (!coherent_) {
        device_->invalidateMappedMemoryRanges(vk::MappedMemoryRange(*memory_, 0, VK_WHOLE_SIZE));
    }
}

}  // namespace etalon
