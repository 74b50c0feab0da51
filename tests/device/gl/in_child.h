// Opens a device in a process of its own: OSMesa and EGL clash in one, and Mesa reads its
// environment once.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iostream>

#include "device/gl/gl_device.h"

namespace etalon {

enum class ChildEnd : int { kPassed = 0, kFailed = 1, kNotOpened = 77, kCrashed = -1 };

// Runs `body` with the candidate's device in a child. Failed expectations show in the output and
// make it kFailed.
inline ChildEnd InChild(const Candidate& candidate, const std::function<void(Device&)>& body) {
    std::cout.flush();
    const pid_t child = fork();
    if (child == 0) {
        for (const auto& [name, value] : candidate.environment) {
            setenv(name.c_str(), value.c_str(), 1);
        }
        auto device =
            candidate.backend == "osmesa" ? OpenOsmesaDevice(candidate) : OpenEglDevice(candidate);
        ChildEnd end = ChildEnd::kNotOpened;
        if (device) {
            body(**device);
            end = ::testing::Test::HasFailure() ? ChildEnd::kFailed : ChildEnd::kPassed;
        } else {
            EXPECT_EQ(device.error().kind, DeviceFailure::Kind::kUnsupported);
            std::cout << device.error().reason << std::endl;
        }
        std::cout.flush();
        std::fflush(nullptr);
        _exit(static_cast<int>(end));
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status)) {
        return ChildEnd::kCrashed;
    }
    return static_cast<ChildEnd>(WEXITSTATUS(status));
}

}  // namespace etalon
