// The built program, as a user starts it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "support/program.h"

namespace etalon {

// The words of the command `etalon ...`.
std::vector<std::string> EtalonWords(const std::vector<std::string>& arguments);

Finished RunEtalon(const std::vector<std::string>& arguments, const ProgramOptions& options = {});

// The name of a software device that runs here, the quickest to start first; empty where there is
// none.
const std::string& SoftwareDevice();

// A command of a shell in which `etalon` is the built program.
std::unique_ptr<RunningProgram> StartInShell(const std::string& command,
                                             const ProgramOptions& options = {});
Finished RunInShell(const std::string& command, const ProgramOptions& options = {});

// The workers that live among the children of a process, or among all processes for 0.
std::vector<pid_t> WorkersOf(pid_t parent);

}  // namespace etalon

// Leaves the test where no software device runs.
#define ETALON_NEED_DEVICE()                                \
    do {                                                    \
        if (::etalon::SoftwareDevice().empty()) {           \
            GTEST_SKIP() << "no software device runs here"; \
        }                                                   \
    } while (false)
