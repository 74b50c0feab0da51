// Times what is drawn or dispatched, by the context's timer query if it has one.
#pragma once

#include <optional>

#include "device/device.h"
#include "device/gl/gl_functions.h"

namespace etalon {

class GlTimer {
  public:
    // Adds to `time`; where that is null nothing is timed, and nothing costs anything.
    GlTimer(const GlFunctions& gl, RunTime* time) : gl_(gl), time_(time) {}

    // Waits for what was asked for before, lest it be timed too.
    void Start();

    // Waits until all is done since Start.
    void Stop();

  private:
    const GlFunctions& gl_;
    RunTime* time_;
    GLuint query_ = 0;  // 0 where the context counts no time
    std::optional<Stopwatch> stopwatch_;
};

}  // namespace etalon
