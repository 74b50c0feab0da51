#include "base/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace etalon {
namespace {

// As flock, and goes on after a signal; 0, or why not.
int Lock(int file, int operation) {
    while (flock(file, operation) != 0) {
        if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

bool IsAt(int file, const std::filesystem::path& path) {
    struct stat open_one = {};
    struct stat named_one = {};
    return fstat(file, &open_one) == 0 && stat(path.c_str(), &named_one) == 0 &&
           open_one.st_dev == named_one.st_dev && open_one.st_ino == named_one.st_ino;
}

}  // namespace

Result<FileLock> FileLock::OnFolder(const std::filesystem::path& folder) {
    FileLock lock(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC), {});
    if (lock.file_ < 0) {
        return Error{folder.string() + ": " + std::strerror(errno)};
    }
    if (const int code = Lock(lock.file_, LOCK_EX); code != 0) {
        return Error{folder.string() + ": cannot be locked (" + std::strerror(code) + ")"};
    }
    return lock;
}

Result<FileLock> FileLock::Beside(const std::filesystem::path& file) {
    const std::filesystem::path beside = file.string() + ".lock";
    for (;;) {
        // Not yet to be taken away: until it is locked it may be another's.
        FileLock lock(open(beside.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644), {});
        if (lock.file_ < 0) {
            return Error{file.string() + ": cannot be written (" + beside.string() + ": " +
                         std::strerror(errno) + ")"};
        }
        const int code = Lock(lock.file_, LOCK_EX | LOCK_NB);
        if (code == EWOULDBLOCK) {
            return Error{file.string() + ": another process is at work on it"};
        }
        if (code != 0) {
            return Error{file.string() + ": cannot be locked (" + std::strerror(code) + ")"};
        }
        // Who had it before may have taken it away between opening and locking.
        if (IsAt(lock.file_, beside)) {
            lock.beside_ = beside;
            return lock;
        }
    }
}

FileLock::FileLock(int file, std::filesystem::path beside)
    : file_(file), beside_(std::move(beside)) {}

FileLock::FileLock(FileLock&& other) noexcept
    : file_(std::exchange(other.file_, -1)), beside_(std::move(other.beside_)) {
    other.beside_.clear();
}

FileLock::~FileLock() {
    if (file_ < 0) {
        return;
    }
    if (!beside_.empty()) {
        unlink(beside_.c_str());  // before it is let go, lest it is another's by then
    }
    close(file_);
}

}  // namespace etalon
