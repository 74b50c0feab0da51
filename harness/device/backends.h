// The backends: which implementations this machine may have, and how a worker opens one.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "device/device.h"

namespace etalon {

// `--driver NAME=DIR`: an unpacked or freshly built driver under a prefix. An empty name is the
// installed one.
struct Driver {
    std::string name;
    std::filesystem::path prefix;
};

// One implementation to try, found without touching a driver: everything that a fresh worker
// process needs to know. The worker is started with `environment` added to its own, before any
// driver library is loaded.
struct Candidate {
    std::string backend;  // row of kBackends: "vulkan", "osmesa", "egl", "null"
    std::string
        hint;  // the backend's own word: an ICD file, a Gallium driver's name, a fault to play
    std::uint32_t index = 0;  // which of the candidate's devices; see DeviceInfo::siblings
    std::uint32_t attempt =
        0;               // 0 at first, 1 in the fresh worker that repeats a crashed or hung run
    std::string driver;  // Driver::name
    std::map<std::string, std::string> environment;
};

struct Backend {
    std::string name;
    // Runs in the judging process: looks at files only. Never fails; offers what may work.
    std::vector<Candidate> (*candidates)(const Driver& driver);
    // Runs in a worker. The device's name ends in "@NAME" where the candidate has a driver name.
    DeviceResult<std::unique_ptr<Device>> (*open)(const Candidate& candidate);
};

const std::vector<Backend>& Backends();

// All backends' candidates for the driver, in the order in which devices are listed.
std::vector<Candidate> Candidates(const Driver& driver);

// Opens the candidate with its backend. Call in a worker only.
DeviceResult<std::unique_ptr<Device>> OpenDevice(const Candidate& candidate);

}  // namespace etalon
