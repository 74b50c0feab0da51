#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/file.h"
#include "report/html.h"
#include "report/json_value.h"
#include "report/page/files.h"

namespace etalon {
namespace {

using nlohmann::ordered_json;
using Temporary = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

std::string ContentOf(std::FILE* file) {
    std::string content;
    char block[1 << 16];
    std::rewind(file);
    for (std::size_t got = 0; (got = std::fread(block, 1, sizeof block, file)) > 0;) {
        content.append(block, got);
    }
    return content;
}

// Runs `node` on a script, which goes through files: neither end can block the other.
Result<std::string> RunNode(const std::string& script) {
    Temporary in(std::tmpfile(), std::fclose);
    Temporary out(std::tmpfile(), std::fclose);
    Temporary err(std::tmpfile(), std::fclose);
    if (!in || !out || !err ||
        std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() ||
        std::fflush(in.get()) != 0) {
        return Error{std::string("a temporary file: ") + std::strerror(errno)};
    }
    std::rewind(in.get());
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, fileno(in.get()), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(out.get()), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, fileno(err.get()), STDERR_FILENO);
    char name[] = "node";
    char from_input[] = "-";
    char* const words[] = {name, from_input, nullptr};
    pid_t child = 0;
    const int code = posix_spawnp(&child, name, &files, nullptr, words, environ);
    posix_spawn_file_actions_destroy(&files);
    if (code != 0) {
        return Error{std::string("the program 'node' is needed for pictures: ") +
                     std::strerror(code)};
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (status != 0) {
        const std::string said = ContentOf(err.get());
        // Node shows the source line first; the error's own line begins with its kind.
        const std::size_t at = said.find("Error: ");
        return Error{"the program 'node' failed: " +
                     (at == std::string::npos ? said.substr(0, said.find('\n'))
                                              : said.substr(at, said.find('\n', at) - at))};
    }
    return ContentOf(out.get());
}

}  // namespace

Status<> CheckPictures() {
    ETALON_TRY_STEP(RunNode(""));
    return Ok();
}

Status<> WritePictures(const std::filesystem::path& folder, ReportSection section,
                       const std::string& key, std::string_view json) {
    // JSON is an expression of JavaScript.
    const std::string call = std::string("Etalon.pictures(\"") + SectionName(section) + "\", " +
                             ordered_json(key).dump() + ", " + std::string(json) + ")";
    ETALON_TRY(pictures, RunNode(std::string(PageScript()) + "\n" + call +
                                 ".then(all => process.stdout.write(JSON.stringify(all)));\n"));
    const ordered_json all = ordered_json::parse(pictures, nullptr, false);
    ETALON_CHECK(all.is_object());
    for (const auto& [file, svg] : all.items()) {
        ETALON_TRY_STEP(WriteFile(folder / file, svg.get<std::string>()));
    }
    return Ok();
}

}  // namespace etalon
