// Record: what a run found, as plain data. Reporters see nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "device/device_info.h"
#include "report/finding.h"

namespace etalon {

enum class Verdict : std::uint8_t {
    kPass,
    kFail,
    kNonconforming,  // all is within the case's tolerances, but not within the specification
    kSkip,
    kCrash,
    kTimeout,
};
std::string_view VerdictName(Verdict verdict);

// One number as people and programs read it.
struct Value {
    std::string decimal;
    std::string hex;  // hexadecimal float; for other types the decimal again
};

// What a specification allows as one value.
struct AllowedValue {
    bool bounded = false;  // where it is not, low and high have no meaning
    Value low;
    Value high;
    double excess = 0;             // ulp by which the result lies outside
    std::optional<Value> quantum;  // where the result is outside as it is no multiple of this
};

struct PartSeen {
    double absolute = 0;
    double ulp = 0;
};

// How the error of one value came about (judge/budget.h).
struct Budget {
    std::string culprit;             // "rounding"; empty of a value that nobody is blamed for
    bool is_law = false;             // the parts are by how much M, R and D break the law
    std::optional<PartSeen> method;  // absent where there is no truth
    PartSeen rounding;
    PartSeen driver;
};

// The worst of one part among all values of a record.
struct WorstPart {
    std::string part;  // "method", "rounding", "driver"
    std::string output;
    std::vector<std::pair<std::string, Value>> inputs;
    PartSeen seen;
};

// One judged value: where it stood, what came, what was due, how far apart.
struct Observation {
    std::string output;  // "result.x", or a law's text
    std::string rule;    // "ulp 16 or absolute 1e-09"
    std::vector<std::pair<std::string, Value>> inputs;
    Value actual;
    std::optional<Value> expected;  // absent where there is no oracle
    double error = 0;
    double ulp_error = 0;
    double used = 0;  // share of the tolerance that the error used; its complement is the margin
    std::optional<Budget> budget;         // absent where the program cannot be evaluated
    std::optional<AllowedValue> allowed;  // by the record's profile; absent likewise
};

// The figure of an expected failure, and what was seen in its place.
struct FigureSeen {
    std::string expected;  // "absolute 2.57115 within 0.01"
    std::string seen;
    bool agrees = false;
};

// What was found of an output of which a share may be off. Shares are 0..1.
struct ShareCount {
    std::string output;
    bool search =
        false;  // the way to hits, and not exact values: `hits` to `worst_right` are of use
    std::uint64_t rows = 0;  // without the undecided
    std::uint64_t wrong = 0;
    double wrong_allowed = 0;
    std::uint64_t hits = 0;
    std::uint64_t missed = 0;
    double missed_allowed = 0;
    double worst_right = 0;  // absolute
    std::uint64_t undecided = 0;
};

struct Record {
    std::string case_path;
    std::string device;
    std::string recipe;
    std::string family;
    std::vector<std::string> covers;  // ids of what the case shows
    Verdict verdict = Verdict::kPass;
    std::string reason;  // of a skip, crash, timeout, or a rejected program
    std::uint64_t seed = 0;
    std::uint64_t rows = 0;
    std::uint64_t all_rows = 0;  // of the case, where a quick run has left out some
    std::uint64_t judged = 0;    // values
    std::uint64_t refused = 0;
    std::vector<std::string> failed;   // outputs and laws with refused values; of a nonconforming
                                       // record, with values outside
    std::vector<ShareCount> shares;    // one for each output that is judged by shares
    std::optional<Observation> worst;  // by share of the tolerance; absent where nothing was judged
    std::string profile;               // the specification that the device is held to
    std::uint64_t held = 0;            // values that were held to it
    std::uint64_t unbounded = 0;       // of these, where it allows everything
    std::uint64_t void_bounds = 0;     // of these unbounded ones, where Etalon's own bound is wrong
    std::uint64_t outside = 0;         // of these, which it does not allow
    std::vector<std::string> outside_in;  // outputs and laws that hold them
    std::uint64_t unjudged = 0;           // values that `accept = { spec = ... }` has no bound for
    std::optional<Observation> worst_outside;  // the one that lies furthest outside
    std::vector<WorstPart> parts;              // the greatest method, rounding and driver part
    std::vector<std::pair<std::string, std::uint64_t>> culprits;  // of the refused values
    std::string unevaluated;          // why there are no parts or bounds, where there are none
    std::string repeat;               // the command that repeats exactly the worst input
    std::string known_cause;          // of an expected failure that happened
    std::vector<FigureSeen> figures;  // of the expected failures that have one
    std::string flake;                // what went wrong once and not again
    double seconds = 0;

    // The value that the verdict is about; null where it is about none.
    const Observation* Shown() const {
        if (verdict == Verdict::kNonconforming) {
            return &*worst_outside;
        }
        return worst && refused > 0 ? &*worst : nullptr;
    }
    bool Good() const {
        return verdict == Verdict::kPass || verdict == Verdict::kSkip || !known_cause.empty();
    }
};

struct DeviceNote {
    std::string name;    // of the candidate
    std::string reason;  // why it is no device here
};

struct FunctionNote {
    std::string name;
    std::string file;  // relative to the root
};

// What a case is about, whatever its runs found.
struct CaseNote {
    std::string path;
    std::vector<std::string> covers;
    std::vector<FunctionNote> functions;  // under test
    std::vector<std::string> oracles;     // expressions
    std::size_t laws = 0;
    double seconds = 0;  // to read it and compute its inputs and truths, before any device
};

struct RunRecord {
    std::string version;
    std::vector<CaseNote> cases;  // in the order of their paths
    std::vector<DeviceInfo> devices;
    std::vector<DeviceNote> absent;
    std::vector<Record> records;
    std::vector<Finding> findings;  // where they were asked for
    double seconds = 0;
};

// What a baseline depends on, in short: a hash over everything that the device tells of itself and
// the processor.
std::string Fingerprint(const DeviceInfo& device);
std::string ProcessorName();

}  // namespace etalon
