#include "device/gl/gl_storage.h"

#include <algorithm>

#include "device/gl/gl_compile.h"
#include "device/gl/gl_error.h"
#include "device/gl/gl_images.h"
#include "device/gl/gl_triangle.h"

namespace etalon {
namespace {

constexpr std::size_t kHeaderWords = 1;  // `uint rows` before the inputs

std::uint32_t DivideUp(std::uint32_t a, std::uint32_t b) {
    return (a + b - 1) / b;
}

// Grows in powers of two, so that slowly growing batches do not reallocate each time.
void Grow(const GlFunctions& gl, GLuint buffer, std::size_t words, std::size_t& capacity) {
    if (words <= capacity) {
        return;
    }
    capacity = std::max<std::size_t>(capacity, 1024);
    while (capacity < words) {
        capacity *= 2;
    }
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, buffer);
    gl.BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(4 * capacity), nullptr,
                  GL_DYNAMIC_READ);
}

}  // namespace

class StorageProgram final : public GlProgram {
  public:
    StorageProgram(Storage& storage, const Program& program, GLuint object,
                   std::vector<GlTexture> textures)
        : storage_(storage),
          gl_(storage.gl_),
          stage_(program.stage),
          input_words_(program.input_words),
          output_words_(program.output_words),
          textures_(std::move(textures)) {
        if (stage_ == Stage::kFragment) {
            gl_.GenProgramPipelines(1, &object_);
            gl_.UseProgramStages(object_, GL_VERTEX_SHADER_BIT, storage_.vertex_program_);
            gl_.UseProgramStages(object_, GL_FRAGMENT_SHADER_BIT, object);
        } else {
            object_ = object;
        }
        if (program.form == Form::kGlsl) {
            NameSamplers(gl_, object, program.images);
        }
        const GlLimits& limits = storage_.limits_;
        const std::uint64_t by_shape = stage_ == Stage::kFragment
                                           ? std::uint64_t{limits.texture_size} * kFragmentWidth
                                           : std::uint64_t{limits.groups} * kLocalSize;
        const std::uint64_t words = limits.block_bytes / 4 - kHeaderWords;
        const std::uint64_t by_size = words / std::max({input_words_, output_words_, 1u});
        max_rows_ =
            static_cast<std::uint32_t>(std::min({by_shape, by_size, std::uint64_t{1} << 31}));
    }

    std::uint32_t max_rows() const override { return max_rows_; }

