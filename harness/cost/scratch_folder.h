// A folder for the sources that are made, gone with its owner.
#pragma once

#include <filesystem>
#include <utility>

#include "base/result.h"

namespace etalon {

class ScratchFolder {
  public:
    // Of a name that no other had in this process, under the system's folder for such.
    static Result<ScratchFolder> Make();

    ScratchFolder(ScratchFolder&& other) noexcept
        : path_(std::exchange(other.path_, std::filesystem::path())) {}
    ScratchFolder& operator=(ScratchFolder&&) = delete;
    ~ScratchFolder();

    const std::filesystem::path& path() const { return path_; }

  private:
    explicit ScratchFolder(std::filesystem::path path) : path_(std::move(path)) {}

    std::filesystem::path path_;  // empty where it was moved away
};

}  // namespace etalon
