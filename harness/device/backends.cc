#include "device/backends.h"

#include <iterator>

#include "device/cpu/cpu_device.h"
#include "device/gl/gl_device.h"
#include "device/null/null_device.h"
#include "device/vulkan/vulkan_device.h"

namespace etalon {

// To add a backend: one folder like device/null, one row here.
const std::vector<Backend>& Backends() {
    static const std::vector<Backend> backends = {
        {"vulkan", VulkanCandidates, OpenVulkanDevice},
        {"osmesa", OsmesaCandidates, OpenOsmesaDevice},
        {"egl", EglCandidates, OpenEglDevice},
        {"cpu", CpuCandidates, OpenCpuDevice},
        {"null", NullCandidates, OpenNullDevice},
    };
    return backends;
}

std::vector<Candidate> Candidates(const Driver& driver) {
    std::vector<Candidate> all;
    for (const Backend& backend : Backends()) {
        std::vector<Candidate> some = backend.candidates(driver);
        std::move(some.begin(), some.end(), std::back_inserter(all));
    }
    return all;
}

DeviceResult<std::unique_ptr<Device>> OpenDevice(const Candidate& candidate) {
    for (const Backend& backend : Backends()) {
        if (backend.name == candidate.backend) {
            return backend.open(candidate);
        }
    }
    return DeviceFailure{DeviceFailure::Kind::kUnsupported,
                         "no backend is named '" + candidate.backend + "'"};
}

}  // namespace etalon
