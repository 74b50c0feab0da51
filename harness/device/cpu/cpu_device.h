// The device "cpu": no driver, but the evaluator in binary32. The strict reading of a program, each
// operation rounded correctly in the order of the source.
#pragma once

#include "device/backends.h"

namespace etalon {

// One candidate, of no driver.
std::vector<Candidate> CpuCandidates(const Driver& driver);
DeviceResult<std::unique_ptr<Device>> OpenCpuDevice(const Candidate& candidate);

}  // namespace etalon
