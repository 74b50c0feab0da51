// A source file's text, made ready for the compiler, and what the probe must know of it.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "probe/call.h"

namespace etalon {

// Takes the byte order mark and the #version line out, joins lines that end in a backslash (line
// numbers stay), and adds what it finds to `dialect`: version, samplers, functions of built-in
// functions' names. A uniform that is named among `inputs`, or has a value of its own, becomes a
// global variable, which a probe can set. Fails where the text uses names that the probe keeps for
// itself; the error is "LINE: reason".
Result<std::string> PrepareSource(std::string text, const std::vector<std::string>& inputs,
                                  Dialect& dialect);

}  // namespace etalon
