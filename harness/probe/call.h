// Call: what the user wants evaluated, before anything is compiled.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "probe/program.h"
#include "probe/recipe.h"
#include "probe/type.h"

namespace etalon {

// A GLSL variable of the call: an input, an out parameter, or both (inout).
struct Argument {
    std::string name;
    std::string type;  // GLSL
    bool is_input = false;
    bool is_output = false;
};

// A GLSL expression whose value is wanted. `origin` is named in errors: "CALL", or a case's file
// and key.
struct Wanted {
    std::string name;  // of its table columns: "result"
    std::string text;
    std::string origin;
};

struct Call {
    std::filesystem::path source;
    std::vector<std::filesystem::path> with;           // further sources: scene functions
    std::vector<std::filesystem::path> include_roots;  // beside the folders of the sources
    std::map<std::string, std::string> defines;
    std::vector<BoundImage> images;
    std::vector<Argument> arguments;  // inputs first, in the order of their columns
    std::vector<Wanted> wanted;
};

// How the sources are written, and what must be done about it.
struct Dialect {
    std::uint32_t version = 0;  // their highest #version, 0 for none
    bool es = false;
    std::vector<std::string> samplers;   // that the sources declare
    std::vector<std::string> uniforms;   // others, which inputs of their names set
    std::vector<std::string> redefined;  // built-in functions of which they have their own
    bool rename_redefined = false;       // where the compiler cannot take such a function as it is
    bool with_first = false;             // the further sources come before the first one
};

// The types that the compiler found for a call.
struct Signature {
    Dialect dialect;
    std::vector<Type> arguments;      // as Call::arguments
    std::vector<Type> wanted;         // as Call::wanted; void where the call has no value
    std::vector<std::string> images;  // samplers that the call reaches
    std::uint32_t version = 450;      // GLSL that the sources need at least
    Stage stage = Stage::kCompute;  // kFragment where the sources compile only there (derivatives)

    std::uint32_t InputWords(const Call& call) const;
    std::uint32_t OutputWords(const Call& call) const;
};

// A scalar of a probe's table.
struct ProbeColumn {
    std::string name;  // "result.x"
    Scalar scalar = Scalar::kFloat;
};

// Columns of the inputs, and of the outputs (wanted values first, then out parameters), in the
// order of the words.
std::vector<ProbeColumn> InputColumns(const Call& call, const Signature& signature);
std::vector<ProbeColumn> OutputColumns(const Call& call, const Signature& signature);

}  // namespace etalon
