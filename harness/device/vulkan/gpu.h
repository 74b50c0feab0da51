// Gpu: one logical device with one queue, and all that programs on it share.
#pragma once

#include <memory>
#include <optional>

#include "device/backends.h"
#include "device/vulkan/vulkan.h"

namespace etalon {

// Members are destroyed from the last to the first, as Vulkan wants it.
struct Gpu {
    vk::raii::Context context;
    vk::raii::Instance instance = nullptr;
    vk::raii::PhysicalDevice physical = nullptr;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::CommandPool command_pool = nullptr;
    vk::raii::CommandBuffer commands = nullptr;
    vk::raii::Fence done = nullptr;
    vk::raii::QueryPool timestamps = nullptr;  // two; null where the queue has none
    // No attachments; covers max_rows pixels. Null where fragment probes cannot run.
    vk::raii::RenderPass render_pass = nullptr;
    vk::raii::Framebuffer framebuffer = nullptr;

    vk::PhysicalDeviceLimits limits;
    std::uint64_t timestamp_mask = 0;  // of the bits that count
    vk::PhysicalDeviceMemoryProperties memory;
    std::uint32_t spirv_version = 0;  // the highest taken: major << 16 | minor << 8
    DeviceInfo info;

    // Records with `record`, submits, and waits until all is done, however long it takes: the
    // judging process ends a worker that takes too long. Where `time` is not null, what was
    // recorded is timed.
    template <typename Record>
    void Execute(Record&& record, RunTime* time = nullptr) {
        commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        if (time != nullptr) {
            MarkBegin();
        }
        record(commands);
        if (time != nullptr) {
            MarkEnd();
        }
        commands.end();
        SubmitAndWait(time);
    }

    // The first type of memory that `bits` allows and that has all of `flags`.
    std::optional<std::uint32_t> MemoryType(std::uint32_t bits,
                                            vk::MemoryPropertyFlags flags) const;

  private:
    void MarkBegin();
    void MarkEnd();
    void SubmitAndWait(RunTime* time);
};

// Opens device number candidate.index of the candidate's driver.
DeviceResult<std::unique_ptr<Gpu>> OpenGpu(const Candidate& candidate);

}  // namespace etalon
