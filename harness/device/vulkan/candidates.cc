#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <system_error>

#include "device/vulkan/icd.h"
#include "device/vulkan/vulkan_device.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

// Deep enough for a build tree, shallow enough for a prefix that was a mistake.
constexpr int kDepth = 8;

// Folders of browsers, which bring SwiftShader along without telling the loader.
constexpr std::array kBrowsers = {"/usr/lib/chromium",         "/usr/lib64/chromium",
                                  "/usr/lib/chromium-browser", "/usr/lib64/chromium-browser",
                                  "/opt/google/chrome",        "/opt/microsoft/msedge"};

std::string Environment(const char* name) {
    const char* const value = std::getenv(name);
    return value == nullptr ? "" : value;
}

std::vector<fs::path> SplitPaths(const std::string& text) {
    std::vector<fs::path> paths;
    std::istringstream stream(text);
    for (std::string path; std::getline(stream, path, ':');) {
        if (!path.empty()) {
            paths.emplace_back(path);
        }
    }
    return paths;
}

// The JSON files of a folder, by name; none where it is missing.
std::vector<fs::path> JsonFiles(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code failed;
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        if (entry->path().extension() == ".json") {
            files.push_back(entry->path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

// The folders that the loader searches, in its order.
std::vector<fs::path> LoaderFolders() {
    const auto either = [](const std::string& value, const std::string& otherwise) {
        return value.empty() ? otherwise : value;
    };
    const std::string home = Environment("HOME");
    std::vector<fs::path> roots;
    const auto add = [&](const std::string& list) {
        const std::vector<fs::path> paths = SplitPaths(list);
        roots.insert(roots.end(), paths.begin(), paths.end());
    };
    add(either(Environment("XDG_CONFIG_HOME"), home.empty() ? home : home + "/.config"));
    add(either(Environment("XDG_CONFIG_DIRS"), "/etc/xdg"));
    add("/etc");
    add(either(Environment("XDG_DATA_HOME"), home.empty() ? home : home + "/.local/share"));
    add(either(Environment("XDG_DATA_DIRS"), "/usr/local/share:/usr/share"));
    for (fs::path& root : roots) {
        root /= "vulkan/icd.d";
    }
    return roots;
}

std::vector<fs::path> InstalledManifests() {
    std::string named = Environment("VK_DRIVER_FILES");
    if (named.empty()) {
        named = Environment("VK_ICD_FILENAMES");
    }
    std::vector<fs::path> files;
    const auto add_folder = [&](const fs::path& folder) {
        const std::vector<fs::path> some = JsonFiles(folder);
        files.insert(files.end(), some.begin(), some.end());
    };
    std::error_code ignored;
    for (const fs::path& path : SplitPaths(named)) {
        if (fs::is_directory(path, ignored)) {
            add_folder(path);
        } else {
            files.push_back(path);
        }
    }
    if (!named.empty()) {
        return files;
    }
    for (const fs::path& folder : LoaderFolders()) {
        add_folder(folder);
    }
    for (const fs::path folder : kBrowsers) {
        const fs::path file = folder / "vk_swiftshader_icd.json";
        if (fs::exists(file, ignored)) {
            files.push_back(file);
            break;
        }
    }
    return files;
}

std::vector<Candidate> InstalledCandidates() {
    std::vector<Candidate> candidates;
    std::set<std::string> seen;  // libraries, or files that name none
    for (const fs::path& path : InstalledManifests()) {
        std::error_code ignored;
        const fs::path file = fs::absolute(path, ignored);
        const Result<IcdManifest> manifest = ReadIcdManifest(file);
        // One that cannot be read stays, so that the user hears of it when it is opened.
        if (manifest && manifest->foreign) {
            continue;
        }
        if (seen.insert(manifest ? manifest->library : file.string()).second) {
            Candidate candidate;
            candidate.backend = "vulkan";
            candidate.hint = file.string();
            candidate.environment = {{"VK_DRIVER_FILES", candidate.hint},
                                     {"VK_ICD_FILENAMES", candidate.hint}};
            candidates.push_back(std::move(candidate));
        }
    }
    return candidates;
}

// True for a library that this process could load, by the ELF header: class, byte order, machine.
bool IsLoadable(const fs::path& library) {
    constexpr std::size_t kHeader = 20;
    const auto header = [](const fs::path& file) {
        std::array<char, kHeader> bytes{};
        std::ifstream(file, std::ios::binary).read(bytes.data(), kHeader);
        return bytes;
    };
    const auto theirs = header(library);
    const auto ours = header("/proc/self/exe");
    return std::memcmp(theirs.data(), ours.data(), 6) == 0 && theirs[18] == ours[18] &&
           theirs[19] == ours[19];
}

// What a prefix holds, as far as drivers go.
struct Tree {
    std::vector<fs::path> manifests;
    std::vector<fs::path> libraries;  // shared libraries that this process could load
};

Tree Walk(const fs::path& prefix) {
    Tree tree;
    std::error_code failed;
    fs::recursive_directory_iterator entry(prefix, fs::directory_options::skip_permission_denied,
                                           failed);
    for (; !failed && entry != fs::recursive_directory_iterator(); entry.increment(failed)) {
        if (entry.depth() >= kDepth) {
            entry.disable_recursion_pending();
        }
        const fs::path& path = entry->path();
        const std::string name = path.filename().string();
        std::error_code ignored;
        if (path.extension() == ".json") {
            if (name.find("icd") != std::string::npos || path.parent_path().filename() == "icd.d") {
                tree.manifests.push_back(path);
            }
        } else if ((path.extension() == ".so" || name.find(".so.") != std::string::npos) &&
                   entry->is_regular_file(ignored) && IsLoadable(path)) {
            tree.libraries.push_back(path);
        }
    }
    std::sort(tree.manifests.begin(), tree.manifests.end());
    std::sort(tree.libraries.begin(), tree.libraries.end());
    return tree;
}

// The prefix's own copies of the drivers: the manifests' libraries by name, since a manifest states
// where its library would be installed, and whatever is named as a driver.
std::vector<fs::path> DriverLibraries(const Tree& tree) {
    std::set<std::string> names;
    for (const fs::path& file : tree.manifests) {
        if (const Result<IcdManifest> manifest = ReadIcdManifest(file);
            manifest && !manifest->foreign) {
            names.insert(fs::path(manifest->library).filename().string());
        }
    }
    std::vector<fs::path> drivers;
    std::set<fs::path> seen;
    for (const fs::path& library : tree.libraries) {
        const std::string name = library.filename().string();
        const bool is_driver = name.starts_with("libvulkan_") && library.extension() == ".so";
        std::error_code ignored;
        if ((is_driver || names.contains(name)) &&
            seen.insert(fs::canonical(library, ignored)).second) {
            drivers.push_back(library);
        }
    }
    return drivers;
}

std::vector<Candidate> PrefixCandidates(const Driver& driver) {
    std::error_code ignored;
    const Tree tree = Walk(fs::absolute(driver.prefix, ignored));
    std::set<fs::path> folders;
    for (const fs::path& library : tree.libraries) {
        folders.insert(library.parent_path());
    }
    std::vector<Candidate> candidates;
    for (const fs::path& library : DriverLibraries(tree)) {
        std::string search = library.parent_path().string();
        for (const fs::path& folder : folders) {
            if (folder != library.parent_path()) {
                search.append(":").append(folder.string());
            }
        }
        if (const std::string before = Environment("LD_LIBRARY_PATH"); !before.empty()) {
            search.append(":").append(before);
        }
        Candidate candidate;
        candidate.backend = "vulkan";
        candidate.hint = library.string();
        candidate.driver = driver.name;
        candidate.environment = {{"LD_LIBRARY_PATH", search}};
        candidates.push_back(std::move(candidate));
    }
    return candidates;
}

}  // namespace

std::vector<Candidate> VulkanCandidates(const Driver& driver) {
    return driver.name.empty() ? InstalledCandidates() : PrefixCandidates(driver);
}

}  // namespace etalon
