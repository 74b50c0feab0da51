// GL errors as DeviceFailures.
#pragma once

#include "device/device.h"
#include "device/gl/gl_functions.h"

namespace etalon {

// Fails if GL has recorded an error since the last check; `step` says what was being done
// ("reading the outputs"). Out of memory or a lost context means that the device is gone.
DeviceResult<Nothing> CheckGl(const GlFunctions& gl, const char* step);

inline DeviceFailure Unsupported(std::string reason) {
    return {DeviceFailure::Kind::kUnsupported, std::move(reason)};
}

}  // namespace etalon
