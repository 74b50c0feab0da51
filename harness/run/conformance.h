// The conformance run: case x device x recipe is one GoogleTest test.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "report/catalogue.h"
#include "report/record.h"
#include "run/devices.h"

namespace etalon {

// How much of the cases a run takes: under kFull inputs have their full counts, and slow devices
// all rows.
enum class Depth : std::uint8_t { kQuick, kFull };

struct RunChoice {
    std::filesystem::path root;  // holds cases/
    std::vector<std::string>
        patterns;  // of case addresses: a prefix of whole names, or a pattern with * and ?
    std::vector<std::string> recipes;  // empty: the case's own, else the device's default set
    std::string at;                    // run at this one input only
    DeviceChoice devices;
    Depth depth = Depth::kQuick;
    unsigned jobs = 1;                         // devices at work at the same time
    std::vector<std::string> gtest_arguments;  // "--gtest_..." flags
    bool verbose = false;                      // a line per test
    bool catalogue = false;                    // also reads the root's catalogue
    bool findings = false;                     // also looks at what no specification allows
};

struct RunOutcome {
    RunRecord record;
    std::vector<CatalogueEntry> catalogue;
    std::map<std::string, std::string> reproducers;  // of the record's findings, by file name
    bool chosen_only = false;                        // not all tests were asked for
    bool listed_only = false;                        // --gtest_list_tests or --help: nothing ran
    bool nothing_ran = false;                        // every test was skipped
    bool good = false;                               // no test failed
    std::string report_error;  // why GoogleTest's report could not be written; empty where it was
};

// Prepares the cases, opens the devices, registers the tests and runs them. To be called once in a
// process: GoogleTest's registry is global.
Result<RunOutcome> RunConformance(const RunChoice& choice);

}  // namespace etalon
