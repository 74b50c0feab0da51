// Vulkan: every physical device of every installed driver (ICD), one candidate per ICD file.
#pragma once

#include "device/backends.h"

namespace etalon {

// ICD files of the loader's folders, of VK_DRIVER_FILES, of Chromium's SwiftShader, or of the
// driver's prefix.
std::vector<Candidate> VulkanCandidates(const Driver& driver);

DeviceResult<std::unique_ptr<Device>> OpenVulkanDevice(const Candidate& candidate);

}  // namespace etalon
