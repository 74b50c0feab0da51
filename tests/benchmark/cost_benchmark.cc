// What the hardened functions cost beside the published ones, on lavapipe: each case of
// cases/published that is like a case of a hardened function, or has the same call, both at the
// same inputs.
//
//   build/etalon_costs [PATTERN]...
//
// Times are those of EstimateTimes: processor time of one evaluation. Operations are those of
// CountOperations, on average over the rows. The program serves as its own worker.

#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <map>
#include <optional>

#include "case/case.h"
#include "cost/cost.h"
#include "run/case_choice.h"
#include "run/devices.h"
#include "run/fit.h"
#include "worker/serve.h"

namespace etalon {
namespace {

constexpr const char* kDevice = "vulkan:llvmpipe";
constexpr std::string_view kPublished = "published/";
constexpr double kSeconds = 0.7;  // for each function
constexpr double kAllowed = 1.25;
// Below this much a difference of times is noise.
constexpr double kNoise = 0.1e-9;

struct Pair {
    Case published;
    Case hardened;
    std::vector<std::string> covers;
    bool is_right = false;  // nothing is expected to fail
};

struct Cost {
    double seconds = 0;  // of one evaluation
    OperationCounts operations;
};

// Published first, hardened second.
Result<std::array<Cost, 2>> Compare(const Pair& pair, Runner& runner) {
    Case hardened = pair.hardened;
    hardened.domains = pair.published.domains;
    std::vector<PreparedCase> prepared;
    for (const Case& one : {pair.published, hardened}) {
        ETALON_TRY(ready, PrepareCall(one));
        prepared.push_back(std::move(ready));
    }
    CostOptions options;
    options.seconds = kSeconds;
    options.most_seconds = 2 * kSeconds;
    ETALON_TRY(times, EstimateTimes(prepared, runner, DefaultRecipe(runner.info()), options));
    std::array<Cost, 2> costs;
    for (std::size_t i = 0; i < costs.size(); ++i) {
        ETALON_TRY(counted, CountOperations(prepared[i]));
        ETALON_TRY(time, times[i]);
        costs[i] = {time.seconds, counted.mean};
    }
    return costs;
}

std::string Joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : " ") + word;
    }
    return text;
}

// The hardened case to compare a published one with: the one that it is like, or else one of the
// same call.
Result<std::optional<Case>> HardenedOf(const Case& published, const std::vector<Case>& hardened,
                                       const std::filesystem::path& root) {
    std::string like = published.like;
    while (!like.empty()) {
        ETALON_TRY(next, ReadCase(root, like));
        if (!like.starts_with(kPublished)) {
            return std::optional(std::move(next));
        }
        like = next.like;
    }
    const auto same = std::find_if(hardened.begin(), hardened.end(),
                                   [&](const Case& one) { return one.call == published.call; });
    return same == hardened.end() ? std::nullopt : std::optional(*same);
}

// The pairs, each call with each call once; what further cases of the same calls show is added.
Result<std::vector<Pair>> FindPairs(const std::filesystem::path& root,
                                    const std::vector<std::string>& patterns) {
    ETALON_TRY(all, ListCases(root));
    std::vector<Case> hardened;
    for (const std::string& path : all) {
        if (!path.starts_with(kPublished)) {
            ETALON_TRY(one, ReadCase(root, path));
            hardened.push_back(std::move(one));
        }
    }
    ETALON_TRY(paths, ChooseCases(root, patterns));
    std::vector<Pair> pairs;
    std::map<std::string, std::size_t> known;
    for (const std::string& path : paths) {
        if (!path.starts_with(kPublished)) {
            continue;
        }
        ETALON_TRY(published, ReadCase(root, path));
        ETALON_TRY(other, HardenedOf(published, hardened, root));
        if (!other) {
            continue;
        }
        Pair pair;
        pair.is_right = published.expected_failures.empty();
        const std::string key = published.source + "\n" + published.call + "\n" +
                                Joined(published.with) + "\n" + other->source + "\n" + other->call +
                                "\n" + (pair.is_right ? "right" : "");
        pair.covers = published.covers;
        pair.published = std::move(published);
        pair.hardened = std::move(*other);
        const auto [at, is_new] = known.emplace(key, pairs.size());
        if (is_new) {
            pairs.push_back(std::move(pair));
            continue;
        }
        std::vector<std::string>& ids = pairs[at->second].covers;
        for (const std::string& id : pair.covers) {
            if (std::find(ids.begin(), ids.end(), id) == ids.end()) {
                ids.push_back(id);
            }
        }
    }
    return pairs;
}

