// Generates the text of a probe around the user's sources, as pieces that keep the user's own
// places in errors.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "probe/call.h"

namespace etalon {

// A piece of a shader's text. An error in it is reported at `name`; the pieces of the generator
// itself are called kGenerated and cannot be wrong by the user's fault.
struct Piece {
    std::string name;
    std::string text;
};

inline constexpr const char* kGenerated = "etalon";

// Sources are named in an #include by kSourceMark and their index: 0 is Call::source, then
// Call::with.
inline constexpr const char* kSourceMark = "etalon-source:";

// The sources alone, for a first reading.
std::vector<Piece> SourcesShader(const Call& call);

// A shader whose function etalon_inspect mentions each argument and each wanted expression as a
// statement of its own, so that the compiler tells their types.
std::vector<Piece> InspectionShader(const Call& call, const Dialect& dialect);

// The probe itself. `baked` holds the rows to build in (InputColumns words each); it is empty for
// inputs at run time.
std::vector<Piece> ProbeShader(const Call& call, const Signature& signature, const Recipe& recipe,
                               std::span<const std::vector<std::uint32_t>> baked);

}  // namespace etalon
