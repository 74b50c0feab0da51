// `etalon map`: a picture of a case over two of its inputs, on any devices.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"
#include "map/map_plan.h"
#include "report/map_record.h"
#include "run/devices.h"

namespace etalon {

struct MapChoice {
    std::filesystem::path root;  // holds cases/
    std::string pattern;         // must name one case
    MapScope scope;
    std::string recipe;   // empty: each device's own
    std::string options;  // for repeat commands: " --root DIR", or empty
    DeviceChoice
        devices;  // no patterns: the first there is of Vulkan's llvmpipe, OSMesa's, and cpu
};

// Fails for what the user got wrong, and where no device can run the case. A crash is none: its
// cells are marked.
Result<MapRecord> MakeMap(const MapChoice& choice);

}  // namespace etalon
