// Text around the compiler: its messages, and what a driver is given to read.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace etalon {

// The first error of glslang's log as one line: "x.glsl:3: 'foo' : undeclared identifier".
std::string FirstError(std::string_view log);

// The same for the linker's log, which names no place: `source` stands in for it.
std::string LinkError(std::string_view log, const std::string& source);

// Preprocessed text as a driver reads it: #version and every #extension first, the rest in place.
// File names in #line, which GLSL does not know, become numbers: indices into `names`. Number 0 is
// the generated text.
std::string DriverText(std::string_view preprocessed, std::uint32_t version,
                       std::vector<std::string>& names);

// The first error of a driver's log with its place in the user's file where the log has the usual
// form
// ("2:14(3): error: ..." or "2(14) : error ..."), else the log's first line.
std::string DriverError(std::string_view log, const std::vector<std::string>& names);

}  // namespace etalon
