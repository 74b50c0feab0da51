#include "support/etalon.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "worker/process_table.h"

namespace etalon {

std::vector<std::string> EtalonWords(const std::vector<std::string>& arguments) {
    std::vector<std::string> words = {ETALON_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return words;
}

Finished RunEtalon(const std::vector<std::string>& arguments, const ProgramOptions& options) {
    return RunProgram(EtalonWords(arguments), options);
}

const std::string& SoftwareDevice() {
    static const std::string found = [] {
        for (const char* name : {"osmesa:llvmpipe", "egl:llvmpipe", "vulkan:llvmpipe",
                                 "vulkan:swiftshader", "osmesa:softpipe"}) {
            if (RunEtalon({"devices", "-d", name}).status == 0) {
                return std::string(name);
            }
        }
        return std::string();
    }();
    return found;
}

std::unique_ptr<RunningProgram> StartInShell(const std::string& command,
                                             const ProgramOptions& options) {
    ProgramOptions with_path = options;
    const char* path = std::getenv("PATH");
    with_path.environment.push_back(
        "PATH=" + std::filesystem::path(ETALON_PROGRAM).parent_path().string() + ":" +
        (path != nullptr ? path : "/usr/bin:/bin"));
    return std::make_unique<RunningProgram>(std::vector<std::string>{"/bin/sh", "-c", command},
                                            with_path);
}

Finished RunInShell(const std::string& command, const ProgramOptions& options) {
    return StartInShell(command, options)->Wait();
}

std::vector<pid_t> WorkersOf(pid_t parent) {
    std::vector<pid_t> workers = parent == 0 ? Numbers("/proc") : ChildrenOf(parent);
    std::erase_if(workers, [](pid_t id) {
        std::ifstream file("/proc/" + std::to_string(id) + "/cmdline");
        std::stringstream command;
        command << file.rdbuf();
        const std::string expected = ETALON_PROGRAM + std::string("\0worker", 7);
        return !command.str().starts_with(expected) || StateOf(id).state == 'Z';
    });
    return workers;
}

}  // namespace etalon
