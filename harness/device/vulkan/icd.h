// Installable client drivers (ICDs) as files: a JSON manifest that names a library.
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "base/result.h"

namespace etalon {

// What a manifest says.
struct IcdManifest {
    std::string library;   // as dlopen takes it: absolute, or a bare name to be searched for
    bool foreign = false;  // made for another architecture than this program's
};

// Reads a manifest. Fails, naming the file, where it is unreadable or names no library.
Result<IcdManifest> ReadIcdManifest(const std::filesystem::path& file);

// A manifest for a library, in a new folder of its own under the system's folder for temporary
// files. It lives as long as the object, which should be no longer than the loader needs to read
// it.
class TemporaryManifest {
  public:
    static Result<TemporaryManifest> Write(const std::filesystem::path& library);
    ~TemporaryManifest();
    TemporaryManifest(TemporaryManifest&& other) noexcept;
    TemporaryManifest(const TemporaryManifest&) = delete;
    TemporaryManifest& operator=(const TemporaryManifest&) = delete;
    TemporaryManifest& operator=(TemporaryManifest&&) = delete;

    std::filesystem::path file() const { return folder_ / "icd.json"; }

  private:
    explicit TemporaryManifest(std::filesystem::path folder) : folder_(std::move(folder)) {}

    std::filesystem::path folder_;  // empty after a move
};

}  // namespace etalon
