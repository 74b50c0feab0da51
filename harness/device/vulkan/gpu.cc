#include "device/vulkan/gpu.h"

#include <dlfcn.h>
#include <stdlib.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <stdexcept>

#include "device/vulkan/description.h"
#include "device/vulkan/icd.h"

namespace etalon {
namespace {

using Kind = DeviceFailure::Kind;

constexpr std::uint32_t kTimestamps = 2;  // before and after

struct CloseLibrary {
    void operator()(void* handle) const { dlclose(handle); }
};
using Library = std::unique_ptr<void, CloseLibrary>;

// Loads the driver's library ahead of the loader, which would only say that no driver is
// compatible.
DeviceResult<Library> OpenLibrary(const std::string& path) {
    Library library(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library) {
        return Unsupported(dlerror());
    }
    return library;
}

// Throws std::runtime_error where there is no loader.
DeviceResult<Nothing> CreateInstance(Gpu& gpu) {
    const std::uint32_t version =
        std::min(gpu.context.enumerateInstanceVersion(), std::uint32_t{VK_API_VERSION_1_3});
    if (version < VK_API_VERSION_1_1) {
        return Unsupported("the Vulkan loader has version 1.0, 1.1 is needed");
    }
    const vk::ApplicationInfo application("etalon", 1, "etalon", 1, version);
    gpu.instance = vk::raii::Instance(gpu.context, vk::InstanceCreateInfo({}, &application));
    return Ok();
}

// The candidate's hint is a manifest, or the library of a driver under a prefix.
DeviceResult<std::unique_ptr<Gpu>> LoadDriver(const Candidate& candidate) {
    std::string path = candidate.hint;
    const bool is_manifest = candidate.hint.ends_with(".json");
    if (is_manifest) {
        const Result<IcdManifest> manifest = ReadIcdManifest(candidate.hint);
        if (!manifest) {
            return Unsupported(manifest.error().message);
        }
        path = manifest->library;
    }
    // Stays until the instance has its own hold, so that it is loaded once.
    const DeviceResult<Library> library = OpenLibrary(path);
    if (!library) {
        return library.error();
    }
    std::optional<TemporaryManifest> temporary;
    if (!is_manifest) {
        Result<TemporaryManifest> written = TemporaryManifest::Write(path);
        if (!written) {
            return Unsupported(written.error().message);
        }
        temporary.emplace(std::move(*written));
        setenv("VK_DRIVER_FILES", temporary->file().c_str(), 1);
        setenv("VK_ICD_FILENAMES", temporary->file().c_str(), 1);
    }
    try {
        auto gpu = std::make_unique<Gpu>();
        ETALON_TRY_STEP(CreateInstance(*gpu));
        return gpu;
    } catch (const vk::SystemError&) {
        throw;
    } catch (const std::runtime_error&) {
        return Unsupported("the Vulkan loader, libvulkan.so.1, is not installed");
    }
}

std::vector<vk::raii::PhysicalDevice> FindDevices(const Gpu& gpu) {
    try {
        return gpu.instance.enumeratePhysicalDevices();
    } catch (const vk::InitializationFailedError&) {
        // The loader's word for a driver that finds none of its hardware.
        return {};
    }
}

void CreateDevice(Gpu& gpu, const Description& description) {
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue({}, description.queue_family, 1, &priority);
    vk::PhysicalDeviceShaderFloat16Int8Features small;
    small.shaderFloat16 = description.info.Has("float16");
    small.shaderInt8 = description.info.Has("int8");
    vk::PhysicalDeviceFeatures2 features;
    features.features = description.features;
    if (small.shaderFloat16 || small.shaderInt8) {
        features.pNext = &small;
    }
    std::vector<const char*> extensions;
    for (const std::string& extension : description.extensions) {
        extensions.push_back(extension.c_str());
    }
    vk::DeviceCreateInfo create({}, queue, {}, extensions);
    create.pNext = &features;
    gpu.device = vk::raii::Device(gpu.physical, create);
    gpu.queue = vk::raii::Queue(gpu.device, description.queue_family, 0);
    gpu.command_pool = vk::raii::CommandPool(
        gpu.device, {vk::CommandPoolCreateFlagBits::eResetCommandBuffer, description.queue_family});
    gpu.commands = std::move(vk::raii::CommandBuffers(
        gpu.device, {*gpu.command_pool, vk::CommandBufferLevel::ePrimary, 1})[0]);
    gpu.done = vk::raii::Fence(gpu.device, vk::FenceCreateInfo());
    if (description.timestamp_bits > 0) {
        gpu.timestamps =
            vk::raii::QueryPool(gpu.device, {{}, vk::QueryType::eTimestamp, kTimestamps});
        gpu.timestamp_mask = ~std::uint64_t{0} >> (64 - description.timestamp_bits);
    }
}

void CreateFramebuffer(Gpu& gpu) {
    const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics);
    gpu.render_pass = vk::raii::RenderPass(gpu.device, vk::RenderPassCreateInfo({}, {}, subpass));
    const std::uint32_t lines = (gpu.info.max_rows + kFragmentWidth - 1) / kFragmentWidth;
    gpu.framebuffer = vk::raii::Framebuffer(
        gpu.device, vk::FramebufferCreateInfo({}, *gpu.render_pass, {}, kFragmentWidth, lines, 1));
}

}  // namespace

