// Starts programs as a shell does, and collects what they say.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace etalon {

struct Finished {
    int status = -1;  // of the exit; -1 where a signal ended it
    int signal = 0;   // 0 where it exited
    std::string out;
    std::string err;
};

struct ProgramOptions {
    std::filesystem::path folder = ".";         // to work in
    std::string out_file;                       // instead of a collected stdout
    std::vector<std::string> environment = {};  // "NAME=VALUE", added
    std::chrono::seconds timeout{60};           // after which it is killed
};

class RunningProgram {
  public:
    // Looked for along PATH where the first word holds no '/'.
    explicit RunningProgram(const std::vector<std::string>& words,
                            const ProgramOptions& options = {});
    // Kills it, if it lives.
    ~RunningProgram();
    RunningProgram(const RunningProgram&) = delete;
    RunningProgram& operator=(const RunningProgram&) = delete;

    pid_t id() const { return id_; }
    std::string ErrSoFar() const;
    Finished Wait();

  private:
    ProgramOptions options_;
    pid_t id_ = -1;
    int out_ = -1;
    int err_ = -1;
    bool reaped_ = false;
};

Finished RunProgram(const std::vector<std::string>& words, const ProgramOptions& options = {});

std::vector<std::string> Lines(const std::string& text);

}  // namespace etalon
