#include "run/schedule.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>

namespace etalon {
namespace {

using std::chrono::milliseconds;

Record Named(const std::string& name) {
    Record record;
    record.case_path = name;
    return record;
}

TEST(Schedule, GivesEachJobsRecordInAnyOrder) {
    std::vector<Schedule::Job> jobs;
    const int devices[2] = {};
    for (int i = 0; i < 20; ++i) {
        jobs.push_back({&devices[i % 2], [i] { return Named(std::to_string(i)); }});
    }
    Schedule schedule(std::move(jobs), 3);
    for (const std::size_t i : {19u, 0u, 7u, 8u}) {
        EXPECT_EQ(schedule.Take(i).case_path, std::to_string(i));
    }
}

TEST(Schedule, WorksOnDifferentResourcesAtTheSameTimeAndOnOneNever) {
    const int devices[2] = {};
    std::atomic<int> at_work[2] = {};
    std::atomic<int> together = 0;
    std::atomic<bool> shared_one = false;
    std::vector<Schedule::Job> jobs;
    for (int i = 0; i < 12; ++i) {
        jobs.push_back({&devices[i % 2], [&, i] {
                            shared_one = shared_one || ++at_work[i % 2] > 1;
                            std::this_thread::sleep_for(milliseconds(5));
                            together += at_work[1 - i % 2];
                            --at_work[i % 2];
                            return Record();
                        }});
    }
    Schedule schedule(std::move(jobs), 4);
    for (std::size_t i = 0; i < 12; ++i) {
        schedule.Take(i);
    }
    EXPECT_FALSE(shared_one);
    EXPECT_GT(together, 0);
}

TEST(Schedule, LeavesUndoneWhatHasNotBegunWhenItEnds) {
    const int device = 0;
    std::atomic<int> begun = 0;
    {
        std::vector<Schedule::Job> jobs(50, {&device, [&] {
                                                 ++begun;
                                                 std::this_thread::sleep_for(milliseconds(5));
                                                 return Record();
                                             }});
        Schedule schedule(std::move(jobs), 2);
        schedule.Take(0);
    }
    EXPECT_LT(begun, 50);
}

}  // namespace
}  // namespace etalon
