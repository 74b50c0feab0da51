// What the hardened functions cost beside the published ones, on lavapipe: each case of
// cases/published that is like a case of a hardened function, or has the same call, both at the
// same inputs.
//
//   build/etalon_costs [PATTERN]...
//
// A time is that of one evaluation among a million or more, on all cores: the least of several
// runs, taken in turns, without that of reading the inputs and of adding up. Instructions are those
// of the optimised SPIR-V. The program serves as its own worker.

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <optional>

#include "case/case.h"
#include "compile/compile.h"
#include "instructions.h"
#include "looped_call.h"
#include "run/case_choice.h"
#include "run/devices.h"
#include "run/fit.h"
#include "worker/serve.h"

namespace etalon {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kDevice = "vulkan:llvmpipe";
constexpr std::string_view kPublished = "published/";
constexpr std::uint64_t kRows = 1u << 14;
constexpr std::uint64_t kLeastTurns = 64;   // a million evaluations
constexpr std::uint64_t kMostTurns = 1024;  // llvmpipe ends all loops after 65536 turns
constexpr unsigned kCopies = 8;             // of a call without loops, in each turn
constexpr double kLeastSeconds = 0.02;      // of a run
constexpr double kEnoughSeconds = 1.0;      // of all runs of a function
constexpr std::size_t kMostRuns = 25;
constexpr std::size_t kFewestRuns = 3;
constexpr double kAllowed = 1.25;
// Below this much a difference of times is noise.
constexpr double kNoise = 0.05e-9;

struct Pair {
    Case published;
    Case hardened;
    std::vector<std::string> covers;
    bool is_right = false;  // nothing is expected to fail
};

struct Cost {
    double seconds = 0;  // of one evaluation
    InstructionCount instructions;
};

// One loop on the device.
class Timed {
  public:
    static Result<Timed> Make(const PreparedCase& prepared, const std::filesystem::path& file,
                              unsigned copies, bool empty) {
        Timed timed;
        timed.copies_ = copies;
        ETALON_TRY(call, LoopedCall(prepared, file, copies, empty));
        timed.call_ = std::move(call);
        ETALON_TRY(signature, Inspect(timed.call_));
        timed.signature_ = signature;
        const Table& table = prepared.table;
        timed.columns_ = table.columns.size() + 1;
        timed.words_.resize(timed.columns_ * kRows);
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            for (std::uint64_t row = 0; row < kRows; ++row) {
                timed.words_[c * kRows + row] = table.At(row % table.rows, c);
            }
        }
        return timed;
    }

    // Seconds of one dispatch of so many turns.
    Result<double> Run(Runner& runner, std::uint64_t turns) {
        std::fill(words_.end() - static_cast<std::ptrdiff_t>(kRows), words_.end(),
                  static_cast<std::uint32_t>(turns));
        const Clock::time_point start = Clock::now();
        const auto evaluated = runner.Evaluate(
            call_, signature_, DefaultRecipe(runner.info()), {words_, kRows, columns_},
            [](std::uint64_t, std::uint32_t, std::span<const std::uint32_t>) {});
        if (!evaluated) {
            return Error{evaluated.error().reason};
        }
        return std::chrono::duration<double>(Clock::now() - start).count();
    }

    // Chooses how many turns a run has, and how many runs there are.
    Status<> Settle(Runner& runner) {
        ETALON_TRY_STEP(Run(runner, 0));
        turns_ = kLeastTurns;
        ETALON_TRY(first, Run(runner, turns_));
        while (first < kLeastSeconds && turns_ < kMostTurns) {
            turns_ *= 2;
            ETALON_TRY(next, Run(runner, turns_));
            first = next;
        }
        runs_ =
            std::clamp(static_cast<std::size_t>(kEnoughSeconds / first), kFewestRuns, kMostRuns);
        return Ok();
    }

    std::size_t runs() const { return runs_; }

    // One run more. The empty dispatch that is taken away is one of no turn.
    Status<> Measure(Runner& runner) {
        ETALON_TRY(idle, Run(runner, 0));
        ETALON_TRY(busy, Run(runner, turns_));
        idle_ = std::min(idle_, idle);
        busy_ = std::min(busy_, busy);
        return Ok();
    }

    double SecondsOfOne() const {
        return (busy_ - idle_) / static_cast<double>(kRows * turns_ * copies_);
    }

  private:
    Call call_;
    Signature signature_;
    std::vector<std::uint32_t> words_;
    std::size_t columns_ = 0;
    std::uint64_t copies_ = 1;
    std::uint64_t turns_ = 1;
    std::size_t runs_ = kFewestRuns;
    double idle_ = std::numeric_limits<double>::infinity();
    double busy_ = std::numeric_limits<double>::infinity();
};

