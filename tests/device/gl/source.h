// One call, written once for these tests, wrapped into each stage's and form's interface.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "device/device.h"
#include "spirv.h"

namespace etalon {

// A call, written once; wrapped into each stage's interface. `body` sets the words `result[...]`
// from the words `word[...]`.
struct Source {
    std::string declarations;
    std::string body;
    std::uint32_t input_words;
    std::uint32_t output_words;
};

inline std::string Arrays(const Source& source) {
    return "    uint word[" + std::to_string(std::max(source.input_words, 1u)) + "];\n" +
           "    uint result[" + std::to_string(source.output_words) + "];\n";
}

inline std::string StorageText(const Source& source, Stage stage, std::uint32_t version) {
    std::string text = "#version " + std::to_string(version) + "\n";
    text += stage == Stage::kCompute ? "layout(local_size_x = 64) in;\n" : "";
    text +=
        "layout(std430, binding = 0) readonly buffer In { uint rows; uint words_in[]; };\n"
        "layout(std430, binding = 1) buffer Out { uint words_out[]; };\n";
    text += source.declarations + "void main() {\n";
    text += stage == Stage::kCompute
                ? "    uint row = gl_GlobalInvocationID.x;\n"
                : "    uint row = uint(gl_FragCoord.y) * 1024u + uint(gl_FragCoord.x);\n";
    text += "    if (row >= rows) { return; }\n" + Arrays(source);
    for (std::uint32_t i = 0; i < source.input_words; ++i) {
        const std::string n = std::to_string(i);
        text += "    word[" + n + "] = words_in[" + n + "u * rows + row];\n";
    }
    text += source.body;
    for (std::uint32_t i = 0; i < source.output_words; ++i) {
        const std::string n = std::to_string(i);
        text += "    words_out[" + n + "u * rows + row] = result[" + n + "];\n";
    }
    return text + "}\n";
}

inline std::string TargetText(const Source& source, std::uint32_t version) {
    std::string text = "#version " + std::to_string(version) + "\n" +
                       (version < 400 ? "#extension GL_ARB_shader_bit_encoding : require\n" : "") +
                       "uniform usampler2D etalon_inputs;\nuniform int etalon_lines;\n"
                       "uniform int etalon_rows;\nuniform int etalon_first;\n";
    const std::uint32_t targets = std::min((source.output_words + 3) / 4, 8u);
    for (std::uint32_t i = 0; i < targets; ++i) {
        text += "layout(location = " + std::to_string(i) + ") out uvec4 target" +
                std::to_string(i) + ";\n";
    }
    text += source.declarations + "void main() {\n    ivec2 at = ivec2(gl_FragCoord.xy);\n" +
            "    uint row = uint(at.y * 1024 + at.x);\n    if (int(row) >= etalon_rows) { discard; "
            "}\n" +
            Arrays(source);
    for (std::uint32_t i = 0; i < source.input_words; ++i) {
        const std::string n = std::to_string(i);
        text += "    word[" + n + "] = texelFetch(etalon_inputs, ivec2(at.x, " + n +
                " * etalon_lines + at.y), 0).r;\n";
    }
    text += source.body;
    for (std::uint32_t i = 0; i < targets; ++i) {
        std::string vector;
        for (std::uint32_t k = 0; k < 4; ++k) {
            vector += (k > 0 ? ", " : "") + std::string("result[min(etalon_first + ") +
                      std::to_string(4 * i + k) + ", " + std::to_string(source.output_words - 1) +
                      ")]";
        }
        text += "    target" + std::to_string(i) + " = uvec4(" + vector + ");\n";
    }
    return text + "}\n";
}

inline Program TextProgram(const Source& source, Stage stage, std::uint32_t version) {
    Program program;
    program.stage = stage;
    program.form = Form::kGlsl;
    program.glsl = stage == Stage::kCompute ? StorageText(source, stage, version)
                                            : TargetText(source, version);
    program.input_words = source.input_words;
    program.output_words = source.output_words;
    return program;
}

inline Program SpirvProgram(const Source& source, Stage stage,
                            glslang::EShTargetLanguageVersion version) {
    Program program;
    program.stage = stage;
    program.form = Form::kSpirv;
    program.spirv = ToSpirv(StorageText(source, stage, 450),
                            stage == Stage::kCompute ? EShLangCompute : EShLangFragment, version);
    program.input_words = source.input_words;
    program.output_words = source.output_words;
    return program;
}

struct Way {
    std::string name;
    Program program;
};

// All ways in which the device takes the source.
inline std::vector<Way> Ways(const DeviceInfo& info, const Source& source) {
    std::vector<Way> ways;
    ways.push_back({"fragment text", TextProgram(source, Stage::kFragment, info.glsl_version)});
    if (info.Has("compute")) {
        ways.push_back({"compute text", TextProgram(source, Stage::kCompute, info.glsl_version)});
    }
    if (info.Has("spirv")) {
        const auto old = glslang::EShTargetSpv_1_0;
        const auto current = glslang::EShTargetSpv_1_3;
        ways.push_back({"compute SPIR-V 1.0", SpirvProgram(source, Stage::kCompute, old)});
        ways.push_back({"compute SPIR-V 1.3", SpirvProgram(source, Stage::kCompute, current)});
        ways.push_back({"fragment SPIR-V 1.0", SpirvProgram(source, Stage::kFragment, old)});
        ways.push_back({"fragment SPIR-V 1.3", SpirvProgram(source, Stage::kFragment, current)});
    }
    return ways;
}

}  // namespace etalon
