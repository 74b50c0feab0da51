// A case made ready to run: its rows, its types, its truths. Made once, used on every device.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "case/case.h"
#include "evaluate/profile.h"
#include "judge/judge.h"
#include "probe/call.h"

namespace etalon {

// One output column that an oracle judges.
struct JudgedColumn {
    std::string name;        // "result.x"
    std::size_t column = 0;  // among the outputs
    Scalar scalar = Scalar::kFloat;
    Acceptance accept;
    const evaluate::Profile* spec = nullptr;  // judges in place of `accept`
    bool own_spec = false;                    // the device's own specification does so
    Truth truth;                              // empty where there is no oracle

    bool HasTruth() const { return !truth.values.empty(); }
    bool IsBySpec() const { return spec != nullptr || own_spec; }
};

struct PreparedLaw {
    Law law;
    Call call;  // wants both sides
    Signature signature;
    // One pair of output columns for each component of the sides.
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<Scalar> scalars;
};

// Which rows of the case's domain are there: all, some of them, or one that the user has given.
enum class Extent : std::uint8_t { kAll, kSome, kGiven };

struct PreparedCase {
    Case source;
    Table table;
    Call call;
    Signature signature;
    std::vector<JudgedColumn> judged;  // empty where the case has laws only
    std::vector<PreparedLaw> laws;
    Extent extent = Extent::kAll;
    std::uint64_t all_rows = 0;  // from which the table's were chosen
};

// Fails, at the place of the key, where a source or a scene that the case names is no file.
Status<> CheckFiles(const Case& source);

// Reads what the case names, expands its domain, finds types and truths. Every mistake in the case
// or its shader is an error here, before anything runs.
Result<PreparedCase> Prepare(const Case& source);

// The same at the rows of this table, which has the columns of the case's domain, whatever they
// are; the acceptance is not held against them (CheckAcceptance).
Result<PreparedCase> PrepareRows(const Case& source, Table table);

// The same case at the one input that `at` describes: "n1=0x1p+0, v.x=0.5". All inputs must be
// given.
Result<PreparedCase> PrepareAt(const Case& source, const std::string& at);

// The same case at `count` of its rows, evenly chosen, first and last among them. A share that may
// be off is at least one value.
PreparedCase Thin(const PreparedCase& prepared, std::uint64_t count);

}  // namespace etalon
