// HostBuffer: a storage or transfer buffer in memory that the host sees, mapped as long as it
// lives.
#pragma once

#include <span>

#include "device/vulkan/gpu.h"

namespace etalon {

class HostBuffer {
  public:
    // What the host does with it: memory with a cache is far faster to read.
    enum class Use : std::uint8_t { kWrite, kRead };

    // Throws vk::SystemError.
    HostBuffer(const Gpu& gpu, std::uint64_t bytes, vk::BufferUsageFlags usage, Use use);

    vk::Buffer buffer() const { return *buffer_; }
    std::uint64_t bytes() const { return bytes_; }
    std::uint32_t* words() const { return words_; }

    // After the host wrote, before the device reads.
    void Flush() const;
    // After the device wrote, before the host reads.
    void Invalidate() const;

  private:
    std::uint64_t bytes_;
    vk::raii::Buffer buffer_;
    vk::raii::DeviceMemory memory_ = nullptr;
    const vk::raii::Device* device_;
    std::uint32_t* words_ = nullptr;
    bool coherent_ = true;
};

}  // namespace etalon
