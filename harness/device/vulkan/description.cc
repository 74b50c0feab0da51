#include "device/vulkan/description.h"

#include <algorithm>
#include <optional>

#include "device/vulkan/names.h"

namespace etalon {
namespace {

constexpr std::uint32_t kMostRows = 1u << 20;

std::string VersionText(std::uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

std::uint32_t SpirvVersion(std::uint32_t api) {
    if (api >= VK_API_VERSION_1_3) {
        return 0x10600;
    }
    return api >= VK_API_VERSION_1_2 ? 0x10500 : 0x10300;
}

// The family with compute that has graphics too, else the first with compute.
std::optional<std::uint32_t> QueueFamily(const std::vector<vk::QueueFamilyProperties>& families) {
    const auto find = [&](vk::QueueFlags flags) -> std::optional<std::uint32_t> {
        for (std::uint32_t family = 0; family < families.size(); ++family) {
            if ((families[family].queueFlags & flags) == flags) {
                return family;
            }
        }
        return std::nullopt;
    };
    const auto both = find(vk::QueueFlagBits::eCompute | vk::QueueFlagBits::eGraphics);
    return both ? both : find(vk::QueueFlagBits::eCompute);
}

// One device under description: queries that need 1.2 or an extension of 1.1.
class Subject {
  public:
    explicit Subject(const vk::raii::PhysicalDevice& physical)
        : physical_(physical), properties_(physical.getProperties()) {
        for (const auto& extension : physical.enumerateDeviceExtensionProperties()) {
            extensions_.emplace_back(extension.extensionName.data());
        }
    }

    const vk::PhysicalDeviceProperties& properties() const { return properties_; }

    // Whether what the extension brought can be asked for; 1.2 took all of those used here in.
    bool Offers(std::string_view extension) const {
        return properties_.apiVersion >= VK_API_VERSION_1_2 || Lists(extension);
    }
    bool Lists(std::string_view extension) const {
        return std::find(extensions_.begin(), extensions_.end(), extension) != extensions_.end();
    }

    template <typename Properties>
    Properties Ask() const {
        return physical_.getProperties2<vk::PhysicalDeviceProperties2, Properties>()
            .template get<Properties>();
    }

    template <typename Features>
    Features AskFeatures() const {
        return physical_.getFeatures2<vk::PhysicalDeviceFeatures2, Features>()
            .template get<Features>();
    }

  private:
    const vk::raii::PhysicalDevice& physical_;
    vk::PhysicalDeviceProperties properties_;
    std::vector<std::string> extensions_;
};

std::string Name(const std::vector<vk::raii::PhysicalDevice>& devices, const Candidate& candidate) {
    const auto slug = [&](std::size_t index) {
        return Slug(devices[index].getProperties().deviceName.data());
    };
    const std::string own = slug(candidate.index);
    std::uint32_t number = 1;
    for (std::size_t before = 0; before < candidate.index; ++before) {
        number += slug(before) == own ? 1 : 0;
    }
    return "vulkan:" + own + (number > 1 ? "#" + std::to_string(number) : "") +
           (candidate.driver.empty() ? "" : "@" + candidate.driver);
}

void NameDriver(const Subject& subject, DeviceInfo& info) {
    info.description = subject.properties().deviceName.data();
    info.api = "Vulkan " + VersionText(subject.properties().apiVersion);
    info.version = VersionText(subject.properties().driverVersion);
    std::string words;
    if (subject.Offers("VK_KHR_driver_properties")) {
        const auto driver = subject.Ask<vk::PhysicalDeviceDriverProperties>();
        info.driver = driver.driverName.data();
        words = driver.driverInfo.data();
        if (!words.empty()) {
            info.version = words.substr(0, words.find(" ("));
        }
    }
    info.compiler = CompilerOf(info.description, words);
}

void ListFloatControls(const Subject& subject, DeviceInfo& info) {
    if (!subject.Offers("VK_KHR_shader_float_controls")) {
        return;
    }
    const auto controls = subject.Ask<vk::PhysicalDeviceFloatControlsProperties>();
    const std::pair<vk::Bool32, const char*> rows[] = {
        {controls.shaderSignedZeroInfNanPreserveFloat32, "SignedZeroInfNanPreserve"},
        {controls.shaderDenormPreserveFloat32, "DenormPreserve"},
        {controls.shaderDenormFlushToZeroFloat32, "DenormFlushToZero"},
        {controls.shaderRoundingModeRTEFloat32, "RoundingModeRTE"},
        {controls.shaderRoundingModeRTZFloat32, "RoundingModeRTZ"},
    };
    for (const auto& [present, name] : rows) {
        if (present) {
            info.float_controls.emplace_back(name);
        }
    }
}

void ListFeatures(const Subject& subject, const vk::PhysicalDeviceFeatures& features,
                  bool has_graphics, DeviceInfo& info) {
    info.features = {"compute", "spirv"};
    const auto add = [&](vk::Bool32 present, const char* name) {
        if (present) {
            info.features.emplace_back(name);
        }
    };
    add(has_graphics && features.fragmentStoresAndAtomics, "fragment");
    add(features.shaderFloat64, "float64");
    add(features.shaderInt64, "int64");
    add(features.shaderInt16, "int16");
    if (subject.Offers("VK_KHR_shader_float16_int8")) {
        const auto small = subject.AskFeatures<vk::PhysicalDeviceShaderFloat16Int8Features>();
        add(small.shaderFloat16, "float16");
        add(small.shaderInt8, "int8");
    }
}

}  // namespace

DeviceResult<Description> Describe(const std::vector<vk::raii::PhysicalDevice>& devices,
                                   const Candidate& candidate) {
    const vk::raii::PhysicalDevice& physical = devices[candidate.index];
    const Subject subject(physical);
    const std::uint32_t api = subject.properties().apiVersion;
    if (api < VK_API_VERSION_1_1) {
        return Unsupported(std::string(subject.properties().deviceName.data()) +
                           ": offers Vulkan " + VersionText(api) + ", 1.1 is needed");
    }
    const auto families = physical.getQueueFamilyProperties();
    const std::optional<std::uint32_t> family = QueueFamily(families);
    if (!family) {
        return Unsupported("the device has no queue for compute");
    }
    Description description;
    description.queue_family = *family;
    description.timestamp_bits = families[*family].timestampValidBits;
    description.spirv_version = SpirvVersion(api);

    const vk::PhysicalDeviceFeatures offered = physical.getFeatures();
    description.features.shaderFloat64 = offered.shaderFloat64;
    description.features.shaderInt64 = offered.shaderInt64;
    description.features.shaderInt16 = offered.shaderInt16;
    description.features.fragmentStoresAndAtomics = offered.fragmentStoresAndAtomics;
    description.features.robustBufferAccess = offered.robustBufferAccess;
    for (const char* extension : {"VK_KHR_shader_float_controls", "VK_KHR_shader_float16_int8"}) {
        if (api < VK_API_VERSION_1_2 && subject.Lists(extension)) {
            description.extensions.emplace_back(extension);
        }
    }

    DeviceInfo& info = description.info;
    info.name = Name(devices, candidate);
    info.siblings = static_cast<std::uint32_t>(devices.size());
    info.on_host = subject.properties().deviceType == vk::PhysicalDeviceType::eCpu;
    NameDriver(subject, info);
    ListFloatControls(subject, info);
    ListFeatures(subject, offered,
                 static_cast<bool>(families[*family].queueFlags & vk::QueueFlagBits::eGraphics),
                 info);
    const vk::PhysicalDeviceLimits& limits = subject.properties().limits;
    const std::uint64_t most_compute =
        std::uint64_t{limits.maxComputeWorkGroupCount[0]} * kLocalSize;
    const std::uint64_t most_fragment =
        std::uint64_t{std::min(limits.maxFramebufferHeight, limits.maxViewportDimensions[1])} *
        kFragmentWidth;
    info.max_rows = static_cast<std::uint32_t>(
        std::min({std::uint64_t{kMostRows}, most_compute, most_fragment}));
    return description;
}

}  // namespace etalon
