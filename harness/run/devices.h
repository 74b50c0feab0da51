// The devices of a run: found, opened, each in its worker.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "report/record.h"
#include "run/runner.h"
#include "worker/client.h"

namespace etalon {

struct DeviceChoice {
    std::vector<std::string> patterns;  // of names, with * and ?; a driver's name alone means all
                                        // its devices; empty: all
    std::vector<Driver> drivers;        // --driver, beside the installed ones
    WorkerLimits limits;
};

struct DeviceSet {
    std::vector<std::unique_ptr<Runner>> runners;
    std::shared_ptr<Programs> programs;  // that the runners share
    std::vector<DeviceNote> absent;      // candidates that are no devices here, and why
};

// Opens all devices that the choice names. Fails where a pattern matches none, with the reasons
// known.
Result<DeviceSet> OpenDevices(const DeviceChoice& choice);

}  // namespace etalon
