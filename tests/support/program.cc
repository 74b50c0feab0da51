#include "support/program.h"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string_view>
#include <thread>

#include "base/check.h"

namespace etalon {
namespace {

std::vector<char*> Pointers(std::vector<std::string>& words) {
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    return pointers;
}

// This process's variables, but for those that are given anew.
std::vector<std::string> Environment(const std::vector<std::string>& given) {
    std::vector<std::string> all = given;
    for (char** variable = environ; *variable != nullptr; ++variable) {
        const std::string_view text = *variable;
        const std::string_view name = text.substr(0, text.find('=') + 1);
        if (std::none_of(given.begin(), given.end(),
                         [&](const std::string& one) { return one.starts_with(name); })) {
            all.emplace_back(text);
        }
    }
    return all;
}

std::string Content(int file) {
    // Not lseek: the program that writes shares the position.
    struct stat status = {};
    ETALON_CHECK(fstat(file, &status) == 0);
    std::string content(static_cast<std::size_t>(status.st_size), '\0');
    const ssize_t got = pread(file, content.data(), content.size(), 0);
    ETALON_CHECK(got == static_cast<ssize_t>(content.size()));
    return content;
}

}  // namespace

RunningProgram::RunningProgram(const std::vector<std::string>& words, const ProgramOptions& options)
    : options_(options) {
    // Files rather than pipes: nobody has to read while the program runs.
    out_ = options.out_file.empty() ? memfd_create("out", MFD_CLOEXEC)
                                    : open(options.out_file.c_str(), O_RDWR | O_CLOEXEC);
    err_ = memfd_create("err", MFD_CLOEXEC);
    ETALON_CHECK(out_ >= 0 && err_ >= 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, out_, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, err_, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&actions, options.folder.c_str());
    std::vector<std::string> environment = Environment(options.environment);
    std::vector<std::string> copy = words;
    const int code = posix_spawnp(&id_, copy[0].c_str(), &actions, nullptr, Pointers(copy).data(),
                                  Pointers(environment).data());
    posix_spawn_file_actions_destroy(&actions);
    ETALON_CHECK(code == 0);
}

RunningProgram::~RunningProgram() {
    if (!reaped_) {
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    close(out_);
    close(err_);
}

std::string RunningProgram::ErrSoFar() const {
    return Content(err_);
}

Finished RunningProgram::Wait() {
    const auto deadline = std::chrono::steady_clock::now() + options_.timeout;
    int status = 0;
    while (waitpid(id_, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() > deadline) {
            kill(id_, SIGKILL);
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    reaped_ = true;
    Finished finished;
    finished.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    finished.signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    finished.out = options_.out_file.empty() ? Content(out_) : "";
    finished.err = Content(err_);
    return finished;
}

Finished RunProgram(const std::vector<std::string>& words, const ProgramOptions& options) {
    return RunningProgram(words, options).Wait();
}

std::vector<std::string> Lines(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        lines.push_back(text.substr(from, end - from));
        from = end + 1;
    }
    return lines;
}

}  // namespace etalon
