// Description: what a physical device offers, and what of it the kit turns on.
#pragma once

#include "device/backends.h"
#include "device/vulkan/vulkan.h"

namespace etalon {

struct Description {
    DeviceInfo info;
    std::uint32_t queue_family = 0;       // has compute, and graphics if any family has both
    std::uint32_t timestamp_bits = 0;     // of that queue; 0 where it has none
    std::uint32_t spirv_version = 0;      // the highest taken: major << 16 | minor << 8
    vk::PhysicalDeviceFeatures features;  // to enable
    std::vector<std::string> extensions;  // to enable
};

// Describes devices[candidate.index]; the others count as its siblings.
DeviceResult<Description> Describe(const std::vector<vk::raii::PhysicalDevice>& devices,
                                   const Candidate& candidate);

}  // namespace etalon
