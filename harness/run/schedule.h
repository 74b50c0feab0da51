// Schedule: runs jobs on all cores, each device doing one job at a time, while GoogleTest collects
// the results in order.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "report/record.h"

namespace etalon {

// Jobs start in their order, as soon as a thread is free and their resource (a device) is not at
// work. The threads live as long as the schedule: workers that a job starts end with the thread
// that started them.
class Schedule {
  public:
    struct Job {
        const void* resource = nullptr;
        std::function<Record()> work;
    };

    Schedule(std::vector<Job> jobs, unsigned threads);

    // Jobs that have not begun are left undone; those at work are waited for.
    ~Schedule();
    Schedule(const Schedule&) = delete;
    Schedule& operator=(const Schedule&) = delete;

    // Waits for the job of that index and takes its record.
    Record Take(std::size_t index);

  private:
    enum class State : unsigned char { kWaiting, kAtWork, kDone };

    void Serve();
    // Index of the first job that can start, or the number of jobs.
    std::size_t NextStartable();

    std::vector<Job> jobs_;
    std::vector<State> states_;
    std::vector<Record> records_;
    std::vector<const void*> busy_;  // resources at work
    std::size_t first_waiting_ = 0;  // no job before it waits
    bool stopping_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::thread> threads_;
};

}  // namespace etalon
