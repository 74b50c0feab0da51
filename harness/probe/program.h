// What a device receives: one complete shader that evaluates a call over rows of 32-bit words.
//
// Words are stored by columns: word `column` of row `row` stands at [column * rows + row]. A float
// is its bits, an int its two's complement, a bool 0 or 1.
//
// Interface of the shader, by stage and form:
//   compute (both forms)  local size kLocalSize; row = global invocation index (x only);
//                         set 0, binding 0: readonly std430 buffer { uint rows; uint words[]; } the
//                         inputs, set 0, binding 1: std430 buffer { uint words[]; } the outputs
//   fragment, SPIR-V      as compute, but row = y * kFragmentWidth + x of the fragment; the vertex
//   stage is the
//                         device's own and covers the viewport with one triangle
//   fragment, GLSL text   inputs: uniform usampler2D etalon_inputs, texel (row % kFragmentWidth,
//                         column * uniform int etalon_lines + row / kFragmentWidth), red = the
//                         word; uniform int etalon_rows = number of rows, etalon_lines = ceil(rows
//                         / kFragmentWidth); outputs: colour attachments 0..7 of format RGBA32UI
//                         hold the words from the uniform int etalon_first on: attachment a,
//                         channel k = word etalon_first + 4a + k; a program of more than
//                         kTargetWords outputs is drawn several times
// Images: SPIR-V finds them at set 0, bindings 2, 3, ... in the order of `images`; text by their
// names. They are filtered in binary32; cubes across their edges.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "image/image.h"
#include "image/sampling.h"

namespace etalon {

inline constexpr std::uint32_t kLocalSize = 64;
inline constexpr std::uint32_t kFragmentWidth = 1024;
inline constexpr std::uint32_t kTargetWords = 32;
inline constexpr std::uint32_t kFirstImageBinding = 2;

enum class Stage : std::uint8_t { kCompute, kFragment };
enum class Form : std::uint8_t { kGlsl, kSpirv };

struct BoundImage {
    std::string name;  // of the sampler2D or samplerCube in the source
    std::shared_ptr<const Image> image;
    Sampling sampling = {};
};

struct Program {
    Stage stage = Stage::kCompute;
    Form form = Form::kSpirv;
    std::string glsl;  // the whole shader, for Form::kGlsl
    std::vector<std::string>
        line_names;  // files by the source-string number of its #line; not for devices
    std::vector<std::uint32_t> spirv;  // the module, for Form::kSpirv; entry point "main"
    std::uint32_t input_words = 0;     // columns; 0 where the inputs are baked in
    std::uint32_t output_words = 0;
    std::vector<BoundImage> images;
};

}  // namespace etalon
