// Plays what a broken driver may do to the worker it runs in, beyond the null device's faults.
#pragma once

#include <string>

namespace etalon {

// The variable that names the fault for a worker of the test program.
inline constexpr const char* kWorkerFault = "ETALON_TEST_FAULT";

// True where the worker should serve nevertheless.
bool Misbehave(const std::string& fault);

}  // namespace etalon
