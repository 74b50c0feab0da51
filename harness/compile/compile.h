// Compiles calls into programs. The only user of glslang and SPIRV-Tools.
//
// Errors stand at the user's own file and line, "shaders/x.glsl:3: 'foo' : undeclared identifier",
// or name the part of the call that is wrong ("CALL:1: ..."); never generated text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "probe/call.h"

namespace etalon {

// Whose programs: decides the flavour of SPIR-V, and for text the version of GLSL.
struct Target {
    enum class Client : std::uint8_t { kVulkan, kOpenGl };
    Client client = Client::kVulkan;
    std::uint32_t glsl_version = 450;
};

struct CompileFailure {
    enum class Kind : std::uint8_t {
        kInput,        // the user's sources or call are wrong
        kUnsupported,  // they are right, but not for this target: a skip
    };
    Kind kind = Kind::kInput;
    std::string reason;
};

// Finds the types of the call's arguments and wanted expressions.
Result<Signature> Inspect(const Call& call);

// Whether SPIR-V says for its instructions the user's files and lines.
enum class Lines : std::uint8_t { kLeftOut, kKept };

// Makes the program. `baked` holds the rows to build in and is empty unless the recipe is baked.
Result<Program, CompileFailure> Compile(const Call& call, const Signature& signature,
                                        const Recipe& recipe, Target target,
                                        std::span<const std::vector<std::uint32_t>> baked,
                                        Lines lines = Lines::kLeftOut);

}  // namespace etalon
