#include "worker/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <vector>

#include "worker/message.h"

namespace etalon {
namespace {

constexpr std::size_t kTailBytes = 4096;
constexpr std::size_t kLongestLine = 300;
constexpr std::size_t kPipeBytes = 1u << 16;

// How long a killed process may take. One that a graphics driver holds in the kernel may take for
// ever: it is then left to the system.
constexpr std::chrono::milliseconds kKillPatience{2'000};

std::vector<std::string> Environment(const std::map<std::string, std::string>& added) {
    std::vector<std::string> all;
    for (char** entry = environ; *entry != nullptr; ++entry) {
        const std::string text = *entry;
        if (!added.contains(text.substr(0, text.find('=')))) {
            all.push_back(text);
        }
    }
    for (const auto& [name, value] : added) {
        all.emplace_back(name).append("=").append(value);
    }
    return all;
}

// A copy that no target of a worker's descriptors can overwrite before it is itself handed over.
Descriptor Aside(int descriptor) {
    return Descriptor(fcntl(descriptor, F_DUPFD_CLOEXEC, kWorkerMemory + 1));
}

// posix_spawn's two argument objects.
struct SpawnSetup {
    SpawnSetup() {
        posix_spawn_file_actions_init(&actions);
        posix_spawnattr_init(&attributes);
    }
    ~SpawnSetup() {
        posix_spawn_file_actions_destroy(&actions);
        posix_spawnattr_destroy(&attributes);
    }
    SpawnSetup(const SpawnSetup&) = delete;
    SpawnSetup& operator=(const SpawnSetup&) = delete;

    posix_spawn_file_actions_t actions;
    posix_spawnattr_t attributes;
};

}  // namespace

Result<std::unique_ptr<Process>> Process::Start(
    const std::string& program, const std::map<std::string, std::string>& environment, int socket,
    int memory) {
    const auto failure = [&](int code) {
        return Error{program + ": cannot be started as a worker (" + std::strerror(code) + ")"};
    };
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        return failure(errno);
    }
    Descriptor log(ends[0]);
    const Descriptor log_end(ends[1]);
    fcntl(log.number(), F_SETFL, O_NONBLOCK);
    const Descriptor worker_log = Aside(log_end.number());
    const Descriptor worker_socket = Aside(socket);
    const Descriptor worker_memory = Aside(memory);
    if (!worker_log || !worker_socket || !worker_memory) {
        return failure(errno);
    }

    SpawnSetup setup;
    posix_spawn_file_actions_addopen(&setup.actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&setup.actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&setup.actions, worker_log.number(), STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&setup.actions, worker_socket.number(), kWorkerSocket);
    posix_spawn_file_actions_adddup2(&setup.actions, worker_memory.number(), kWorkerMemory);
    posix_spawn_file_actions_addclosefrom_np(&setup.actions, kWorkerMemory + 1);
    // What this process ignores or blocks is its own affair.
    sigset_t signals;
    sigfillset(&signals);
    posix_spawnattr_setsigdefault(&setup.attributes, &signals);
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&setup.attributes, &signals);
    posix_spawnattr_setflags(
        &setup.attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);

    std::vector<std::string> texts = Environment(environment);
    std::vector<char*> variables;
    variables.reserve(texts.size() + 1);
    for (std::string& text : texts) {
        variables.push_back(text.data());
    }
    variables.push_back(nullptr);
    std::string name = program;
    std::string word = "worker";
    char* const arguments[] = {name.data(), word.data(), nullptr};
    pid_t id = 0;
    if (const int code = posix_spawn(&id, program.c_str(), &setup.actions, &setup.attributes,
                                     arguments, variables.data());
        code != 0) {
        return failure(code);
    }
    return std::unique_ptr<Process>(new Process(id, std::move(log)));
}

Process::Process(pid_t id, Descriptor log)
    : id_(id),
      end_(static_cast<int>(syscall(SYS_pidfd_open, id, 0))),
      log_(std::move(log)),
      statistics_(open(("/proc/" + std::to_string(id) + "/statm").c_str(), O_RDONLY | O_CLOEXEC)) {}

Process::~Process() {
    End(std::chrono::milliseconds(0));
}

void Process::ReadLog() {
    char block[4096];
    // No more than a pipe holds: one that writes without end must not keep the parent here.
    for (std::size_t left = kPipeBytes; left > 0 && log_; left -= sizeof block) {
        const ssize_t got = read(log_.number(), block, sizeof block);
        if (got > 0) {
            tail_.append(block, static_cast<std::size_t>(got));
            if (tail_.size() > kTailBytes) {
                tail_.erase(0, tail_.size() - kTailBytes);
            }
        } else if (got == 0) {
            log_ = Descriptor();  // at its end it would always be readable
        } else if (errno != EINTR) {
            return;
        }
    }
}

bool Process::Ended() const {
    siginfo_t info = {};
    const int code = waitid(P_PID, static_cast<id_t>(id_), &info, WEXITED | WNOHANG | WNOWAIT);
    return code != 0 || info.si_pid == id_;
}

bool Process::WaitForEnd(std::chrono::milliseconds patience) const {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!Ended()) {
        if (std::chrono::steady_clock::now() >= deadline) {
            return false;
        }
        pollfd end = {end_.number(), POLLIN, 0};
        poll(&end, 1, end_ ? 10 : 1);
    }
    return true;
}

std::uint64_t Process::ResidentBytes() const {
    char text[128];
    const ssize_t got = pread(statistics_.number(), text, sizeof text, 0);
    if (got <= 0) {
        return 0;
    }
    // "size resident shared ...", in pages.
    const std::string_view fields(text, static_cast<std::size_t>(got));
    const std::size_t space = fields.find(' ');
    std::uint64_t pages = 0;
    if (space != std::string_view::npos) {
        std::from_chars(text + space + 1, text + got, pages);
    }
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

std::string Process::End(std::chrono::milliseconds patience) {
    if (reaped_) {
        return "ended";
    }
    reaped_ = true;
    const bool by_itself = WaitForEnd(patience);
    // Until it is reaped, nobody else can have its number or its group's.
    kill(-id_, SIGKILL);
    kill(id_, SIGKILL);
    int status = 0;
    const bool known = WaitForEnd(kKillPatience) && waitpid(id_, &status, WNOHANG) == id_;
    ReadLog();
    std::string how = "ended";
    if (!by_itself) {
        how = "went silent";
    } else if (known && WIFSIGNALED(status)) {
        const char* name = sigdescr_np(WTERMSIG(status));
        how = "ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
              (name == nullptr ? "unknown" : name) + ")";
    } else if (known) {
        how = "exited with status " + std::to_string(WEXITSTATUS(status));
    }
    const std::string line = LastLine();
    return line.empty() ? how : how + ": " + line;
}

std::string Process::LastLine() const {
    constexpr std::string_view kBlank = " \t\r\n";
    std::string_view line = tail_;
    line = line.substr(0, line.find_last_not_of(kBlank) + 1);
    line = line.substr(line.find_last_of("\r\n") + 1);
    line.remove_prefix(std::min(line.find_first_not_of(kBlank), line.size()));
    return Printable(line.substr(0, kLongestLine));
}

}  // namespace etalon
