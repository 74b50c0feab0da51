// What the words of the command line share: exit statuses, options, complaints.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "run/devices.h"

namespace etalon {

constexpr int kVerdict = 1;   // a number, a driver or a law is wrong
constexpr int kBadInput = 2;  // the user or the environment is

// Prints the one line of a mistake; returns kBadInput.
int Complain(const std::string& message);

// A number of these bounds; "nan" is in no bounds.
CLI::Validator Within(double least, double most);

// Options about devices.
struct DeviceOptions {
    std::vector<std::string> patterns;
    std::vector<std::string> drivers;
    double timeout = 10;
    std::uint64_t memory = 2048;

    // `otherwise` says which devices are taken where none is named.
    void AddTo(CLI::App& app, const std::string& otherwise = "all");
    Result<DeviceChoice> Choice() const;
};

void AddRoot(CLI::App& app, std::string& root);

// The folder that holds cases/: the one given, else that above the current folder.
Result<std::filesystem::path> RootOf(const std::string& given);

}  // namespace etalon
