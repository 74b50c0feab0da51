#include "device/cpu/cpu_device.h"

#include <memory>
#include <utility>
#include <vector>

#include "evaluate/evaluate.h"
#include "spirv/read.h"

namespace etalon {
namespace {

DeviceFailure Unsupported(const Error& error) {
    return {DeviceFailure::Kind::kUnsupported, error.message};
}

class CpuDevice : public Device {
  public:
    CpuDevice() {
        info_.name = "cpu";
        info_.description = "Etalon's evaluator in binary32";
        info_.driver = "etalon";
        info_.version = "1";
        info_.api = "none";
        info_.on_host = true;
        info_.features = {"compute", "spirv"};
        info_.float_controls = {"DenormPreserve", "SignedZeroInfNanPreserve", "RoundingModeRTE"};
    }

    const DeviceInfo& info() const override { return info_; }

    DeviceResult<std::uint32_t> Load(const Program& program) override {
        if (program.form != Form::kSpirv || program.stage != Stage::kCompute) {
            return DeviceFailure{DeviceFailure::Kind::kUnsupported,
                                 "only compute probes in SPIR-V are evaluated"};
        }
        Result<spirv::Module> module = spirv::ReadModule(program.spirv);
        if (!module) {
            return Unsupported(module.error());
        }
        Result<std::shared_ptr<const evaluate::Plan>> plan = evaluate::MakePlan(std::move(*module));
        if (!plan) {
            return Unsupported(plan.error());
        }
        std::vector<evaluate::Texture> images;
        for (const BoundImage& image : program.images) {
            images.push_back({image.image, image.sampling});
        }
        if (images.size() < (*plan)->images) {
            return Unsupported(Error{"the program names more images than it brings"});
        }
        loaded_.push_back(std::make_unique<evaluate::Evaluator<float>>(*plan, std::move(images)));
        return static_cast<std::uint32_t>(loaded_.size() - 1);
    }

    DeviceResult<Nothing> Run(std::uint32_t handle, std::uint32_t rows,
                              std::span<const std::uint32_t> inputs,
                              std::span<std::uint32_t> outputs, RunTime* time) override {
        ETALON_CHECK(handle < loaded_.size());
        const Stopwatch stopwatch;
        if (auto done = loaded_[handle]->Run({rows, inputs, outputs}); !done) {
            return DeviceFailure{DeviceFailure::Kind::kStopped, done.error().message};
        }
        if (time != nullptr) {
            *time = stopwatch.Read();
        }
        return Ok();
    }

  private:
    DeviceInfo info_;
    std::vector<std::unique_ptr<evaluate::Evaluator<float>>> loaded_;  // by handle
};

}  // namespace

std::vector<Candidate> CpuCandidates(const Driver& driver) {
    if (!driver.name.empty()) {
        return {};
    }
    Candidate candidate;
    candidate.backend = "cpu";
    return {candidate};
}

DeviceResult<std::unique_ptr<Device>> OpenCpuDevice(const Candidate&) {
    return std::unique_ptr<Device>(std::make_unique<CpuDevice>());
}

}  // namespace etalon
