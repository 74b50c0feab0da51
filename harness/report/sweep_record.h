// What a sweep over all floats of an input found, as plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/record.h"

namespace etalon {

struct SweptOutput {
    struct Bin {
        double upper = 0;  // in ulp: errors up to this, and above that of the bin before
        std::uint64_t count = 0;
    };

    std::string name;
    std::string rule;
    std::uint64_t judged = 0;
    std::uint64_t refused = 0;
    std::optional<Observation> worst_ulp;      // absent where all values are exact
    std::optional<Observation> worst_used;     // by share of the tolerance, likewise
    std::optional<Observation> first_refused;  // in the order of the sweep
    // The first holds what is exact, the last two are both without bound: finite errors, and
    // infinite ones with NaN.
    std::vector<Bin> histogram;
};

struct SweepRecord {
    std::string case_path;
    std::string device;
    std::string driver;  // with its version
    std::string fingerprint;
    std::string recipe;
    std::string input;
    Value from;
    Value to;
    std::string fixed;           // the other inputs: "n1=1, n2=1.5"; empty where there are none
    std::uint64_t settings = 1;  // how many combinations of these there are
    std::uint64_t floats = 0;    // of the input, at each setting
    std::uint64_t laws = 0;      // that the case has, and a sweep does not hold
    std::string shard;           // "1/4", where it is not all of the sweep
    std::uint64_t rows = 0;      // judged
    std::uint64_t all_rows = 0;  // of the shard, or of the sweep
    std::vector<SweptOutput> outputs;
    Verdict verdict = Verdict::kPass;
    std::string reason;  // why it stopped before its end
    std::string repeat;  // the command that runs one input again, but for "--at ..."
};

std::string SweepText(const SweepRecord& sweep);
std::string SweepJson(const SweepRecord& sweep);

// What tells it from other sweeps in a report: "CASE over x=0..1 at n1=1 on DEVICE (RECIPE), 1/4".
std::string SweepKey(const SweepRecord& sweep);

}  // namespace etalon
