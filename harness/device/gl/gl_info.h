// What a context says of itself, read into a DeviceInfo.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "device/device.h"
#include "device/gl/gl_functions.h"

namespace etalon {

// A name for a GL_RENDERER: the words before '(' or '/', lower case, joined by '-':
// "NVIDIA H200/PCIe/SSE2" is "nvidia-h200"; trade marks in parentheses are dropped.
std::string RendererSlug(std::string_view renderer);

// The compiler that a GL_RENDERER names: "LLVM 15.0.6, 256 bits"; empty where it names none.
std::string RendererCompiler(std::string_view renderer);

struct DriverVersion {
    std::string driver;   // "Mesa", "NVIDIA"
    std::string version;  // "22.3.6"
};

// The driver in a GL_VERSION: "4.5 (Core Profile) Mesa 22.3.6", "4.6.0 NVIDIA 535.104.05".
DriverVersion ParseDriverVersion(std::string_view gl_version);

// The limits that decide what a program may be.
struct GlLimits {
    std::uint32_t texture_size = 0;     // width and height of textures and targets
    std::uint32_t cube_size = 0;        // of a cube's faces
    std::uint32_t texture_units = 0;    // of one stage
    std::uint32_t targets = 0;          // colour attachments drawn to at once
    std::uint32_t groups = 0;           // in the x dimension of a dispatch; 0 without compute
    std::uint64_t block_bytes = 0;      // of a storage block; 0 without storage blocks
    std::uint32_t fragment_blocks = 0;  // storage blocks of the fragment stage
};

// Everything but name and siblings.
DeviceInfo DescribeContext(const GlFunctions& gl);
GlLimits ReadLimits(const GlFunctions& gl, const DeviceInfo& info);

}  // namespace etalon
