#include "base/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstring>

namespace etalon {
namespace {

constexpr std::uint64_t kMostBytes = 4ull << 30;

Error Failure(const std::filesystem::path& path, int code) {
    return Error{path.string() + ": " + std::strerror(code)};
}

Status<> WriteWhole(const std::filesystem::path& path, std::string_view content, int flags) {
    const int file = open(path.c_str(), flags | O_WRONLY | O_CLOEXEC, 0644);
    if (file < 0) {
        return Failure(path, errno);
    }
    int code = 0;
    while (!content.empty() && code == 0) {
        const ssize_t written = write(file, content.data(), content.size());
        if (written >= 0) {
            content.remove_prefix(static_cast<std::size_t>(written));
        } else if (errno != EINTR) {
            code = errno;
        }
    }
    if (close(file) != 0 && code == 0) {
        code = errno;
    }
    if (code != 0) {
        return Failure(path, code);
    }
    return Ok();
}

Result<std::string> ReadUntil(const std::filesystem::path& path, bool is_text) {
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        return Error{path.string() + ": is a folder, not a file"};
    }
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return Failure(path, errno);
    }
    std::string content;
    char block[1 << 16];
    for (;;) {
        const ssize_t got = read(file, block, sizeof block);
        if (got == 0) {
            break;
        }
        if (got < 0 && errno != EINTR) {
            const int code = errno;
            close(file);
            return Failure(path, code);
        }
        if (got <= 0) {
            continue;
        }
        content.append(block, static_cast<std::size_t>(got));
        // Found here and not at the end: an endless device has no end.
        if (is_text && std::memchr(block, 0, static_cast<std::size_t>(got)) != nullptr) {
            close(file);
            return Error{path.string() + ": is not text (it holds a NUL byte)"};
        }
        if (content.size() > kMostBytes) {
            close(file);
            return Error{path.string() + ": is larger than 4 GiB"};
        }
    }
    close(file);
    return content;
}

}  // namespace

Result<std::string> ReadFile(const std::filesystem::path& path) {
    return ReadUntil(path, false);
}

Result<std::string> ReadTextFile(const std::filesystem::path& path) {
    return ReadUntil(path, true);
}

Status<> WriteFile(const std::filesystem::path& path, std::string_view content) {
    std::error_code ignored;
    const auto status = std::filesystem::status(path, ignored);
    if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
        if (std::filesystem::is_directory(status)) {
            return Error{path.string() + ": is a folder, not a file"};
        }
        return WriteWhole(path, content, 0);
    }
    const std::filesystem::path beside = path.string() + ".part" + std::to_string(getpid());
    if (auto written = WriteWhole(beside, content, O_CREAT | O_TRUNC); !written) {
        unlink(beside.c_str());
        return Error{path.string() + ": cannot be written (" + written.error().message + ")"};
    }
    if (rename(beside.c_str(), path.c_str()) != 0) {
        const int code = errno;
        unlink(beside.c_str());
        return Failure(path, code);
    }
    return Ok();
}

bool GlobMatches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0;
    std::size_t t = 0;
    std::size_t star = std::string_view::npos;
    std::size_t resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() &&
            (pattern[p] == '?' || (pattern[p] == text[t] && pattern[p] != '*'))) {
            ++p;
            ++t;
        } else if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') {
        ++p;
    }
    return p == pattern.size();
}

std::string ShellWord(const std::string& text) {
    const bool is_plain =
        !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
            return std::isalnum(c) != 0 || std::strchr("/._-:=+,@%", c) != nullptr;
        });
    if (is_plain) {
        return text;
    }
    std::string quoted = "'";
    for (const char c : text) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return quoted + "'";
}

std::filesystem::path ProgramPath() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

}  // namespace etalon
