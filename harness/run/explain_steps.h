// The path of one input as an explanation tells it.
#pragma once

#include "evaluate/trace.h"
#include "probe/call.h"
#include "report/explanation.h"
#include "run/source_terms.h"

namespace etalon {

// Fills the explanation's steps, and which of them loses most of the digits of the output at that
// column; of an output that is no float, every step counts. The call's sources are read for the
// texts of their lines.
void ExplainSteps(const spirv::Module& module, const evaluate::Trace& trace,
                  const SourceTerms& terms, const Call& call, std::size_t column,
                  Explanation& explanation);

// The type of a leaf of an instruction's result (spirv::Leaves).
Scalar LeafScalar(const spirv::Module& module, std::uint32_t type, std::uint32_t leaf);

}  // namespace etalon
