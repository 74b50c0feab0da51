#include "device/vulkan/icd.h"

#include <stdlib.h>
#include <sys/utsname.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/file.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

// The text value of a key. Manifests are small, flat and written by programs: a search for the key
// is enough, and a value that is no text counts as absent.
std::optional<std::string> JsonText(std::string_view json, std::string_view key) {
    constexpr std::string_view kSpace = " \t\r\n";
    const std::string quoted = '"' + std::string(key) + '"';
    std::size_t at = json.find(quoted);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    for (const char expected : {':', '"'}) {
        at = json.find_first_not_of(kSpace, expected == ':' ? at + quoted.size() : at + 1);
        if (at == std::string_view::npos || json[at] != expected) {
            return std::nullopt;
        }
    }
    std::string value;
    for (++at; at < json.size() && json[at] != '"'; ++at) {
        if (json[at] == '\\' && at + 1 < json.size()) {
            ++at;
        }
        value += json[at];
    }
    return at < json.size() ? std::optional(value) : std::nullopt;
}

std::string JsonQuoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') {
            quoted += '\\';
        }
        quoted += c;
    }
    return quoted + '"';
}

// Distributions mark the architecture by the file's name: radeon_icd.i686.json.
bool NamesOtherArchitecture(const fs::path& file) {
    constexpr std::array<std::string_view, 11> kArchitectures = {
        "x86_64",  "x86",     "i386",    "i686",    "aarch64", "armv7l",
        "riscv64", "ppc64le", "ppc64el", "powerpc", "s390x"};
    utsname machine{};
    uname(&machine);
    const std::string suffix = file.stem().extension().string();
    for (const std::string_view architecture : kArchitectures) {
        if (suffix == "." + std::string(architecture)) {
            return architecture != machine.machine;
        }
    }
    return false;
}

}  // namespace

Result<IcdManifest> ReadIcdManifest(const fs::path& file) {
    ETALON_TRY(json, ReadTextFile(file));
    const std::optional<std::string> library = JsonText(json, "library_path");
    if (!library || library->empty()) {
        return Error{file.string() + ": names no library_path"};
    }
    IcdManifest manifest;
    manifest.library = *library;
    // As the loader reads it: a path with a folder is relative to the manifest, a name is searched.
    if (library->find('/') != std::string::npos) {
        manifest.library = (fs::absolute(file).parent_path() / *library).lexically_normal();
    }
    const std::string bits = std::to_string(8 * sizeof(void*));
    manifest.foreign =
        JsonText(json, "library_arch").value_or(bits) != bits || NamesOtherArchitecture(file);
    return manifest;
}

Result<TemporaryManifest> TemporaryManifest::Write(const fs::path& library) {
    std::error_code failed;
    std::string folder = (fs::temp_directory_path(failed) / "etalon-icd-XXXXXX").string();
    if (failed || mkdtemp(folder.data()) == nullptr) {
        return Error{folder + ": " + std::strerror(errno)};
    }
    TemporaryManifest manifest{fs::path(folder)};
    // The loader asks the driver itself for its version; the manifest's is only held against 1.0.
    ETALON_TRY_STEP(WriteFile(
        manifest.file(), "{\"file_format_version\": \"1.0.0\", \"ICD\": {\"library_path\": " +
                             JsonQuoted(library.string()) + ", \"api_version\": \"1.3.0\"}}\n"));
    return manifest;
}

TemporaryManifest::TemporaryManifest(TemporaryManifest&& other) noexcept
    : folder_(std::exchange(other.folder_, {})) {}

TemporaryManifest::~TemporaryManifest() {
    if (!folder_.empty()) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
}

}  // namespace etalon
