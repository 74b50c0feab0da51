#include "base/progress.h"

#include <unistd.h>

#include <cstdio>

#include "base/format.h"

namespace etalon {

Progress::Progress(std::int64_t total)
    : total_(total), is_terminal_(isatty(STDERR_FILENO) == 1), start_(Clock::now()) {}

void Progress::Step(const std::string& what) {
    const std::lock_guard lock(mutex_);
    ++done_;
    const Clock::time_point now = Clock::now();
    if (!is_terminal_ || now - start_ < std::chrono::seconds(2) ||
        now - drawn_ < std::chrono::milliseconds(100)) {
        return;
    }
    drawn_ = now;
    is_drawn_ = true;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double left = seconds / static_cast<double>(done_) * static_cast<double>(total_ - done_);
    const std::string line =
        format("\r\033[K{} of {}, {:.0f} s left, {}", done_, total_, left, what);
    std::fputs(line.substr(0, 100).c_str(), stderr);
    std::fflush(stderr);
}

void Progress::Clear() {
    const std::lock_guard lock(mutex_);
    if (is_drawn_) {
        std::fputs("\r\033[K", stderr);
        std::fflush(stderr);
        is_drawn_ = false;
    }
}

}  // namespace etalon
