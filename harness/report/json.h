// A run as JSON, for programs.
#pragma once

#include <string>

#include "report/record.h"

namespace etalon {

// An object with "version", "processor", "devices" (each as told, with its fingerprint), "absent"
// and "records". Numbers that JSON does not know (infinite errors) are strings.
std::string RunJson(const RunRecord& run);

// The devices alone: an array.
std::string DevicesJson(const RunRecord& run);

}  // namespace etalon
