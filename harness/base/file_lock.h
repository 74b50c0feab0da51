// Locks between processes. A lock is held while it lives, and ends with its process, however that
// ends.
#pragma once

#include <filesystem>

#include "base/result.h"

namespace etalon {

class FileLock {
  public:
    // Locks the folder itself, and waits while another process has it. Fails, naming the folder,
    // where there is none or it cannot be locked.
    static Result<FileLock> OnFolder(const std::filesystem::path& folder);

    // Locks a file by one beside it, FILE.lock, which is taken away with the lock; that of a
    // process that was killed stays and is no obstacle. Fails, naming the file, where another
    // process has the lock, and where nothing can be written there.
    static Result<FileLock> Beside(const std::filesystem::path& file);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&&) = delete;
    ~FileLock();

  private:
    FileLock(int file, std::filesystem::path beside);

    int file_;
    std::filesystem::path beside_;  // to be taken away; empty for a folder
};

}  // namespace etalon
