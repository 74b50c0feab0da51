// The words of the command line: each adds itself to the program's parser and runs where it is
// chosen.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace etalon {

class Command {
  public:
    virtual ~Command() = default;
    Command(const Command&) = delete;
    Command& operator=(const Command&) = delete;

    bool IsChosen() const { return word_->parsed(); }
    // The exit status.
    virtual int Run() = 0;

  protected:
    explicit Command(CLI::App* word) : word_(word) {}

    CLI::App* word_;
};

std::unique_ptr<Command> AddDevices(CLI::App& app);
std::unique_ptr<Command> AddList(CLI::App& app);
// Takes GoogleTest's flags, of which CLI11 knows nothing.
std::unique_ptr<Command> AddRun(CLI::App& app, std::vector<std::string> gtest_arguments);
std::unique_ptr<Command> AddExplain(CLI::App& app);
std::unique_ptr<Command> AddSweep(CLI::App& app);
std::unique_ptr<Command> AddChart(CLI::App& app);
std::unique_ptr<Command> AddMap(CLI::App& app);
std::unique_ptr<Command> AddProbe(CLI::App& app);
std::unique_ptr<Command> AddBake(CLI::App& app);

}  // namespace etalon
