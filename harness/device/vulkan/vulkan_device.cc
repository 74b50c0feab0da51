#include "device/vulkan/vulkan_device.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "device/vulkan/capability.h"
#include "device/vulkan/gpu.h"
#include "device/vulkan/host_buffer.h"
#include "device/vulkan/loaded_program.h"

namespace etalon {
namespace {

using Kind = DeviceFailure::Kind;

constexpr std::uint64_t kSmallestBuffer = 1u << 16;

// Stands in the outputs before a run, a NaN: results of an earlier program must not pass for those
// of one that the driver silently dropped.
constexpr std::uint32_t kUnwritten = 0xffffdead;

class VulkanDevice final : public Device {
  public:
    explicit VulkanDevice(std::unique_ptr<Gpu> gpu) : gpu_(std::move(gpu)) {}

    const DeviceInfo& info() const override { return gpu_->info; }

    DeviceResult<std::uint32_t> Load(const Program& program) override {
        if (const std::optional<std::string> reason = WhyNot(program)) {
            return Unsupported(*reason);
        }
        return Guard(Kind::kRejected, [&]() -> DeviceResult<std::uint32_t> {
            ETALON_TRY(loaded, LoadedProgram::Build(*gpu_, textures_, program));
            programs_.push_back(std::move(loaded));
            return static_cast<std::uint32_t>(programs_.size() - 1);
        });
    }

    DeviceResult<Nothing> Run(std::uint32_t handle, std::uint32_t rows,
                              std::span<const std::uint32_t> inputs,
                              std::span<std::uint32_t> outputs, RunTime* time) override {
        ETALON_CHECK(handle < programs_.size());
        ETALON_CHECK(rows > 0 && rows <= info().max_rows);
        LoadedProgram& program = programs_[handle];
        ETALON_CHECK(inputs.size() == std::uint64_t{program.input_words()} * rows);
        ETALON_CHECK(outputs.size() == std::uint64_t{program.output_words()} * rows);
        const std::uint64_t input_bytes = inputs.size_bytes() + sizeof(rows);
        for (const std::uint64_t bytes : {input_bytes, std::uint64_t{outputs.size_bytes()}}) {
            if (bytes > gpu_->limits.maxStorageBufferRange) {
                return Unsupported("a buffer of " + std::to_string(bytes) +
                                   " bytes is larger than the device's " +
                                   std::to_string(gpu_->limits.maxStorageBufferRange));
            }
        }
        return Guard(Kind::kLost, [&]() -> DeviceResult<Nothing> {
            Reserve(inputs_, input_bytes, HostBuffer::Use::kWrite);
            Reserve(outputs_, outputs.size_bytes(), HostBuffer::Use::kRead);
            program.UseBuffers(*gpu_, inputs_->buffer(), outputs_->buffer(), generation_);
            inputs_->words()[0] = rows;
            std::copy(inputs.begin(), inputs.end(), inputs_->words() + 1);
            std::fill_n(outputs_->words(), outputs.size(), kUnwritten);
            inputs_->Flush();
            outputs_->Flush();
            gpu_->Execute(
                [&](vk::raii::CommandBuffer& commands) { program.Record(*gpu_, commands, rows); },
                time);
            outputs_->Invalidate();
            std::copy_n(outputs_->words(), outputs.size(), outputs.begin());
            return Ok();
        });
    }

  private:
    std::optional<std::string> WhyNot(const Program& program) const {
        if (program.form != Form::kSpirv) {
            return "Vulkan takes SPIR-V, not GLSL text";
        }
        if (program.stage == Stage::kFragment && !info().Has("fragment")) {
            return "the device cannot store from a fragment shader";
        }
        if (program.images.size() > gpu_->limits.maxPerStageDescriptorSamplers) {
            return "the device binds " +
                   std::to_string(gpu_->limits.maxPerStageDescriptorSamplers) + " images at most";
        }
        return Unsuitable(program.spirv, gpu_->spirv_version, info());
    }

    // Buffers are shared by all programs and grow by doubling, so that they are made a few times.
    void Reserve(std::optional<HostBuffer>& buffer, std::uint64_t bytes, HostBuffer::Use use) {
        if (buffer && buffer->bytes() >= bytes) {
            return;
        }
        const std::uint64_t size = std::min<std::uint64_t>(
            std::bit_ceil(std::max(bytes, kSmallestBuffer)), gpu_->limits.maxStorageBufferRange);
        buffer.reset();
        buffer.emplace(*gpu_, size, vk::BufferUsageFlagBits::eStorageBuffer, use);
        ++generation_;
    }

    std::unique_ptr<Gpu> gpu_;
    Textures textures_;
    std::vector<LoadedProgram> programs_;
    std::optional<HostBuffer> inputs_;
    std::optional<HostBuffer> outputs_;
    std::uint64_t generation_ = 0;
};

}  // namespace

DeviceResult<std::unique_ptr<Device>> OpenVulkanDevice(const Candidate& candidate) {
    ETALON_TRY(gpu, OpenGpu(candidate));
    return std::unique_ptr<Device>(std::make_unique<VulkanDevice>(std::move(gpu)));
}

}  // namespace etalon
