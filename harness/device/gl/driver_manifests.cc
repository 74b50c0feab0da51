#include "device/gl/driver_manifests.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "base/file.h"
#include "device/gl/driver_files.h"
#include "device/gl/gl_context.h"

namespace etalon {
namespace {

std::string Quoted(const std::string& text) {
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

DriverManifests::DriverManifests() {
    const std::string vendors = EnvironmentValue(kEglVendorsVariable);
    const std::string vulkan = EnvironmentValue(kVulkanLibraryVariable);
    if (vendors.empty() && vulkan.empty()) {
        return;
    }
    std::error_code error;
    std::string name = (std::filesystem::temp_directory_path(error) / "etalon-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        return;
    }
    folder_ = name;
    std::string egl_manifests;
    for (std::size_t begin = 0; begin < vendors.size();) {
        const std::size_t end = std::min(vendors.find(':', begin), vendors.size());
        egl_manifests +=
            (egl_manifests.empty() ? "" : ":") + Write(vendors.substr(begin, end - begin));
        begin = end + 1;
    }
    if (!egl_manifests.empty()) {
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", egl_manifests.c_str(), 1);
    }
    if (!vulkan.empty()) {
        const std::string manifest = Write(vulkan);
        setenv("VK_DRIVER_FILES", manifest.c_str(), 1);
        setenv("VK_ICD_FILENAMES", manifest.c_str(), 1);  // its name before loader 1.3.207
    }
}

DriverManifests::~DriverManifests() {
    if (!folder_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
}

std::string DriverManifests::Write(const std::string& library) {
    const std::filesystem::path path = folder_ / (std::to_string(written_++) + ".json");
    // The Vulkan loader asks for the version only to know a driver of 1.0.
    const std::string text =
        "{\"file_format_version\": \"1.0.0\", \"ICD\": {\"library_path\": " + Quoted(library) +
        ", \"api_version\": \"1.1.0\"}}\n";
    // A file that could not be written is one that the loader does not find, and says so.
    static_cast<void>(WriteFile(path, text).ok());
    return path;
}

}  // namespace etalon
