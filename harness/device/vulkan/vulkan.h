// Vulkan-Hpp as this folder uses it: entry points loaded at run time (nothing links libvulkan), and
// exceptions that end at Guard.
#pragma once

#define VK_NO_PROTOTYPES
#include <type_traits>
#include <vulkan/vulkan_raii.hpp>

#include "device/device.h"

namespace etalon {

// Why a call failed. A lost device and a lack of memory are kLost, a refused shader is kRejected,
// something that is not there is kUnsupported; all else is `otherwise`.
DeviceFailure FailureOf(const vk::SystemError& error, DeviceFailure::Kind otherwise);

// Runs a step that returns a DeviceResult and turns Vulkan's exceptions into failures.
template <typename Step>
std::invoke_result_t<Step> Guard(DeviceFailure::Kind otherwise, Step&& step) {
    try {
        return step();
    } catch (const vk::SystemError& error) {
        return FailureOf(error, otherwise);
    }
}

inline DeviceFailure Unsupported(std::string reason) {
    return {DeviceFailure::Kind::kUnsupported, std::move(reason)};
}

}  // namespace etalon
