// Whether a module may be given to a device at all. Drivers are free to crash on a capability that
// they do not offer (SwiftShader does), so that nobody may hand it to them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "device/device.h"

namespace etalon {

// The reason why the module cannot run, if so: it is no SPIR-V, its version is above `version`
// (major << 16 | minor << 8), or a capability is neither core nor among the device's features and
// float controls.
std::optional<std::string> Unsuitable(std::span<const std::uint32_t> module, std::uint32_t version,
                                      const DeviceInfo& info);

}  // namespace etalon
