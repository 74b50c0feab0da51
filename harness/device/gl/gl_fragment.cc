#include "device/gl/gl_fragment.h"

#include <algorithm>
#include <bit>

#include "device/gl/gl_compile.h"
#include "device/gl/gl_error.h"
#include "device/gl/gl_images.h"
#include "device/gl/gl_triangle.h"

namespace etalon {
namespace {

constexpr std::uint32_t kWordsPerTarget = 4;
constexpr GLint kInputsUnit = 0;
static_assert(kInputsUnit < static_cast<GLint>(kFirstImageBinding));

// A batch of more lines only costs memory: 16 MiB for each target at this height.
constexpr std::uint32_t kMaxLines = 1024;

std::uint32_t DivideUp(std::uint32_t a, std::uint32_t b) {
    return (a + b - 1) / b;
}

}  // namespace

class FragmentProgram final : public GlProgram {
  public:
    FragmentProgram(Targets& targets, const Program& program, GLuint object,
                    std::vector<GlTexture> textures)
        : targets_(targets),
          gl_(targets.gl_),
          input_words_(program.input_words),
          output_words_(program.output_words),
          textures_(std::move(textures)),
          object_(object),
          rows_(gl_.GetUniformLocation(object, "etalon_rows")),
          lines_(gl_.GetUniformLocation(object, "etalon_lines")),
          first_(gl_.GetUniformLocation(object, "etalon_first")) {
        gl_.UseProgram(object_);
        gl_.Uniform1i(gl_.GetUniformLocation(object, "etalon_inputs"), kInputsUnit);
        NameSamplers(gl_, object, program.images);
        const std::uint32_t texture_size = targets.limits_.texture_size;
        // Baked-in inputs are chosen by the row, so that their rows cannot be split.
        const std::uint32_t lines =
            input_words_ == 0 ? texture_size : std::min(texture_size / input_words_, kMaxLines);
        max_rows_ = lines * kFragmentWidth;
    }

    std::uint32_t max_rows() const override { return max_rows_; }

    DeviceResult<Nothing> Evaluate(const Batch& batch, GlTimer& timer) override {
        const std::uint32_t lines = DivideUp(batch.rows, kFragmentWidth);
        const std::uint32_t words_at_once = std::min(output_words_, kTargetWords);
        ETALON_TRY_STEP(targets_.Reserve(input_words_ * lines,
                                         DivideUp(words_at_once, kWordsPerTarget), lines));
        BindTextures(gl_, textures_);
        ETALON_TRY_STEP(Upload(batch, lines));
        gl_.UseProgram(object_);
        gl_.Uniform1i(rows_, static_cast<GLint>(batch.rows));
        gl_.Uniform1i(lines_, static_cast<GLint>(lines));
        gl_.Viewport(0, 0, static_cast<GLsizei>(std::min(batch.rows, kFragmentWidth)),
                     static_cast<GLsizei>(lines));
        for (std::uint32_t first = 0; first < output_words_; first += kTargetWords) {
            gl_.Uniform1i(first_, static_cast<GLint>(first));
            timer.Start();
            gl_.DrawArrays(GL_TRIANGLES, 0, 3);
            timer.Stop();
            ETALON_TRY_STEP(CheckGl(gl_, "running the program"));
            const std::uint32_t end = std::min(first + kTargetWords, output_words_);
            for (std::uint32_t word = first; word < end; word += kWordsPerTarget) {
                ETALON_TRY_STEP(Download(batch, (word - first) / kWordsPerTarget, word,
                                         std::min(kWordsPerTarget, end - word)));
            }
        }
        return Ok();
    }

  private:
    DeviceResult<Nothing> Upload(const Batch& batch, std::uint32_t lines) {
        gl_.ActiveTexture(GL_TEXTURE0 + kInputsUnit);
        gl_.BindTexture(GL_TEXTURE_2D, targets_.inputs_);
        const std::uint32_t full_lines = batch.rows / kFragmentWidth;
        const std::uint32_t rest = batch.rows % kFragmentWidth;
        for (std::uint32_t column = 0; column < input_words_; ++column) {
            const std::uint32_t* words = batch.Input(column);
            Write(column * lines, kFragmentWidth, full_lines, words);
            Write(column * lines + full_lines, rest, 1,
                  words + std::size_t{full_lines} * kFragmentWidth);
        }
        return CheckGl(gl_, "writing the inputs");
    }

    void Write(std::uint32_t line, std::uint32_t width, std::uint32_t lines,
               const std::uint32_t* words) {
        if (width > 0 && lines > 0) {
            gl_.TexSubImage2D(GL_TEXTURE_2D, 0, 0, static_cast<GLint>(line),
                              static_cast<GLsizei>(width), static_cast<GLsizei>(lines),
                              GL_RED_INTEGER, GL_UNSIGNED_INT, words);
        }
    }

