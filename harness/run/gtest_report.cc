#include "run/gtest_report.h"

#include <sys/mman.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

#include "base/file.h"

namespace etalon {
namespace {

constexpr std::string_view kFlag = "--gtest_output=";

}  // namespace

GtestReport::GtestReport(std::vector<std::string>& arguments) {
    const char* variable = std::getenv("GTEST_OUTPUT");
    std::string wanted = variable == nullptr ? "" : variable;
    for (const std::string& argument : arguments) {
        if (argument.starts_with(kFlag)) {
            wanted = argument.substr(kFlag.size());
        }
    }
    const std::size_t colon = wanted.find(':');
    if (colon == std::string::npos || colon + 1 == wanted.size() || wanted.ends_with('/')) {
        return;
    }
    memory_ = memfd_create("etalon-report", MFD_CLOEXEC);
    if (memory_ < 0) {
        return;
    }
    path_ = wanted.substr(colon + 1);
    arguments.push_back(std::string(kFlag) + wanted.substr(0, colon + 1) + "/proc/self/fd/" +
                        std::to_string(memory_));
}

GtestReport::~GtestReport() {
    if (memory_ >= 0) {
        close(memory_);
    }
}

Status<> GtestReport::Write() const {
    if (path_.empty()) {
        return Ok();
    }
    ETALON_TRY(content, ReadFile("/proc/self/fd/" + std::to_string(memory_)));
    const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
    std::error_code ignored;
    if (!folder.empty()) {
        std::filesystem::create_directories(folder, ignored);
    }
    if (auto written = WriteFile(path_, content); !written) {
        return Error{"--gtest_output: " + written.error().message};
    }
    return Ok();
}

}  // namespace etalon
