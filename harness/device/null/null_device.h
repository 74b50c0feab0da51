// The null device: no driver at all; returns what it is told. The template for a new backend, and
// the stand-in that plays a driver's faults in the tests of the isolation.
#pragma once

#include "device/backends.h"

namespace etalon {

// One candidate per behaviour: "null:echo", "null:crash", ... They are run only where named.
std::vector<Candidate> NullCandidates(const Driver& driver);
DeviceResult<std::unique_ptr<Device>> OpenNullDevice(const Candidate& candidate);

}  // namespace etalon
