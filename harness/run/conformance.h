// The conformance run: case x device x recipe is one GoogleTest test.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "report/record.h"
#include "run/devices.h"

namespace etalon {

struct RunChoice {
    std::filesystem::path root;  // holds cases/
    std::vector<std::string>
        patterns;  // of case addresses: a prefix of whole names, or a pattern with * and ?
    std::vector<std::string> recipes;  // empty: the case's own, else the device's default set
    std::string at;                    // run at this one input only
    DeviceChoice devices;
    std::vector<std::string> gtest_arguments;  // "--gtest_..." flags
    bool verbose = false;                      // a line per test
};

// The addresses of the cases that the patterns name, in order; all for no pattern. Fails where one
// names none.
Result<std::vector<std::string>> ChooseCases(const std::filesystem::path& root,
                                             const std::vector<std::string>& patterns);

struct RunOutcome {
    RunRecord record;
    bool listed_only = false;  // --gtest_list_tests or --help: nothing ran
    bool nothing_ran = false;  // every test was skipped
    bool good = false;         // no test failed
};

// Prepares the cases, opens the devices, registers the tests and runs them. To be called once in a
// process: GoogleTest's registry is global.
Result<RunOutcome> RunConformance(const RunChoice& choice);

// The folder at or above `from` that holds a folder "cases".
Result<std::filesystem::path> FindRoot(const std::filesystem::path& from);

}  // namespace etalon