// The function that a call begins with.
std::string FunctionOf(const std::string& call) {
    return call.substr(0, call.find('('));
}

std::string Ratio(double a, double b) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2f", a / b);
    return text.data();
}

struct Row {
    const Pair* pair;
    std::array<Cost, 2> costs;

    // Absent where the times are too short to tell.
    std::optional<double> TimeRatio() const {
        if (costs[0].seconds < kNoise && costs[1].seconds < kNoise) {
            return std::nullopt;
        }
        return costs[1].seconds / std::max(costs[0].seconds, kNoise);
    }
    double OperationRatio() const {
        return costs[1].operations.Total() / std::max(costs[0].operations.Total(), 1.0);
    }
};

void Print(const Row& row) {
    const Pair& pair = *row.pair;
    const std::optional<double> ratio = row.TimeRatio();
    std::printf("%-16s %-26s %-5s %9.3f %9.3f %6s %6.0f:%-6.0f %5.2f %5.1f:%-5.1f  %s\n",
                Joined(pair.covers).c_str(), FunctionOf(pair.hardened.call).c_str(),
                pair.is_right ? "yes" : "no", row.costs[0].seconds * 1e9,
                row.costs[1].seconds * 1e9, ratio ? Ratio(*ratio, 1).c_str() : "-",
                row.costs[0].operations.Total(), row.costs[1].operations.Total(),
                row.OperationRatio(), row.costs[0].operations.fetch, row.costs[1].operations.fetch,
                pair.published.path.c_str());
    std::fflush(stdout);
}

Result<int> PrintCosts(const std::vector<std::string>& patterns) {
    ETALON_TRY(pairs, FindPairs(ETALON_ROOT, patterns));
    DeviceChoice choice;
    choice.patterns = {kDevice};
    ETALON_TRY(devices, OpenDevices(choice));
    Runner& runner = *devices.runners.front();
    std::printf("%-16s %-26s %-5s %9s %9s %6s %13s %5s %11s  %s\n", "shows", "function", "right",
                "published", "hardened", "ratio", "operations", "ratio", "fetches", "case (ns)");
    std::vector<Row> rows;
    std::vector<std::string> left_out;
    for (const Pair& pair : pairs) {
        const auto costs = Compare(pair, runner);
        if (!costs) {
            left_out.push_back(pair.published.path + ": " + costs.error().message);
            continue;
        }
        rows.push_back({&pair, *costs});
        Print(rows.back());
    }

    std::printf("\nabove %.2f times the published form where that is right:\n", kAllowed);
    for (const Row& row : rows) {
        if (row.pair->is_right && row.TimeRatio().value_or(0) > kAllowed) {
            Print(row);
        }
    }
    for (const std::string& note : left_out) {
        std::printf("left out: %s\n", note.c_str());
    }
    return 0;
}

}  // namespace
}  // namespace etalon

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "worker") {
        return etalon::ServeWorker(argc, argv);
    }
    const auto printed = etalon::PrintCosts(std::vector<std::string>(argv + 1, argv + argc));
    if (!printed) {
        std::cerr << "etalon_costs: " << printed.error().message << "\n";
        return 2;
    }
    return *printed;
}
