// Where a driver's files are, and how they reach the worker; nothing is loaded here.
#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace etalon {

// Set for the worker of a driver under a prefix: absolute paths of its libraries.
inline constexpr char kOsmesaLibraryVariable[] = "ETALON_OSMESA_LIBRARY";
inline constexpr char kEglVendorsVariable[] = "ETALON_EGL_VENDOR_LIBRARIES";  // joined by ':'
inline constexpr char kVulkanLibraryVariable[] = "ETALON_VULKAN_LIBRARY";

// OSMesa's file names, newest first.
inline constexpr const char* kOsmesaNames[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
inline constexpr char kEglName[] = "libEGL.so.1";

// What lies under a prefix; empty where there is no such file.
struct DriverFiles {
    std::set<std::filesystem::path> library_folders;  // all that hold shared libraries
    std::filesystem::path osmesa;
    std::filesystem::path egl;                       // a libEGL.so.1 of its own
    bool egl_is_loader = false;                      // and it only loads vendors (glvnd)
    std::vector<std::filesystem::path> egl_vendors;  // libEGL_mesa.so.0 and the like
    std::filesystem::path dri_folder;                // of *_dri.so
    std::filesystem::path lavapipe;
};

// Looks a bounded number of folders deep, which is enough for an unpacked package, an installation
// and Mesa's build folder.
DriverFiles FindDriverFiles(const std::filesystem::path& prefix);

// The environment that makes the loaders find the driver's libraries first.
std::map<std::string, std::string> PrefixEnvironment(const DriverFiles& files);

// True if one of the folders holds the file `name`.
bool HasLibrary(const std::vector<std::filesystem::path>& folders, const std::string& name);

// LD_LIBRARY_PATH's folders and the system's.
std::vector<std::filesystem::path> SystemLibraryFolders();

}  // namespace etalon
