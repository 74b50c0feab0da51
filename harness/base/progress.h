// A progress line on the terminal: count, rate and time left; nothing where the output is no
// terminal.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

namespace etalon {

class Progress {
  public:
    explicit Progress(std::int64_t total);

    // One more is done, by any thread. Redraws at most ten times a second, and only once the work
    // has taken two seconds.
    void Step(const std::string& what);

    // Takes the line away, before other output.
    void Clear();

  private:
    using Clock = std::chrono::steady_clock;
    std::mutex mutex_;
    std::int64_t total_;
    std::int64_t done_ = 0;
    bool is_terminal_;
    bool is_drawn_ = false;
    Clock::time_point start_;
    Clock::time_point drawn_;
};

}  // namespace etalon
