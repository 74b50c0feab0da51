#include "device/gl/gl_device.h"

#include <algorithm>
#include <cstdlib>

#include "device/gl/gl_context.h"
#include "device/gl/gl_error.h"
#include "device/gl/gl_fragment.h"
#include "device/gl/gl_images.h"
#include "device/gl/gl_info.h"
#include "device/gl/gl_storage.h"

namespace etalon {
namespace {

class GlDevice final : public Device {
  public:
    GlDevice(std::unique_ptr<GlContext> context, DeviceInfo info, const GlLimits& limits)
        : context_(std::move(context)),
          info_(std::move(info)),
          has_timer_queries_(HasTimerQueries(context_->gl(), info_)),
          textures_(context_->gl(), limits),
          targets_(context_->gl(), limits, textures_, info_.glsl_version),
          storage_(context_->gl(), limits, textures_) {
        // Core profiles draw nothing without a vertex array, even an empty one.
        GLuint vertex_array = 0;
        context_->gl().GenVertexArrays(1, &vertex_array);
        context_->gl().BindVertexArray(vertex_array);
        // As Vulkan filters cubes always.
        context_->gl().Enable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    }

    const DeviceInfo& info() const override { return info_; }

    DeviceResult<std::uint32_t> Load(const Program& program) override {
        ETALON_CHECK(program.output_words > 0);
        const bool compute = program.stage == Stage::kCompute;
        const bool spirv = program.form == Form::kSpirv;
        if (compute && !info_.Has("compute")) {
            return Unsupported("the device has no compute stage");
        }
        if (spirv && !info_.Has("spirv")) {
            return Unsupported("the device does not take SPIR-V");
        }
        ETALON_TRY(loaded, compute || spirv ? storage_.Load(program) : targets_.Load(program));
        programs_.push_back({std::move(loaded), program.input_words, program.output_words});
        return static_cast<std::uint32_t>(programs_.size() - 1);
    }

    DeviceResult<Nothing> Run(std::uint32_t handle, std::uint32_t rows,
                              std::span<const std::uint32_t> inputs,
                              std::span<std::uint32_t> outputs, RunTime* time) override {
        ETALON_CHECK(handle < programs_.size());
        const Loaded& loaded = programs_[handle];
        ETALON_CHECK(rows > 0 && rows <= info_.max_rows);
        ETALON_CHECK(inputs.size() == std::size_t{rows} * loaded.input_words);
        ETALON_CHECK(outputs.size() == std::size_t{rows} * loaded.output_words);
        const std::uint32_t most = loaded.program->max_rows();
        // Without inputs, the results depend on the row's number.
        if (most == 0 || (most < rows && loaded.input_words == 0)) {
            return Unsupported("the device evaluates at most " + std::to_string(most) +
                               " rows of this program at once");
        }
        GlTimer timer(context_->gl(), has_timer_queries_, time);
        Batch batch{inputs.data(), outputs.data(), rows, 0, 0};
        for (; batch.begin < rows; batch.begin += batch.rows) {
            batch.rows = std::min(most, rows - batch.begin);
            ETALON_TRY_STEP(loaded.program->Evaluate(batch, timer));
        }
        return Ok();
    }

  private:
    struct Loaded {
        std::unique_ptr<GlProgram> program;
        std::uint32_t input_words;
        std::uint32_t output_words;
    };

    std::unique_ptr<GlContext> context_;  // first, so that it ends last
    DeviceInfo info_;
    bool has_timer_queries_;
    GlTextures textures_;
    Targets targets_;
    Storage storage_;
    std::vector<Loaded> programs_;
};

}  // namespace

std::string GlContext::Renderer() const {
    const GLubyte* renderer = gl_.GetString(GL_RENDERER);
    return renderer != nullptr ? reinterpret_cast<const char*>(renderer) : "";
}

bool IsSoftwareRenderer(const std::string& renderer, const std::string& hint) {
    return renderer.starts_with(hint) &&
           (hint != "zink" || renderer.find("llvmpipe") != std::string::npos);
}

std::string DeviceName(const std::string& name, const Candidate& candidate) {
    return candidate.driver.empty() ? name : name + "@" + candidate.driver;
}

std::string EnvironmentValue(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

DeviceResult<std::unique_ptr<Device>> MakeGlDevice(std::unique_ptr<GlContext> context,
                                                   std::string name, std::uint32_t siblings) {
    const GlFunctions& gl = context->gl();
    DeviceInfo info = DescribeContext(gl);
    info.name = std::move(name);
    info.siblings = siblings;
    const GlLimits limits = ReadLimits(gl, info);
    if (limits.groups > 0) {
        info.max_rows = static_cast<std::uint32_t>(
            std::min(std::uint64_t{info.max_rows}, std::uint64_t{limits.groups} * kLocalSize));
    }
    ETALON_TRY_STEP(CheckGl(gl, "describing the context"));
    auto device = std::make_unique<GlDevice>(std::move(context), std::move(info), limits);
    ETALON_TRY_STEP(CheckGl(gl, "preparing the device"));
    return std::unique_ptr<Device>(std::move(device));
}

}  // namespace etalon