    DeviceResult<Nothing> Evaluate(const Batch& batch, GlTimer& timer) override {
        ETALON_TRY_STEP(Upload(batch));
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, storage_.inputs_);
        gl_.BindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, storage_.outputs_);
        BindTextures(gl_, textures_);
        timer.Start();
        if (stage_ == Stage::kFragment) {
            Draw(batch.rows);
        } else {
            gl_.UseProgram(object_);
            gl_.DispatchCompute(DivideUp(batch.rows, kLocalSize), 1, 1);
        }
        timer.Stop();
        ETALON_TRY_STEP(CheckGl(gl_, "running the program"));
        gl_.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        return Download(batch);
    }

  private:
    DeviceResult<Nothing> Upload(const Batch& batch) {
        const std::size_t rows = batch.rows;
        ETALON_TRY_STEP(storage_.Reserve(kHeaderWords + rows * input_words_, rows * output_words_));
        gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, storage_.inputs_);
        gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, 0, 4, &batch.rows);
        if (input_words_ > 0 && batch.rows == batch.stride) {
            Write(kHeaderWords, rows * input_words_, batch.inputs);
        } else {
            for (std::uint32_t column = 0; column < input_words_; ++column) {
                Write(kHeaderWords + column * rows, rows, batch.Input(column));
            }
        }
        return CheckGl(gl_, "writing the inputs");
    }

    void Write(std::size_t at, std::size_t words, const std::uint32_t* from) {
        gl_.BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(4 * at),
                          static_cast<GLsizeiptr>(4 * words), from);
    }

    DeviceResult<Nothing> Download(const Batch& batch) {
        const std::size_t rows = batch.rows;
        gl_.BindBuffer(GL_SHADER_STORAGE_BUFFER, storage_.outputs_);
        if (batch.rows == batch.stride) {
            Read(0, rows * output_words_, batch.outputs);
        } else {
            for (std::uint32_t column = 0; column < output_words_; ++column) {
                Read(column * rows, rows, batch.Output(column));
            }
        }
        return CheckGl(gl_, "reading the outputs");
    }

    void Read(std::size_t at, std::size_t words, std::uint32_t* to) {
        gl_.GetBufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(4 * at),
                             static_cast<GLsizeiptr>(4 * words), to);
    }

    void Draw(std::uint32_t rows) {
        const GLsizei width = static_cast<GLsizei>(std::min(rows, kFragmentWidth));
        const GLsizei height = static_cast<GLsizei>(DivideUp(rows, kFragmentWidth));
        gl_.BindFramebuffer(GL_FRAMEBUFFER, storage_.framebuffer_);
        // Exactly as high as what is drawn: a module for Vulkan has its origin at the top, which GL
        // finds by the framebuffer's height.
        gl_.FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_WIDTH, width);
        gl_.FramebufferParameteri(GL_FRAMEBUFFER, GL_FRAMEBUFFER_DEFAULT_HEIGHT, height);
        gl_.Viewport(0, 0, width, height);
        gl_.UseProgram(0);  // would take precedence over the pipeline
        gl_.BindProgramPipeline(object_);
        gl_.DrawArrays(GL_TRIANGLES, 0, 3);
    }

    Storage& storage_;
    const GlFunctions& gl_;
    Stage stage_;
    std::uint32_t input_words_;
    std::uint32_t output_words_;
    std::vector<GlTexture> textures_;
    GLuint object_ = 0;  // the program; of a fragment program its pipeline
    std::uint32_t max_rows_ = 0;
};

Storage::Storage(const GlFunctions& gl, const GlLimits& limits, GlTextures& textures)
    : gl_(gl), limits_(limits), textures_(textures) {
    gl_.GenBuffers(1, &inputs_);
    gl_.GenBuffers(1, &outputs_);
}

DeviceResult<Nothing> Storage::Reserve(std::size_t input_words, std::size_t output_words) {
    Grow(gl_, inputs_, input_words, input_capacity_);
    Grow(gl_, outputs_, output_words, output_capacity_);
    return CheckGl(gl_, "allocating the buffers");
}

DeviceResult<Nothing> Storage::PrepareDrawing() {
    if (framebuffer_ != 0) {
        return Ok();
    }
    const std::string text = TriangleShader(430, true);
    const ShaderSource vertex{GL_VERTEX_SHADER, text, {}};
    ETALON_TRY(program, BuildProgram(gl_, {&vertex, 1}, true));
    vertex_program_ = program;
    gl_.GenFramebuffers(1, &framebuffer_);
    return CheckGl(gl_, "preparing to draw");
}

DeviceResult<std::unique_ptr<GlProgram>> Storage::Load(const Program& program) {
    const bool fragment = program.stage == Stage::kFragment;
    if (fragment && limits_.fragment_blocks < 2) {
        return Unsupported("the device has no storage buffers in its fragment stage");
    }
    const ShaderSource source{
        static_cast<GLenum>(fragment ? GL_FRAGMENT_SHADER : GL_COMPUTE_SHADER),
        program.form == Form::kGlsl ? program.glsl : std::string_view(),
        program.form == Form::kSpirv ? std::span(program.spirv) : std::span<const std::uint32_t>()};
    if (fragment) {
        ETALON_TRY_STEP(PrepareDrawing());
    }
    ETALON_TRY(object, BuildProgram(gl_, {&source, 1}, fragment));
    ETALON_TRY(taken, textures_.Take(program.images));
    auto loaded = std::make_unique<StorageProgram>(*this, program, object, std::move(taken));
    ETALON_TRY_STEP(CheckGl(gl_, "loading the program"));
    return std::unique_ptr<GlProgram>(std::move(loaded));
}

}  // namespace etalon
