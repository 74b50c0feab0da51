#include "run/schedule.h"

#include <algorithm>

#include "base/check.h"

namespace etalon {

Schedule::Schedule(std::vector<Job> jobs, unsigned threads)
    : jobs_(std::move(jobs)), states_(jobs_.size(), State::kWaiting), records_(jobs_.size()) {
    for (unsigned i = 0; i < std::max(1u, threads); ++i) {
        threads_.emplace_back([this] { Serve(); });
    }
}

Schedule::~Schedule() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    for (std::thread& thread : threads_) {
        thread.join();
    }
}

Record Schedule::Take(std::size_t index) {
    ETALON_CHECK(index < jobs_.size());
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return states_[index] == State::kDone; });
    return std::move(records_[index]);
}

std::size_t Schedule::NextStartable() {
    while (first_waiting_ < jobs_.size() && states_[first_waiting_] != State::kWaiting) {
        ++first_waiting_;
    }
    for (std::size_t i = first_waiting_; i < jobs_.size(); ++i) {
        if (states_[i] == State::kWaiting &&
            std::find(busy_.begin(), busy_.end(), jobs_[i].resource) == busy_.end()) {
            return i;
        }
    }
    return jobs_.size();
}

void Schedule::Serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
        std::size_t next = jobs_.size();
        changed_.wait(lock, [&] {
            next = NextStartable();
            return stopping_ || next < jobs_.size();
        });
        if (stopping_) {
            return;
        }
        states_[next] = State::kAtWork;
        busy_.push_back(jobs_[next].resource);
        lock.unlock();
        Record record = jobs_[next].work();
        lock.lock();
        records_[next] = std::move(record);
        states_[next] = State::kDone;
        std::erase(busy_, jobs_[next].resource);
        changed_.notify_all();
    }
}

}  // namespace etalon
