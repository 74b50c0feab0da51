// A child process that serves as a worker: its start, its end and its use of memory, seen from the
// parent. What it needs to know of its own start stands in serve.cc.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "base/result.h"
#include "worker/descriptor.h"

namespace etalon {

// Where a worker finds what it inherits; it inherits nothing else but stderr.
inline constexpr int kWorkerSocket = 3;
inline constexpr int kWorkerMemory = 4;

class Process {
  public:
    // Runs `program worker` with `environment` added to this process's own, and in a process group
    // of its own, so that a terminal's Ctrl-C reaches only the parent.
    static Result<std::unique_ptr<Process>> Start(
        const std::string& program, const std::map<std::string, std::string>& environment,
        int socket, int memory);

    // Kills the process, and what it started, and reaps it.
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    // Readable when the process has ended; -1 where the kernel offers no such thing.
    int end_descriptor() const { return end_.number(); }

    // Readable when the process has written to stderr: then call ReadLog, lest it wait for that.
    int log_descriptor() const { return log_.number(); }
    void ReadLog();

    bool Ended() const;

    // 0 where it cannot be known.
    std::uint64_t ResidentBytes() const;

    // Reaps the process, after killing it unless it ends by itself within `patience`. Says how it
    // ended, with the last line it wrote to stderr: "ended by signal 11 (Segmentation fault): ...".
    std::string End(std::chrono::milliseconds patience);

  private:
    Process(pid_t id, Descriptor log);
    bool WaitForEnd(std::chrono::milliseconds patience) const;
    std::string LastLine() const;

    pid_t id_;
    bool reaped_ = false;
    Descriptor end_;
    Descriptor log_;
    Descriptor statistics_;
    std::string tail_;  // of the log
};

}  // namespace etalon
