// `etalon sweep`: every float of one input of a case, judged on one device.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

#include "base/result.h"
#include "run/devices.h"
#include "run/sweep_journal.h"
#include "run/sweep_plan.h"

namespace etalon {

struct SweepChoice {
    std::filesystem::path root;  // holds cases/
    std::string pattern;         // must name one case
    SweepScope scope;
    SweepShard shard;
    std::string recipe;             // empty: the device's own
    std::filesystem::path journal;  // empty: in the current folder, by the names of the rest;
                                    // /dev/null keeps none
    std::string options;            // for repeat commands: " --root DIR", or empty
    unsigned jobs = 1;              // threads that check results
    DeviceChoice devices;           // must choose one
};

// Goes on where the journal ends, block by block: while the device computes one, the results of the
// one before are checked, after which the journal is written. A device that crashes or hangs is
// tried once more in a fresh worker; if it fails again the record says at which floats, and the
// journal keeps what was done. Notes tell of rate, resumption and flakes.
//
// Fails for what the user got wrong, for a journal that is of another sweep, torn, at work in
// another process or cannot be written, and for a device that cannot run the program.
Result<SweepRecord> RunSweep(const SweepChoice& choice, std::ostream& notes);

// What one sweep over all shards would have found.
Result<SweepRecord> MergeSweeps(const std::vector<std::filesystem::path>& journals);

}  // namespace etalon
