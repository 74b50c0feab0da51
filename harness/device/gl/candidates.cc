#include <algorithm>

#include "device/gl/driver_files.h"
#include "device/gl/gl_device.h"

namespace etalon {
namespace {

using Environment = std::map<std::string, std::string>;

Candidate MakeCandidate(std::string backend, std::string hint, const Driver& driver,
                        Environment environment, const Environment& more) {
    environment.insert(more.begin(), more.end());
    return {std::move(backend), std::move(hint), 0, 0, driver.name, std::move(environment)};
}

}  // namespace

std::vector<Candidate> OsmesaCandidates(const Driver& driver) {
    Environment environment;
    bool found = false;
    if (driver.prefix.empty()) {
        const std::vector<std::filesystem::path> folders = SystemLibraryFolders();
        found = std::any_of(std::begin(kOsmesaNames), std::end(kOsmesaNames),
                            [&](const char* name) { return HasLibrary(folders, name); });
    } else {
        const DriverFiles files = FindDriverFiles(driver.prefix);
        found = !files.osmesa.empty();
        environment = PrefixEnvironment(files);
        environment[kOsmesaLibraryVariable] = files.osmesa;
    }
    std::vector<Candidate> candidates;
    if (found) {
        for (const char* gallium : {"llvmpipe", "softpipe"}) {
            candidates.push_back(MakeCandidate("osmesa", gallium, driver, environment,
                                               {{"GALLIUM_DRIVER", gallium}}));
        }
    }
    return candidates;
}

std::vector<Candidate> EglCandidates(const Driver& driver) {
    Environment environment;
    bool found = false;
    bool vulkan = false;  // for zink
    if (driver.prefix.empty()) {
        const std::vector<std::filesystem::path> folders = SystemLibraryFolders();
        found = HasLibrary(folders, kEglName);
        vulkan = HasLibrary(folders, "libvulkan.so.1");
    } else {
        const DriverFiles files = FindDriverFiles(driver.prefix);
        // A loader without a vendor of the prefix would load the installed one.
        found = !files.egl_vendors.empty() || (!files.egl.empty() && !files.egl_is_loader);
        vulkan = !files.lavapipe.empty();
        environment = PrefixEnvironment(files);
        std::string vendors;
        for (const std::filesystem::path& vendor : files.egl_vendors) {
            vendors += (vendors.empty() ? "" : ":") + vendor.string();
        }
        environment[kEglVendorsVariable] = vendors;
        environment[kVulkanLibraryVariable] = files.lavapipe;
    }
    std::vector<Candidate> candidates;
    if (!found) {
        return candidates;
    }
    for (const char* gallium : {"llvmpipe", "softpipe"}) {
        candidates.push_back(
            MakeCandidate("egl", gallium, driver, environment,
                          {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"GALLIUM_DRIVER", gallium}}));
    }
    if (vulkan) {
        candidates.push_back(MakeCandidate(
            "egl", "zink", driver, environment,
            {{"LIBGL_ALWAYS_SOFTWARE", "1"}, {"MESA_LOADER_DRIVER_OVERRIDE", "zink"}}));
    }
    candidates.push_back(MakeCandidate("egl", "hardware", driver, environment, {}));
    return candidates;
}

}  // namespace etalon
