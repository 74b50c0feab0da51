#include "device/vulkan/vulkan.h"

namespace etalon {

DeviceFailure FailureOf(const vk::SystemError& error, DeviceFailure::Kind otherwise) {
    using Kind = DeviceFailure::Kind;
    Kind kind = otherwise;
    switch (static_cast<vk::Result>(error.code().value())) {
        case vk::Result::eErrorDeviceLost:
        case vk::Result::eErrorOutOfDeviceMemory:
        case vk::Result::eErrorOutOfHostMemory:
            kind = Kind::kLost;
            break;
        case vk::Result::eErrorInvalidShaderNV:
            kind = Kind::kRejected;
            break;
        case vk::Result::eErrorFeatureNotPresent:
        case vk::Result::eErrorExtensionNotPresent:
        case vk::Result::eErrorFormatNotSupported:
        case vk::Result::eErrorIncompatibleDriver:
            kind = Kind::kUnsupported;
            break;
        default:
            break;
    }
    return {kind, error.what()};
}

}  // namespace etalon