    // Words word .. word + count of every row, from one target.
    DeviceResult<Nothing> Download(const Batch& batch, std::uint32_t target, std::uint32_t word,
                                   std::uint32_t count) {
        const std::uint32_t width = std::min(batch.rows, kFragmentWidth);
        const std::uint32_t lines = DivideUp(batch.rows, kFragmentWidth);
        std::vector<std::uint32_t>& pixels = targets_.read_back_;
        pixels.resize(std::size_t{kWordsPerTarget} * width * lines);
        gl_.ReadBuffer(GL_COLOR_ATTACHMENT0 + target);
        gl_.ReadPixels(0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(lines),
                       GL_RGBA_INTEGER, GL_UNSIGNED_INT, pixels.data());
        ETALON_TRY_STEP(CheckGl(gl_, "reading the outputs"));
        for (std::uint32_t channel = 0; channel < count; ++channel) {
            std::uint32_t* to = batch.Output(word + channel);
            const std::uint32_t* from = pixels.data() + channel;
            for (std::uint32_t row = 0; row < batch.rows; ++row) {
                to[row] = from[std::size_t{kWordsPerTarget} * row];
            }
        }
        return Ok();
    }

    Targets& targets_;
    const GlFunctions& gl_;
    std::uint32_t input_words_;
    std::uint32_t output_words_;
    std::vector<GlTexture> textures_;
    GLuint object_;
    GLint rows_;  // locations; -1, which GL ignores, where the program has no use for them
    GLint lines_;
    GLint first_;
    std::uint32_t max_rows_ = 0;
};

Targets::Targets(const GlFunctions& gl, const GlLimits& limits, GlTextures& textures,
                 std::uint32_t glsl_version)
    : gl_(gl), limits_(limits), textures_(textures), glsl_version_(glsl_version) {
    gl_.GenFramebuffers(1, &framebuffer_);
}

DeviceResult<Nothing> Targets::Reserve(std::uint32_t input_lines, std::uint32_t count,
                                       std::uint32_t lines) {
    gl_.ActiveTexture(GL_TEXTURE0 + kInputsUnit);
    if (input_lines > input_capacity_) {
        input_capacity_ = std::min(std::bit_ceil(input_lines), limits_.texture_size);
        if (inputs_ == 0) {
            inputs_ = MakeTexture(gl_);
        }
        gl_.BindTexture(GL_TEXTURE_2D, inputs_);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R32UI, kFragmentWidth,
                       static_cast<GLsizei>(input_capacity_), 0, GL_RED_INTEGER, GL_UNSIGNED_INT,
                       nullptr);
    }
    gl_.BindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const bool higher = lines > capacity_;
    if (higher) {
        capacity_ = std::min(std::bit_ceil(lines), limits_.texture_size);
    }
    const std::size_t old_count = targets_.size();
    while (targets_.size() < count) {
        targets_.push_back(MakeTexture(gl_));
    }
    for (std::size_t i = higher ? 0 : old_count; i < targets_.size(); ++i) {
        gl_.BindTexture(GL_TEXTURE_2D, targets_[i]);
        gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32UI, kFragmentWidth,
                       static_cast<GLsizei>(capacity_), 0, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                       nullptr);
        gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i),
                                 GL_TEXTURE_2D, targets_[i], 0);
    }
    std::vector<GLenum> buffers(count);
    for (std::uint32_t i = 0; i < count; ++i) {
        buffers[i] = GL_COLOR_ATTACHMENT0 + i;
    }
    gl_.DrawBuffers(static_cast<GLsizei>(count), buffers.data());
    ETALON_TRY_STEP(CheckGl(gl_, "allocating the targets"));
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        return Unsupported("the device does not draw to unsigned 32-bit targets");
    }
    return Ok();
}

DeviceResult<std::unique_ptr<GlProgram>> Targets::Load(const Program& program) {
    if (limits_.texture_size < kFragmentWidth) {
        return Unsupported("the device's textures are too small");
    }
    if (limits_.targets * kWordsPerTarget < std::min(program.output_words, kTargetWords)) {
        return Unsupported("the device draws to " + std::to_string(limits_.targets) +
                           " targets only");
    }
    const std::string vertex = TriangleShader(glsl_version_, false);
    const ShaderSource sources[] = {{GL_VERTEX_SHADER, vertex, {}},
                                    {GL_FRAGMENT_SHADER, program.glsl, {}}};
    ETALON_TRY(object, BuildProgram(gl_, sources, false));
    ETALON_TRY(taken, textures_.Take(program.images));
    auto loaded = std::make_unique<FragmentProgram>(*this, program, object, std::move(taken));
    ETALON_TRY_STEP(CheckGl(gl_, "loading the program"));
    return std::unique_ptr<GlProgram>(std::move(loaded));
}

}  // namespace etalon
