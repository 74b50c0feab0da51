// How long a device worked on a run: plain data, for everybody.
#pragma once

#include <chrono>
#include <cstdint>

namespace etalon {

struct RunTime {
    enum class Clock : std::uint8_t {
        kHost,    // the worker's, from the submission until all is done
        kDevice,  // the device's own: Vulkan's timestamps, OpenGL's timer queries
    };
    double seconds = 0;
    Clock clock = Clock::kHost;
};

// The host's clock, from its making on.
class Stopwatch {
  public:
    double Seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

  private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

}  // namespace etalon
