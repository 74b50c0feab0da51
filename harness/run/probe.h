// `etalon probe`: calls a function now.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/result.h"
#include "run/devices.h"

namespace etalon {

struct ProbeChoice {
    std::filesystem::path source;
    std::string call;
    std::filesystem::path inputs;      // CSV; empty: no inputs, or `at`
    std::string at;                    // "n1=1,n2=1.5" instead of a file
    std::vector<std::string> in;       // "NAME:TYPE" of inputs that are neither scalars nor vectors
    std::vector<std::string> out;      // "NAME:TYPE" of out parameters
    std::vector<std::string> defines;  // "NAME=VALUE"
    std::vector<std::filesystem::path> include;
    std::vector<std::string> with;     // sources, or NAME=IMAGE
    std::vector<std::string> images;   // "NAME={ ... }"
    std::vector<std::string> recipes;  // empty: each device's own
    bool csv = false;
    DeviceChoice devices;
};

// Writes the table to `out` and notes on skipped devices, crashes and flakes to `notes`. Returns
// the exit status: 0 where a device ran and none failed, 1 where one crashed, hung or refused the
// program. Wrong input, and a probe that no device can run, are errors.
Result<int> RunProbe(const ProbeChoice& choice, std::ostream& out, std::ostream& notes);

}  // namespace etalon
