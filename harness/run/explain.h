// `etalon explain`: one input of a case, operation by operation, on every device.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "report/explanation.h"
#include "run/devices.h"

namespace etalon {

struct ExplainChoice {
    std::filesystem::path root;  // holds cases/
    std::string pattern;         // must name one case
    std::string at;      // "n1=1,n2=0x1.8p+0"; empty: the worst input that a run of the case finds
    std::string output;  // "result.x"; empty: the first that is judged, or a law's left side
    std::vector<std::string> recipes;  // empty: each device's own
    DeviceChoice devices;
};

// Fails for what the user got wrong, and where the program cannot be evaluated on the host.
Result<Explanation> Explain(const ExplainChoice& choice);

}  // namespace etalon
