// Whether what a device tells of the time of its runs makes sense.
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "device/device.h"

namespace etalon {

// Runs the program `handle`, of one word in and out, at so many rows: what it tells is no more than
// passed here meanwhile.
inline RunTime TimedRun(Device& device, std::uint32_t handle, std::uint32_t rows) {
    const std::vector<std::uint32_t> inputs(rows, 1);
    std::vector<std::uint32_t> outputs(rows);
    RunTime time;
    const Stopwatch stopwatch;
    const auto done = device.Run(handle, rows, inputs, outputs, &time);
    const RunTime passed = stopwatch.Read();
    EXPECT_TRUE(done.ok()) << done.error().reason;
    EXPECT_GT(time.seconds, 0);
    // Clocks of two kinds.
    EXPECT_LE(time.seconds, 1.01 * passed.seconds + 1e-3);
    EXPECT_GE(time.processor_seconds, 0);
    EXPECT_LE(time.processor_seconds, passed.processor_seconds);
    return time;
}

// A program that is much longer for many rows than for few takes so, by each clock: in the best of
// several runs, for other work may hold any of them up.
inline void ExpectTimesToGrow(Device& device, std::uint32_t handle, std::uint32_t many) {
    RunTime few_best = TimedRun(device, handle, 64);
    RunTime many_best = TimedRun(device, handle, many);
    const auto keep = [](RunTime& best, const RunTime& time) {
        best.seconds = std::min(best.seconds, time.seconds);
        best.processor_seconds = std::min(best.processor_seconds, time.processor_seconds);
    };
    for (int i = 0; i < 5; ++i) {
        keep(few_best, TimedRun(device, handle, 64));
        keep(many_best, TimedRun(device, handle, many));
    }
    EXPECT_GT(many_best.seconds, 2 * few_best.seconds);
    if (device.info().on_host) {
        EXPECT_GT(many_best.processor_seconds, 2 * few_best.processor_seconds);
        // All threads together.
        EXPECT_GT(many_best.processor_seconds, 0.2 * many_best.seconds);
    }
}

}  // namespace etalon
