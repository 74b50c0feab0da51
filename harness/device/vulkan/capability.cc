#include "device/vulkan/capability.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace etalon {
namespace {

constexpr std::uint32_t kMagic = 0x07230203;
constexpr std::size_t kHeaderWords = 5;
constexpr std::uint32_t kOpCapability = 17;

struct Capability {
    std::uint32_t number;
    std::string_view name;
    std::string_view feature;        // of DeviceInfo::features; empty: every device has it
    std::string_view float_control;  // of DeviceInfo::float_controls
};

constexpr std::array kCapabilities = {
    Capability{0, "Matrix", "", ""},
    Capability{1, "Shader", "", ""},
    Capability{9, "Float16", "float16", ""},
    Capability{10, "Float64", "float64", ""},
    Capability{11, "Int64", "int64", ""},
    Capability{22, "Int16", "int16", ""},
    Capability{39, "Int8", "int8", ""},
    Capability{43, "Sampled1D", "", ""},
    Capability{50, "ImageQuery", "", ""},
    Capability{51, "DerivativeControl", "", ""},
    Capability{4464, "DenormPreserve", "", "DenormPreserve"},
    Capability{4465, "DenormFlushToZero", "", "DenormFlushToZero"},
    Capability{4466, "SignedZeroInfNanPreserve", "", "SignedZeroInfNanPreserve"},
    Capability{4467, "RoundingModeRTE", "", "RoundingModeRTE"},
    Capability{4468, "RoundingModeRTZ", "", "RoundingModeRTZ"},
};

bool Offers(const DeviceInfo& info, const Capability& capability) {
    const auto& controls = info.float_controls;
    return (capability.feature.empty() || info.Has(capability.feature)) &&
           (capability.float_control.empty() ||
            std::find(controls.begin(), controls.end(), capability.float_control) !=
                controls.end());
}

std::string VersionText(std::uint32_t version) {
    return std::to_string(version >> 16 & 0xff) + "." + std::to_string(version >> 8 & 0xff);
}

}  // namespace

std::optional<std::string> Unsuitable(std::span<const std::uint32_t> module, std::uint32_t version,
                                      const DeviceInfo& info) {
    if (module.size() < kHeaderWords || module[0] != kMagic) {
        return "the module is not SPIR-V";
    }
    if (module[1] > version) {
        return "the module is SPIR-V " + VersionText(module[1]) + ", the device takes " +
               VersionText(version) + " at most";
    }
    // Capabilities come first in a module.
    for (std::size_t at = kHeaderWords; at + 1 < module.size(); at += module[at] >> 16) {
        if ((module[at] & 0xffff) != kOpCapability || module[at] >> 16 == 0) {
            break;
        }
        const std::uint32_t number = module[at + 1];
        const auto* const row =
            std::find_if(kCapabilities.begin(), kCapabilities.end(),
                         [&](const Capability& capability) { return capability.number == number; });
        if (row == kCapabilities.end()) {
            return "the module needs SPIR-V capability " + std::to_string(number) +
                   ", which this backend never offers";
        }
        if (!Offers(info, *row)) {
            return "the device has no " + std::string(row->name);
        }
    }
    return std::nullopt;
}

}  // namespace etalon
