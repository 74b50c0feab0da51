#include "device/gl/gl_timer.h"

namespace etalon {

void GlTimer::Start() {
    if (time_ == nullptr) {
        return;
    }
    if (has_queries_) {
        gl_.GenQueries(1, &query_);
    }
    gl_.Finish();
    stopwatch_.emplace();
    if (has_queries_) {
        gl_.BeginQuery(GL_TIME_ELAPSED, query_);
    }
}

void GlTimer::Stop() {
    if (time_ == nullptr) {
        return;
    }
    if (has_queries_) {
        gl_.EndQuery(GL_TIME_ELAPSED);
    }
    gl_.Finish();
    RunTime taken = stopwatch_->Read();
    if (has_queries_) {
        GLuint64 nanoseconds = 0;
        gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
        gl_.DeleteQueries(1, &query_);
        taken.seconds = 1e-9 * static_cast<double>(nanoseconds);
        taken.clock = RunTime::Clock::kDevice;
    }
    *time_ = {time_->seconds + taken.seconds, taken.clock,
              time_->processor_seconds + taken.processor_seconds};
}

bool HasTimerQueries(const GlFunctions& gl, const DeviceInfo& info) {
    // llvmpipe counts some of the time that it draws, and none of what it computes.
    if (info.description.starts_with("llvmpipe")) {
        return false;
    }
    GLint bits = 0;
    gl.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    return bits > 0;
}

}  // namespace etalon