void Gpu::MarkBegin() {
    if (timestamp_mask != 0) {
        commands.resetQueryPool(*timestamps, 0, kTimestamps);
        commands.writeTimestamp(vk::PipelineStageFlagBits::eTopOfPipe, *timestamps, 0);
    }
}

void Gpu::MarkEnd() {
    if (timestamp_mask != 0) {
        commands.writeTimestamp(vk::PipelineStageFlagBits::eBottomOfPipe, *timestamps, 1);
    }
}

void Gpu::SubmitAndWait(RunTime* time) {
    const Stopwatch stopwatch;
    queue.submit(vk::SubmitInfo({}, {}, *commands), *done);
    while (device.waitForFences(*done, VK_TRUE, std::numeric_limits<std::uint64_t>::max()) ==
           vk::Result::eTimeout) {
    }
    if (time != nullptr) {
        *time = stopwatch.Read();
        if (timestamp_mask != 0) {
            const auto [result, ticks] = timestamps.getResults<std::uint64_t>(
                0, kTimestamps, kTimestamps * sizeof(std::uint64_t), sizeof(std::uint64_t),
                vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
            const std::uint64_t elapsed = (ticks[1] - ticks[0]) & timestamp_mask;
            time->seconds = static_cast<double>(elapsed) * double{limits.timestampPeriod} * 1e-9;
            time->clock = RunTime::Clock::kDevice;
        }
    }
    device.resetFences(*done);
}

std::optional<std::uint32_t> Gpu::MemoryType(std::uint32_t bits,
                                             vk::MemoryPropertyFlags flags) const {
    for (std::uint32_t type = 0; type < memory.memoryTypeCount; ++type) {
        if ((bits >> type & 1) != 0 && (memory.memoryTypes[type].propertyFlags & flags) == flags) {
            return type;
        }
    }
    return std::nullopt;
}

DeviceResult<std::unique_ptr<Gpu>> OpenGpu(const Candidate& candidate) {
    DeviceResult<std::unique_ptr<Gpu>> opened =
        Guard(Kind::kUnsupported, [&]() -> DeviceResult<std::unique_ptr<Gpu>> {
            ETALON_TRY(gpu, LoadDriver(candidate));
            const std::vector<vk::raii::PhysicalDevice> devices = FindDevices(*gpu);
            if (candidate.index >= devices.size()) {
                return Unsupported(devices.empty() ? "the driver finds no device of its kind"
                                                   : "the driver has no device number " +
                                                         std::to_string(candidate.index));
            }
            ETALON_TRY(description, Describe(devices, candidate));
            gpu->physical = devices[candidate.index];
            gpu->limits = gpu->physical.getProperties().limits;
            gpu->memory = gpu->physical.getMemoryProperties();
            gpu->spirv_version = description.spirv_version;
            gpu->info = description.info;
            CreateDevice(*gpu, description);
            if (gpu->info.Has("fragment")) {
                CreateFramebuffer(*gpu);
            }
            return std::move(gpu);
        });
    // Reasons of the file system and of dlopen may begin with the file already.
    if (!opened && !opened.error().reason.starts_with(candidate.hint)) {
        return DeviceFailure{opened.error().kind, candidate.hint + ": " + opened.error().reason};
    }
    return opened;
}

}  // namespace etalon
