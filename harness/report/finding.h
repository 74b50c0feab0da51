// Findings: results that a specification does not allow, as a list for people.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace etalon {

struct RunRecord;

// A value as people read it, and its bits.
struct FindingValue {
    std::string name;  // of an input; else empty
    std::string decimal;
    std::string hex;  // hexadecimal float; for other types the decimal again
    std::uint32_t word = 0;
};

// The result of one case that lies furthest outside, on one implementation.
struct Finding {
    std::vector<std::string> devices;  // the ways to that implementation
    std::string case_path;
    std::string call;
    std::string recipe;
    std::string profile;
    std::string output;  // "result.x"
    std::vector<FindingValue> inputs;
    FindingValue actual;
    FindingValue strict;  // by binary32, each operation rounded correctly in source order
    FindingValue low;     // of what is allowed; the same as `high` for what is no float
    FindingValue high;
    double excess = 0;          // ulp by which the result lies outside
    std::uint64_t outside = 0;  // values of the case that do
    std::uint64_t held = 0;     // of so many
    std::string cause;          // as the case tells it; empty where it tells none
    std::string reproducer;     // file name; empty where there is none
    std::string doubt;          // why the finding does not stand; empty where it does
};

// Implementation by implementation: what the devices were held to, what stands, and what does not
// and why. Reproducers lie in the folder `reproducers`, relative to the text.
std::string FindingsMarkdown(const RunRecord& run, const std::string& reproducers);

}  // namespace etalon
