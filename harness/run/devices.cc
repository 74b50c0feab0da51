#include "run/devices.h"

#include <algorithm>
#include <set>

#include "base/file.h"

namespace etalon {
namespace {

bool NamesNullDevice(const std::vector<std::string>& patterns) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [](const std::string& pattern) { return pattern.starts_with("null:"); });
}

// What the candidate would be called if its hint were its name; enough to leave out what cannot
// match.
std::string CandidateName(const Candidate& candidate) {
    return candidate.backend + ":" + candidate.hint +
           (candidate.driver.empty() ? "" : "@" + candidate.driver);
}

bool Matches(const std::string& pattern, const std::string& name, const std::string& driver) {
    return GlobMatches(pattern, name) || (!driver.empty() && pattern == driver);
}

bool MatchesAny(const std::vector<std::string>& patterns, const std::string& name,
                const std::string& driver) {
    return patterns.empty() ||
           std::any_of(patterns.begin(), patterns.end(),
                       [&](const std::string& pattern) { return Matches(pattern, name, driver); });
}

// False where no device of the candidate can match: another backend, or another driver's name.
bool MayMatch(const std::vector<std::string>& patterns, const Candidate& candidate) {
    if (candidate.backend == "null") {
        return MatchesAny(patterns, CandidateName(candidate), candidate.driver) &&
               !patterns.empty();
    }
    return patterns.empty() ||
           std::any_of(patterns.begin(), patterns.end(), [&](const std::string& pattern) {
               const std::string backend = pattern.substr(0, pattern.find(':'));
               return GlobMatches(backend, candidate.backend) ||
                      pattern.find(':') == std::string::npos;
           });
}

bool IsPlainName(const std::string& pattern) {
    return pattern.find_first_of("*?") == std::string::npos &&
           pattern.find(':') != std::string::npos;
}

}  // namespace

Result<DeviceSet> OpenDevices(const DeviceChoice& choice) {
    std::vector<Driver> drivers = {Driver{}};
    drivers.insert(drivers.end(), choice.drivers.begin(), choice.drivers.end());
    const std::string program = ProgramPath();

    std::vector<std::unique_ptr<Client>> clients;
    DeviceSet set;
    set.programs = std::make_shared<Programs>();
    for (const Driver& driver : drivers) {
        if (!driver.name.empty() && !std::filesystem::is_directory(driver.prefix)) {
            return Error{"--driver " + driver.name + ": '" + driver.prefix.string() +
                         "' is not a folder"};
        }
        std::size_t found = 0;
        for (Candidate& candidate : Candidates(driver)) {
            if (candidate.backend == "null" &&
                (!NamesNullDevice(choice.patterns) || !driver.name.empty())) {
                continue;
            }
            ++found;
            if (MayMatch(choice.patterns, candidate)) {
                clients.push_back(std::make_unique<Client>(program, candidate, choice.limits));
                if (auto started = clients.back()->Start(); !started) {
                    return started.error();
                }
            }
        }
        if (!driver.name.empty() && found == 0) {
            return Error{"--driver " + driver.name +
                         ": no Vulkan, OSMesa or EGL implementation under '" +
                         driver.prefix.string() + "'"};
        }
    }

    std::set<std::string> unmatched(choice.patterns.begin(), choice.patterns.end());
    // Candidates with several devices append a client per further device, so the count may grow.
    for (std::size_t i = 0; i < clients.size(); ++i) {
        const Candidate candidate = clients[i]->candidate();
        WorkerResult<DeviceInfo> info = clients[i]->Open();
        if (!info) {
            set.absent.push_back({CandidateName(candidate), info.error().reason});
            continue;
        }
        for (std::uint32_t next = 1; candidate.index == 0 && next < info->siblings; ++next) {
            Candidate sibling = candidate;
            sibling.index = next;
            clients.push_back(std::make_unique<Client>(program, sibling, choice.limits));
            if (auto started = clients.back()->Start(); !started) {
                return started.error();
            }
        }
        if (!MatchesAny(choice.patterns, info->name, candidate.driver)) {
            continue;
        }
        for (const std::string& pattern : choice.patterns) {
            if (Matches(pattern, info->name, candidate.driver)) {
                unmatched.erase(pattern);
            }
        }
        const bool twin =
            std::any_of(set.runners.begin(), set.runners.end(),
                        [&](const auto& runner) { return runner->info().name == info->name; });
        if (twin) {
            set.absent.push_back({CandidateName(candidate), "is " + info->name + " once more"});
            continue;
        }
        set.runners.push_back(std::make_unique<Runner>(std::move(clients[i]), *info, set.programs));
        // Where only plain names are asked for and all are found, the rest need not be waited for.
        if (!choice.patterns.empty() && unmatched.empty() &&
            std::all_of(choice.patterns.begin(), choice.patterns.end(), IsPlainName)) {
            break;
        }
    }
    for (const Driver& driver : choice.drivers) {
        const std::string mark = "@" + driver.name;
        const bool any = std::any_of(set.runners.begin(), set.runners.end(), [&](const auto& one) {
            return one->info().name.ends_with(mark);
        });
        const auto why = std::find_if(set.absent.begin(), set.absent.end(),
                                      [&](const auto& note) { return note.name.ends_with(mark); });
        if (!any && why != set.absent.end()) {
            return Error{"--driver " + driver.name + ": nothing under '" + driver.prefix.string() +
                         "' opens (" + why->name + ": " + why->reason + ")"};
        }
    }
    if (!unmatched.empty()) {
        const auto tried = std::find_if(
            set.absent.begin(), set.absent.end(),
            [&](const DeviceNote& note) { return GlobMatches(*unmatched.begin(), note.name); });
        if (tried != set.absent.end()) {
            return Error{tried->name + ": does not open (" + tried->reason + ")"};
        }
        const std::string hint =
            unmatched.begin()->find(':') == std::string::npos
                ? "; '" + *unmatched.begin() + ":*' would name all of that interface"
                : "";
        return Error{"no device is called '" + *unmatched.begin() +
                     "'; `etalon devices --all` tells what is here and what was tried" + hint};
    }
    if (set.runners.empty()) {
        return Error{"no device was found on this machine; `etalon devices` tells what was tried"};
    }
    return set;
}

}  // namespace etalon
