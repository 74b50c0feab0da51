// Times what is drawn or dispatched, by the context's timer query if it has one.
#pragma once

#include <optional>

#include "device/device.h"
#include "device/gl/gl_functions.h"

namespace etalon {

class GlTimer {
  public:
    // What Start and Stop enclose is added to `time`. Where that is null nothing is timed, and
    // nothing costs anything.
    GlTimer(const GlFunctions& gl, bool has_queries, RunTime* time)
        : gl_(gl), has_queries_(has_queries), time_(time) {}

    // Waits for what was asked for before, lest it be timed too.
    void Start();

    // Waits until all is done since Start.
    void Stop();

  private:
    const GlFunctions& gl_;
    bool has_queries_;
    RunTime* time_;
    GLuint query_ = 0;
    std::optional<Stopwatch> stopwatch_;
};

// Whether the context's timer queries can be believed.
bool HasTimerQueries(const GlFunctions& gl, const DeviceInfo& info);

}  // namespace etalon
