#include "run/conformance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iostream>
#include <map>
#include <set>

#include "base/file.h"
#include "base/format.h"
#include "report/text.h"
#include "run/case_run.h"
#include "run/fit.h"
#include "run/progress.h"

namespace etalon {
namespace {

// Rows of a case that are built in where a recipe bakes its inputs: each costs the driver's
// compiler its own copy.
constexpr std::uint64_t kBakedRows = 6;

// Everything that the tests share while they run.
struct Shared {
    std::vector<PreparedCase> cases;
    std::map<std::size_t, PreparedCase> thin;  // of baked recipes, made on first use
    DeviceSet devices;
    RepeatContext repeat;
    RunRecord record;

    const PreparedCase& CaseFor(std::size_t index, const Recipe& recipe) {
        if (!recipe.baked) {
            return cases[index];
        }
        const auto known = thin.find(index);
        return known != thin.end()
                   ? known->second
                   : thin.emplace(index, Thin(cases[index], kBakedRows)).first->second;
    }
};

class CaseTest : public ::testing::Test {
  public:
    CaseTest(Shared& shared, std::size_t index, Session& session, Result<Recipe> recipe,
             std::string wanted)
        : shared_(shared),
          index_(index),
          session_(session),
          recipe_(std::move(recipe)),
          wanted_(std::move(wanted)) {}

    void TestBody() override {
        Record record;
        if (recipe_) {
            record = RunCase(shared_.CaseFor(index_, *recipe_), session_, *recipe_, shared_.repeat);
        } else {
            record.case_path = shared_.cases[index_].source.path;
            record.device = session_.info().name;
            record.recipe = wanted_;
            record.verdict = Verdict::kSkip;
            record.reason = recipe_.error().message;
        }
        RecordProperty("verdict", std::string(VerdictName(record.verdict)));
        if (record.worst) {
            RecordProperty("worst_ulp_error", ShortNumber(record.worst->ulp_error));
            RecordProperty("margin", ShortNumber(1 - record.worst->used));
            RecordProperty("worst", WorstText(*record.worst));
        }
        if (!record.known_cause.empty()) {
            RecordProperty("known_cause", record.known_cause);
        }
        if (!record.flake.empty()) {
            RecordProperty("flake", record.flake);
        }
        shared_.record.records.push_back(record);
        if (record.verdict == Verdict::kSkip) {
            GTEST_SKIP() << record.reason;
        }
        if (!record.Good()) {
            GTEST_FAIL() << FailureText(record);
        }
    }

