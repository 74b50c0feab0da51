// The types of operands: what each instruction asks of them.
#pragma once

#include <optional>
#include <string>

#include "spirv/grammar.h"

namespace etalon::spirv {

// The reason why the operands' types are wrong, if they are. The instruction stands in `function`;
// its operands are resolved.
std::optional<std::string> CheckTypes(const Module& module, std::uint32_t function,
                                      const Instruction& instruction, Rule rule);

// The same for an OpExtInst of GLSL.std.450.
std::optional<std::string> CheckGlsl(const Module& module, const Instruction& instruction);

// Scalar, or vector of such.
struct Numbers {
    Type::Kind kind = Type::Kind::kVoid;  // of a component; kVoid where it is neither
    std::uint32_t width = 0;
    std::uint32_t count = 0;

    bool operator==(const Numbers&) const = default;
};
Numbers NumbersOf(const Module& module, std::uint32_t type);

}  // namespace etalon::spirv
