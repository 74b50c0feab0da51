#include "device/gl/gl_timer.h"

namespace etalon {

void GlTimer::Start() {
    if (time_ == nullptr) {
        return;
    }
    GLint bits = 0;
    gl_.GetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
    if (bits > 0) {
        gl_.GenQueries(1, &query_);
    }
    gl_.Finish();
    stopwatch_.emplace();
    if (query_ != 0) {
        gl_.BeginQuery(GL_TIME_ELAPSED, query_);
    }
}

void GlTimer::Stop() {
    if (time_ == nullptr) {
        return;
    }
    if (query_ != 0) {
        gl_.EndQuery(GL_TIME_ELAPSED);
    }
    gl_.Finish();
    double seconds = stopwatch_->Seconds();
    time_->clock = RunTime::Clock::kHost;
    if (query_ != 0) {
        GLuint64 nanoseconds = 0;
        gl_.GetQueryObjectui64v(query_, GL_QUERY_RESULT, &nanoseconds);
        gl_.DeleteQueries(1, &query_);
        query_ = 0;
        if (getenv("ETALON_DEBUG_TIME"))
            fprintf(stderr, "host %g device %g\n", seconds,
                    1e-9 * static_cast<double>(nanoseconds));
        seconds = 1e-9 * static_cast<double>(nanoseconds);
        time_->clock = RunTime::Clock::kDevice;
    }
    time_->seconds += seconds;
}

}  // namespace etalon
