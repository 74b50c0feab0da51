// What the system knows of processes, for tests that count them.
#pragma once

#include <dirent.h>
#include <sys/types.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace etalon {

struct ProcessState {
    char state = 'X';  // gone
    pid_t parent = 0;
};

inline ProcessState StateOf(pid_t id) {
    std::ifstream file("/proc/" + std::to_string(id) + "/stat");
    std::string text;
    ProcessState state;
    if (std::getline(file, text)) {
        std::istringstream fields(text.substr(text.rfind(')') + 1));
        fields >> state.state >> state.parent;
    }
    return state;
}

// The numbers that name entries of a folder under /proc.
inline std::vector<int> Numbers(const char* folder) {
    std::vector<int> numbers;
    DIR* open_folder = opendir(folder);
    while (const dirent* entry = readdir(open_folder)) {
        if (std::isdigit(static_cast<unsigned char>(entry->d_name[0])) != 0) {
            numbers.push_back(std::atoi(entry->d_name));
        }
    }
    closedir(open_folder);
    return numbers;
}

// Zombies too.
inline std::vector<pid_t> ChildrenOf(pid_t parent) {
    std::vector<pid_t> children = Numbers("/proc");
    std::erase_if(children, [&](pid_t id) { return StateOf(id).parent != parent; });
    return children;
}

inline std::vector<pid_t> Children() {
    return ChildrenOf(getpid());
}

}  // namespace etalon