// The case's call, whether it has an oracle or laws alone.
Result<PreparedCase> PrepareCall(Case source) {
    source.laws.clear();
    source.expectations.clear();
    ETALON_TRY(prepared, Prepare(source));
    prepared.call.wanted = {{"result", source.call, source.call_place.Text() + "call"}};
    ETALON_TRY(signature, Inspect(prepared.call));
    prepared.signature = signature;
    return std::move(prepared);
}

Result<InstructionCount> CountIn(const PreparedCase& prepared, const Runner& runner) {
    Recipe recipe = DefaultRecipe(runner.info());
    recipe.optimise = Recipe::Optimise::kSpeed;
    const auto program =
        Compile(prepared.call, prepared.signature, recipe, TargetOf(runner.info()), {});
    if (!program) {
        return Error{program.error().reason};
    }
    return CountInstructions(program->spirv);
}

// Published first, hardened second. `files` were written so far: a runner knows a program by the
// names of its files, and each is a new one.
Result<std::array<Cost, 2>> Compare(const Pair& pair, Runner& runner,
                                    const std::filesystem::path& folder, unsigned& files) {
    std::array<Case, 2> cases = {pair.published, pair.hardened};
    cases[1].domains = cases[0].domains;
    std::array<Cost, 2> costs;
    std::array<PreparedCase, 2> prepared;
    for (std::size_t i = 0; i < cases.size(); ++i) {
        ETALON_TRY(one, PrepareCall(cases[i]));
        prepared[i] = std::move(one);
        ETALON_TRY(count, CountIn(prepared[i], runner));
        costs[i].instructions = count;
    }
    const bool loops = costs[0].instructions.loops || costs[1].instructions.loops;
    std::vector<Timed> timed;  // the two, then their empty loops
    for (const bool empty : {false, true}) {
        for (const PreparedCase& one : prepared) {
            const std::filesystem::path file =
                folder / ("loop" + std::to_string(files++) + ".glsl");
            ETALON_TRY(loop, Timed::Make(one, file, loops ? 1 : kCopies, empty));
            ETALON_TRY_STEP(loop.Settle(runner));
            timed.push_back(std::move(loop));
        }
    }
    const std::size_t runs = std::min(timed[0].runs(), timed[1].runs());
    for (std::size_t run = 0; run < runs; ++run) {
        for (Timed& one : timed) {
            ETALON_TRY_STEP(one.Measure(runner));
        }
    }
    for (std::size_t i = 0; i < costs.size(); ++i) {
        costs[i].seconds = timed[i].SecondsOfOne() - timed[2 + i].SecondsOfOne();
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
    double InstructionRatio() const {
        return static_cast<double>(costs[1].instructions.computing) /
               static_cast<double>(std::max<std::uint64_t>(costs[0].instructions.computing, 1));
    }
};

void Print(const Row& row) {
    const Pair& pair = *row.pair;
    const std::optional<double> ratio = row.TimeRatio();
    const std::string fetches = std::to_string(row.costs[0].instructions.fetches) + ":" +
                                std::to_string(row.costs[1].instructions.fetches);
    std::printf("%-16s %-26s %-5s %9.3f %9.3f %6s %5llu:%-5llu %5.2f %7s  %s\n",
                Joined(pair.covers).c_str(), FunctionOf(pair.hardened.call).c_str(),
                pair.is_right ? "yes" : "no", row.costs[0].seconds * 1e9,
                row.costs[1].seconds * 1e9, ratio ? Ratio(*ratio, 1).c_str() : "-",
                static_cast<unsigned long long>(row.costs[0].instructions.computing),
                static_cast<unsigned long long>(row.costs[1].instructions.computing),
                row.InstructionRatio(), fetches.c_str(), pair.published.path.c_str());
    std::fflush(stdout);
}

Result<int> PrintCosts(const std::vector<std::string>& patterns) {
    ETALON_TRY(pairs, FindPairs(ETALON_ROOT, patterns));
    DeviceChoice choice;
    choice.patterns = {kDevice};
    ETALON_TRY(devices, OpenDevices(choice));
    Runner& runner = *devices.runners.front();
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("etalon-costs-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);

    std::printf("%-16s %-26s %-5s %9s %9s %6s %11s %5s %7s  %s\n", "shows", "function", "right",
                "published", "hardened", "ratio", "instr.", "ratio", "fetches", "case (ns)");
    std::vector<Row> rows;
    std::vector<std::string> left_out;
    unsigned files = 0;
    for (const Pair& pair : pairs) {
        const auto costs = Compare(pair, runner, folder, files);
        if (!costs) {
            left_out.push_back(pair.published.path + ": " + costs.error().message);
            continue;
        }
        rows.push_back({&pair, *costs});
        Print(rows.back());
    }
    std::filesystem::remove_all(folder);

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