  private:
    Shared& shared_;
    std::size_t index_;
    Session& session_;
    Result<Recipe> recipe_;
    std::string wanted_;
};

// A device's or recipe's name as part of a test's: ':' and '-' have a meaning in --gtest_filter.
std::string TestName(const std::string& device, const std::string& recipe) {
    std::string name = device + "/" + recipe;
    std::replace(name.begin(), name.end(), ':', '/');
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

void Register(Shared& shared, std::size_t index, Session& session, const Recipe& wanted) {
    const Result<Recipe> fitted = FitRecipe(wanted, session.info());
    const std::string text = RecipeText(fitted ? *fitted : wanted);
    const PreparedCase& prepared = shared.cases[index];
    ::testing::RegisterTest(prepared.source.path.c_str(),
                            TestName(session.info().name, text).c_str(), nullptr, nullptr, __FILE__,
                            __LINE__, [&shared, index, &session, fitted, text]() -> CaseTest* {
                                return new CaseTest(shared, index, session, fitted, text);
                            });
}

Result<std::vector<Recipe>> RecipesFor(const Case& source, const std::vector<std::string>& chosen,
                                       const DeviceInfo& device) {
    const std::vector<std::string>& texts = chosen.empty() ? source.recipes : chosen;
    if (texts.empty()) {
        return DefaultRecipes(device);
    }
    std::vector<Recipe> recipes;
    for (const std::string& text : texts) {
        Result<Recipe> recipe = ParseRecipe(text);
        if (!recipe) {
            return chosen.empty() ? Error{source.file.string() + ": " + recipe.error().message}
                                  : recipe.error();
        }
        recipes.push_back(*recipe);
    }
    return recipes;
}

// Two wanted recipes may fit a device in the same way; one test is enough.
Status<> RegisterAll(Shared& shared, const RunChoice& choice) {
    for (std::size_t index = 0; index < shared.cases.size(); ++index) {
        for (const auto& session : shared.devices.sessions) {
            ETALON_TRY(recipes,
                       RecipesFor(shared.cases[index].source, choice.recipes, session->info()));
            std::vector<std::string> names;
            for (Recipe recipe : recipes) {
                if (shared.cases[index].signature.stage == Stage::kFragment) {
                    recipe.stage = Stage::kFragment;
                }
                const Result<Recipe> fitted = FitRecipe(recipe, session->info());
                const std::string name = RecipeText(fitted ? *fitted : recipe);
                if (std::find(names.begin(), names.end(), name) == names.end()) {
                    names.push_back(name);
                    Register(shared, index, *session, recipe);
                }
            }
        }
    }
    return Ok();
}

// GoogleTest's own talk gives way to a progress line, each failure in full, and the summary
// afterwards.
class Listener : public ::testing::EmptyTestEventListener {
  public:
    Listener(const std::vector<Record>& records, bool verbose, int total)
        : records_(records), verbose_(verbose), progress_(total) {}

    void OnTestEnd(const ::testing::TestInfo& test) override {
        if (test.result()->Failed()) {
            progress_.Clear();
            std::cout << Told(records_.back()) << "\n" << std::flush;
        }
        const std::string name = std::string(test.test_suite_name()) + "." + test.name();
        if (verbose_) {
            std::cout << (test.result()->Failed()    ? "fail "
                          : test.result()->Skipped() ? "skip "
                                                     : "pass ")
                      << name << " (" << test.result()->elapsed_time() << " ms)\n";
        }
        progress_.Step(name);
    }
    void OnTestProgramEnd(const ::testing::UnitTest&) override { progress_.Clear(); }

  private:
    // The whole failure, or one line where the case has failed alike on another device: same input,
    // same value.
    std::string Told(const Record& record) {
        if (record.worst && record.refused > 0) {
            std::string same = record.case_path + record.worst->output + record.worst->actual.hex;
            for (const auto& [name, value] : record.worst->inputs) {
                same += name + value.hex;
            }
            if (!told_.insert(same).second) {
                return record.case_path + " on " + record.device + " (" + record.recipe +
                       "): fail, with the same input and value";
            }
        }
        return FailureText(record);
    }

    const std::vector<Record>& records_;
    bool verbose_;
    Progress progress_;
    std::set<std::string> told_;
};

bool IsPrefixOf(const std::string& pattern, const std::string& path) {
    return path == pattern ||
           (path.starts_with(pattern) && (pattern.ends_with('/') || path[pattern.size()] == '/'));
}

// GoogleTest answers a flag that it does not know with its help on the standard output.
constexpr std::array kGoogleTestFlags = {"also_run_disabled_tests",
                                         "break_on_failure",
                                         "brief",
                                         "catch_exceptions",
                                         "color",
                                         "fail_fast",
                                         "filter",
                                         "list_tests",
                                         "output",
                                         "print_time",
                                         "print_utf8",
                                         "random_seed",
                                         "recreate_environments_when_repeating",
                                         "repeat",
                                         "shuffle",
                                         "stack_trace_depth",
                                         "stream_result_to",
                                         "throw_on_failure"};

Status<> InitGoogleTest(const std::vector<std::string>& arguments) {
    for (const std::string& argument : arguments) {
        const std::string_view prefix = "--gtest_";
        const std::string name = argument.substr(prefix.size(), argument.find('=') - prefix.size());
        if (std::find(kGoogleTestFlags.begin(), kGoogleTestFlags.end(), name) ==
            kGoogleTestFlags.end()) {
            return Error{"GoogleTest knows no flag '" + argument + "'"};
        }
    }
    std::vector<std::string> words = {"etalon"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    pointers.reserve(words.size() + 1);
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    int count = static_cast<int>(words.size());
    ::testing::InitGoogleTest(&count, pointers.data());
    return Ok();
}

}  // namespace

Result<std::filesystem::path> FindRoot(const std::filesystem::path& from) {
    std::error_code ignored;
    for (std::filesystem::path folder = std::filesystem::absolute(from, ignored);;
         folder = folder.parent_path()) {
        if (std::filesystem::is_directory(folder / "cases", ignored)) {
            const std::filesystem::path near = std::filesystem::proximate(folder, ignored);
            // The folder that the user stands in has no name, so that paths read "cases/x.toml".
            return near == "." ? std::filesystem::path() : near;
        }
        if (folder == folder.parent_path()) {
            return Error{
                "no folder 'cases' here or above; --root DIR names the folder that holds it"};
        }
    }
}

Result<std::vector<std::string>> ChooseCases(const std::filesystem::path& root,
                                             const std::vector<std::string>& patterns) {
    ETALON_TRY(all, ListCases(root));
    if (patterns.empty()) {
        if (all.empty()) {
            return Error{(root / "cases").string() + ": holds no case"};
        }
        return all;
    }
    std::vector<std::string> chosen;
    for (const std::string& pattern : patterns) {
        bool any = false;
        for (const std::string& path : all) {
            if (IsPrefixOf(pattern, path) || GlobMatches(pattern, path)) {
                any = true;
                chosen.push_back(path);
            }
        }
        if (!any) {
            return Error{"no case is called '" + pattern + "'; `etalon list` shows them"};
        }
    }
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

Result<RunOutcome> RunConformance(const RunChoice& choice) {
    const auto start = std::chrono::steady_clock::now();
    ETALON_TRY(paths, ChooseCases(choice.root, choice.patterns));
    if (!choice.at.empty() && paths.size() != 1) {
        return Error{"--at needs exactly one case, the pattern names " +
                     std::to_string(paths.size())};
    }
    // Static, because GoogleTest keeps the tests, and what they refer to, until the process ends.
    static Shared shared;
    for (const std::string& path : paths) {
        ETALON_TRY(source, ReadCase(choice.root, path));
        ETALON_TRY(prepared, choice.at.empty() ? Prepare(source) : PrepareAt(source, choice.at));
        shared.cases.push_back(std::move(prepared));
    }
    ETALON_TRY(devices, OpenDevices(choice.devices));
    shared.devices = std::move(devices);
    for (const Driver& driver : choice.devices.drivers) {
        shared.repeat.options +=
            " --driver " + ShellWord(driver.name + "=" + driver.prefix.string());
    }
    if (!choice.root.empty()) {
        shared.repeat.options += " --root " + ShellWord(choice.root.string());
    }
    if (choice.devices.limits.timeout != WorkerLimits{}.timeout) {
        const double seconds = std::chrono::duration<double>(choice.devices.limits.timeout).count();
        shared.repeat.options += format(" --timeout {}", seconds);
    }
    if (choice.devices.limits.memory_bytes != WorkerLimits{}.memory_bytes) {
        shared.repeat.options += format(" --memory {}", choice.devices.limits.memory_bytes >> 20);
    }
    for (const auto& session : shared.devices.sessions) {
        shared.record.devices.push_back(session->info());
    }
    shared.record.absent = shared.devices.absent;
    shared.record.version = ETALON_VERSION;

    ETALON_TRY_STEP(InitGoogleTest(choice.gtest_arguments));
    ETALON_TRY_STEP(RegisterAll(shared, choice));
    ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
    RunOutcome outcome;
    outcome.listed_only = GTEST_FLAG_GET(list_tests);
    if (!outcome.listed_only) {
        ::testing::TestEventListeners& listeners = tests.listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(
            new Listener(shared.record.records, choice.verbose, tests.total_test_count()));
    }
    outcome.good = RUN_ALL_TESTS() == 0;
    shared.record.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    outcome.record = std::move(shared.record);
    // Workers end here, in order, and not in a destructor after main.
    shared.devices = DeviceSet{};
    if (!outcome.listed_only && outcome.record.records.empty()) {
        return Error{"no test was selected: the filter or the shard leaves none"};
    }
    const std::vector<Record>& records = outcome.record.records;
    outcome.nothing_ran =
        !records.empty() && std::all_of(records.begin(), records.end(), [](const Record& record) {
            return record.verdict == Verdict::kSkip;
        });
    return outcome;
}

}  // namespace etalon
