// One device's part of an explanation: its result, what it is made of, where the device parts.
#pragma once

#include "evaluate/trace.h"
#include "report/explanation.h"
#include "run/evaluation.h"
#include "run/parting.h"
#include "run/prepared_case.h"
#include "run/runner.h"
#include "run/source_terms.h"

namespace etalon {

// What is explained: one output of the case's call, or the left side of one of its laws, at one
// row.
struct Subject {
    PreparedCase prepared;   // judges nothing else
    std::size_t column = 0;  // among the outputs
    std::string name;        // "result.x"
    Scalar scalar = Scalar::kFloat;

    const PreparedLaw* law() const {
        return prepared.laws.empty() ? nullptr : &prepared.laws.front();
    }
    const JudgedColumn* judged() const {
        return prepared.judged.empty() ? nullptr : &prepared.judged.front();
    }
    const Call& call() const { return law() != nullptr ? law()->call : prepared.call; }
    const Signature& signature() const {
        return law() != nullptr ? law()->signature : prepared.signature;
    }
    Rows rows() const {
        return {prepared.table.words, prepared.table.rows, prepared.table.columns.size()};
    }
};

// The strict reading of the subject's program at the one row.
struct StrictPath {
    Program program;  // SPIR-V with the user's lines
    std::shared_ptr<const evaluate::Plan> plan;
    evaluate::Trace trace;
};

ExplainedDevice ExplainDevice(const Subject& subject, const StrictPath& path,
                              const SourceTerms& terms, Evaluations& evaluations, Runner& runner,
                              const Recipe& recipe);

// In one sentence, where the device parts and whether the specification lets the operation yield
// that. `profile` is the one that the device is held to.
ExplainedParting PartingText(const Subject& subject, const StrictPath& path,
                             const SourceTerms& terms, const evaluate::Profile& profile,
                             const Parting& parting);

}  // namespace etalon
