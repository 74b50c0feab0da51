#include "device/gl/driver_files.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace etalon {
namespace {

namespace fs = std::filesystem;

constexpr int kMaxDepth = 7;

bool IsSharedLibrary(const std::string& name) {
    const std::size_t at = name.rfind(".so");
    return at != std::string::npos &&
           (at + 3 == name.size() || name.find_first_not_of(".0123456789", at + 3) == name.npos);
}

std::string Join(const auto& paths) {
    std::string joined;
    for (const fs::path& path : paths) {
        joined += (joined.empty() ? "" : ":") + path.string();
    }
    return joined;
}

void Sort(DriverFiles& files, const fs::path& path) {
    const std::string name = path.filename();
    if (!IsSharedLibrary(name)) {
        return;
    }
    files.library_folders.insert(path.parent_path());
    if (std::find(std::begin(kOsmesaNames), std::end(kOsmesaNames), name) !=
            std::end(kOsmesaNames) &&
        files.osmesa.filename() < name) {
        files.osmesa = path;
    } else if (name == kEglName) {
        files.egl = path;
    } else if (name.starts_with("libGLdispatch.so")) {
        files.egl_is_loader = true;
    } else if (name.starts_with("libEGL_") && name.ends_with(".so.0")) {
        files.egl_vendors.push_back(path);
    } else if (name.ends_with("_dri.so")) {
        files.dri_folder = path.parent_path();
    } else if (name == "libvulkan_lvp.so") {
        files.lavapipe = path;
    }
}

}  // namespace

DriverFiles FindDriverFiles(const fs::path& prefix) {
    DriverFiles files;
    std::error_code error;
    const fs::path root = fs::absolute(prefix, error).lexically_normal();
    auto entry = fs::recursive_directory_iterator(
        root, fs::directory_options::skip_permission_denied, error);
    while (!error && entry != fs::recursive_directory_iterator()) {
        if (entry.depth() >= kMaxDepth) {
            entry.disable_recursion_pending();
        }
        std::error_code ignored;  // a link that leads nowhere is no library
        if (entry->is_regular_file(ignored)) {
            Sort(files, entry->path());
        }
        entry.increment(error);
    }
    std::sort(files.egl_vendors.begin(), files.egl_vendors.end());
    return files;
}

std::map<std::string, std::string> PrefixEnvironment(const DriverFiles& files) {
    std::string folders = Join(files.library_folders);
    const char* before = std::getenv("LD_LIBRARY_PATH");
    if (before != nullptr && *before != '\0') {
        folders += ":" + std::string(before);
    }
    std::map<std::string, std::string> environment = {{"LD_LIBRARY_PATH", folders}};
    if (!files.dri_folder.empty()) {
        environment["LIBGL_DRIVERS_PATH"] = files.dri_folder;
    }
    return environment;
}

bool HasLibrary(const std::vector<fs::path>& folders, const std::string& name) {
    return std::any_of(folders.begin(), folders.end(), [&](const fs::path& folder) {
        std::error_code error;
        return fs::exists(folder / name, error);
    });
}

std::vector<fs::path> SystemLibraryFolders() {
    std::vector<fs::path> folders;
    const char* variable = std::getenv("LD_LIBRARY_PATH");
    std::string path = variable != nullptr ? variable : "";
    for (std::size_t begin = 0; begin < path.size();) {
        const std::size_t end = std::min(path.find(':', begin), path.size());
        folders.push_back(path.substr(begin, end - begin));
        begin = end + 1;
    }
    for (const char* root : {"/usr/local/lib", "/usr/lib", "/lib"}) {
        folders.push_back(root);
        folders.push_back(std::string(root) + "64");
        // Debian's folders per architecture. Another architecture's library only makes a candidate
        // that does not open.
        std::error_code error;
        for (auto entry = fs::directory_iterator(root, error);
             !error && entry != fs::directory_iterator(); entry.increment(error)) {
            if (entry->path().filename().string().ends_with("-linux-gnu")) {
                folders.push_back(entry->path());
            }
        }
    }
    return folders;
}

}  // namespace etalon
