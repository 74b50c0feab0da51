// `etalon sweep` on the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cmd/options.h"
#include "run/sweep.h"

namespace etalon {

class SweepCommand {
  public:
    explicit SweepCommand(CLI::App& app);

    bool IsChosen() const { return word_->parsed(); }
    // The exit status.
    int Run();

  private:
    Result<SweepRecord> Find();

    CLI::App* word_;
    SweepChoice choice_;
    std::string root_;
    std::string shard_;
    bool exhaustive_ = false;
    bool json_ = false;
    std::vector<std::string> merged_;
    DeviceOptions devices_;
};

}  // namespace etalon
