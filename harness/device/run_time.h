// How long a device worked on a run: plain data, for everybody.
#pragma once

#include <time.h>

#include <cstdint>

namespace etalon {

struct RunTime {
    enum class Clock : std::uint8_t {
        kHost,    // the worker's, from the submission until all is done
        kDevice,  // the device's own: Vulkan's timestamps, OpenGL's timer queries
    };
    double seconds = 0;
    Clock clock = Clock::kHost;
    // What all threads of the worker used of the host's processors meanwhile: of a device that
    // computes there (DeviceInfo::on_host), its work, whatever else keeps the machine busy.
    double processor_seconds = 0;
};

// Runs from its making on, in the worker, by the host's clocks.
class Stopwatch {
  public:
    RunTime Read() const {
        return {Now(CLOCK_MONOTONIC) - start_, RunTime::Clock::kHost,
                Now(CLOCK_PROCESS_CPUTIME_ID) - processor_start_};
    }

  private:
    static double Now(clockid_t clock) {
        timespec now = {};
        clock_gettime(clock, &now);
        return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
    }

    double start_ = Now(CLOCK_MONOTONIC);
    double processor_start_ = Now(CLOCK_PROCESS_CPUTIME_ID);
};

}  // namespace etalon
