#include "device/gl/gl_compile.h"

#include <string>

#include "device/gl/gl_error.h"

namespace etalon {
namespace {

DeviceFailure Refused(const char* what, std::string log) {
    while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) {
        log.pop_back();
    }
    return {DeviceFailure::Kind::kRejected, std::string("the driver's ") + what +
                                                " refused the program" +
                                                (log.empty() ? "" : "\n" + log)};
}

std::string ReadLog(PFNGLGETSHADERIVPROC get, PFNGLGETSHADERINFOLOGPROC get_log, GLuint object) {
    GLint length = 0;
    get(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
    GLsizei written = 0;
    get_log(object, length, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

DeviceResult<GLuint> Compile(const GlFunctions& gl, const ShaderSource& source) {
    const GLuint shader = gl.CreateShader(source.stage);
    if (source.spirv.empty()) {
        const GLchar* text = source.text.data();
        const GLint length = static_cast<GLint>(source.text.size());
        gl.ShaderSource(shader, 1, &text, &length);
        gl.CompileShader(shader);
    } else {
        gl.ShaderBinary(1, &shader, GL_SHADER_BINARY_FORMAT_SPIR_V, source.spirv.data(),
                        static_cast<GLsizei>(source.spirv.size_bytes()));
        const auto specialize =
            gl.SpecializeShaderARB != nullptr ? gl.SpecializeShaderARB : gl.SpecializeShader;
        specialize(shader, "main", 0, nullptr, nullptr);
    }
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled != GL_TRUE) {
        std::string log = ReadLog(gl.GetShaderiv, gl.GetShaderInfoLog, shader);
        gl.DeleteShader(shader);
        // A module that is not SPIR-V at all is an error rather than a failed compilation.
        if (auto check = CheckGl(gl, "compiling"); !check && log.empty()) {
            return check.error();
        }
        return Refused("compiler", std::move(log));
    }
    return shader;
}

}  // namespace

DeviceResult<GLuint> BuildProgram(const GlFunctions& gl, std::span<const ShaderSource> sources,
                                  bool separable) {
    const GLuint program = gl.CreateProgram();
    for (const ShaderSource& source : sources) {
        auto shader = Compile(gl, source);
        if (!shader) {
            gl.DeleteProgram(program);
            return shader.error();
        }
        gl.AttachShader(program, *shader);
        gl.DeleteShader(*shader);  // lives as long as the program holds it
    }
    if (separable) {
        gl.ProgramParameteri(program, GL_PROGRAM_SEPARABLE, GL_TRUE);
    }
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked != GL_TRUE) {
        std::string log = ReadLog(gl.GetProgramiv, gl.GetProgramInfoLog, program);
        gl.DeleteProgram(program);
        return Refused("linker", std::move(log));
    }
    ETALON_TRY_STEP(CheckGl(gl, "building the program"));
    return program;
}

}  // namespace etalon
