#include "cost/scratch_folder.h"

#include <stdlib.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <string>

namespace etalon {

Result<ScratchFolder> ScratchFolder::Make() {
    static std::atomic<unsigned> made = 0;
    std::error_code ignored;
    std::filesystem::path base = std::filesystem::temp_directory_path(ignored);
    if (base.empty()) {
        base = "/tmp";
    }
    std::string name = (base / ("etalon-cost-" + std::to_string(made++) + "-XXXXXX")).string();
    if (mkdtemp(name.data()) == nullptr) {
        return Error{name + ": cannot be made (" + std::strerror(errno) + ")"};
    }
    return ScratchFolder(name);
}

ScratchFolder::~ScratchFolder() {
    if (!path_.empty()) {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
}

}  // namespace etalon
