#include "cmd/options.h"

#include <iostream>

#include "base/format.h"
#include "run/case_choice.h"

namespace etalon {

int Complain(const std::string& message) {
    std::cerr << "etalon: " << message << "\n";
    return kBadInput;
}

CLI::Validator Within(double least, double most) {
    return CLI::Validator(
        [least, most](const std::string& text) -> std::string {
            double value = 0;
            const bool is_number = CLI::detail::lexical_cast(text, value);
            return is_number && value >= least && value <= most
                       ? ""
                       : format("'{}' is not a number from {} to {}", text, least, most);
        },
        "");
}

void DeviceOptions::AddTo(CLI::App& app, const std::string& otherwise) {
    app.add_option("-d,--device", patterns,
                   "device by name or pattern (vulkan:*); repeatable; default: " + otherwise)
        ->type_name("NAME")
        ->allow_extra_args(false);
    app.add_option("--driver", drivers,
                   "add the implementations under DIR, as devices @NAME; repeatable")
        ->type_name("NAME=DIR")
        ->allow_extra_args(false);
    app.add_option("--timeout", timeout, "seconds that a device may take for one step")
        ->capture_default_str()
        ->check(Within(0.001, 1e6))
        ->type_name("SECONDS");
    app.add_option("--memory", memory, "MiB that a device's process may occupy")
        ->capture_default_str()
        ->check(Within(1, 1e9))
        ->type_name("MIB");
}

Result<DeviceChoice> DeviceOptions::Choice() const {
    DeviceChoice choice;
    choice.patterns = patterns;
    choice.limits.timeout = std::chrono::milliseconds(static_cast<std::int64_t>(timeout * 1000));
    choice.limits.memory_bytes = memory << 20;
    for (const std::string& driver : drivers) {
        const std::size_t equals = driver.find('=');
        if (equals == std::string::npos || equals == 0 || driver.find_first_of("@*?:, ") < equals) {
            return Error{"--driver '" + driver + "': it reads NAME=DIR"};
        }
        choice.drivers.push_back({driver.substr(0, equals), driver.substr(equals + 1)});
    }
    return choice;
}

void AddRoot(CLI::App& app, std::string& root) {
    app.add_option("--root", root, "folder that holds cases/; default: here or above")
        ->type_name("DIR");
}

Result<std::filesystem::path> RootOf(const std::string& given) {
    if (given.empty()) {
        return FindRoot(".");
    }
    if (!std::filesystem::is_directory(std::filesystem::path(given) / "cases")) {
        return Error{"--root '" + given + "': holds no folder 'cases'"};
    }
    return std::filesystem::path(given);
}

}  // namespace etalon
