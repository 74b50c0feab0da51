#include "base/file_lock.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <memory>
#include <optional>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;

// A process that has the lock and does nothing more until it is killed.
class Holder {
  public:
    template <typename Take>
    explicit Holder(const Take& take) {
        int ready[2] = {};
        EXPECT_EQ(pipe(ready), 0);
        id_ = fork();
        if (id_ == 0) {
            const auto lock = take();
            const char got = lock ? 'y' : 'n';
            [[maybe_unused]] const auto told = write(ready[1], &got, 1);
            pause();
            _exit(0);
        }
        char got = 0;
        EXPECT_EQ(read(ready[0], &got, 1), 1);
        EXPECT_EQ(got, 'y');
        close(ready[0]);
        close(ready[1]);
    }
    Holder(const Holder&) = delete;
    Holder& operator=(const Holder&) = delete;
    ~Holder() { Kill(); }
    void Kill() {
        if (id_ > 0) {
            kill(id_, SIGKILL);
            waitpid(id_, nullptr, 0);
            id_ = 0;
        }
    }

  private:
    pid_t id_ = 0;
};

TEST(FileLock, IsRefusedWhileAnotherHasIt) {
    const Folder folder;
    const auto file = folder.path() / "f";
    {
        const auto first = FileLock::Beside(file);
        ASSERT_TRUE(first);
        const auto second = FileLock::Beside(file);
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().message, file.string() + ": another process is at work on it");
        EXPECT_TRUE(FileLock::Beside(folder.path() / "g"));
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "f.lock"));
    }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_TRUE(FileLock::Beside(file));
}

TEST(FileLock, EndsWithItsProcess) {
    const Folder folder;
    const auto file = folder.path() / "f";
    Holder holder([&] { return FileLock::Beside(file); });
    EXPECT_FALSE(FileLock::Beside(file));
    holder.Kill();
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "f.lock"));
    EXPECT_TRUE(FileLock::Beside(file));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "f.lock"));
}

TEST(FileLock, NamesWhatItCannotLock) {
    const Folder folder;
    EXPECT_THAT(FileLock::Beside(folder.path() / "no" / "f").error().message,
                HasSubstr("no/f: cannot be written ("));
    EXPECT_THAT(FileLock::OnFolder(folder.path() / "no").error().message,
                HasSubstr("no: No such file or directory"));
}

TEST(FileLock, LeavesNothingInAFolder) {
    const Folder folder;
    { EXPECT_TRUE(FileLock::OnFolder(folder.path())); }
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace etalon
