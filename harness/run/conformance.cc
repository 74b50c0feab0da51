#include "run/conformance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <map>
#include <memory>
#include <set>

#include "base/file.h"
#include "base/format.h"
#include "report/text.h"
#include "run/case_choice.h"
#include "run/case_run.h"
#include "run/findings.h"
#include "run/fit.h"
#include "run/gtest_flags.h"
#include "run/gtest_report.h"
#include "run/listener.h"
#include "run/read_catalogue.h"
#include "run/ready_cases.h"
#include "run/schedule.h"

namespace etalon {
namespace {

// Rows of a case that are built in where a recipe bakes its inputs: each costs the driver's
// compiler its own copy.
constexpr std::uint64_t kBakedRows = 6;
// Rows that a slow device judges of a case in a quick run.
constexpr std::uint64_t kSlowRows = 2048;

// One test: a case on a device by a recipe.
struct Planned {
    std::size_t case_index = 0;
    Runner* runner = nullptr;
    Result<Recipe> recipe;  // as it fits the device; the error is the reason of a skip
    std::string recipe_text;
    std::uint64_t rows = 0;  // at most
    std::string name;        // "suite.test"
};

// Everything that the tests share while they run.
struct Shared {
    std::vector<PreparedCase> cases;
    // By index and most rows: of the cases that run at some of their rows.
    std::map<std::pair<std::size_t, std::uint64_t>, PreparedCase> thin;
    DeviceSet devices;
    std::unique_ptr<Evaluations> evaluations;
    RepeatContext repeat;
    std::vector<Planned> plan;
    std::map<std::size_t, std::size_t> jobs;     // index in the plan -> index in the schedule
    std::map<std::size_t, std::size_t> untaken;  // by case: jobs whose record was not taken yet
    std::unique_ptr<Schedule> schedule;
    RunRecord record;

    const PreparedCase& PreparedFor(const Planned& planned) const {
        const auto some = thin.find({planned.case_index, planned.rows});
        return some == thin.end() ? cases[planned.case_index] : some->second;
    }
    // What was evaluated for a case takes memory until its last record is there.
    Record Take(std::size_t index) {
        Record taken = schedule->Take(jobs.at(index));
        const std::size_t case_index = plan[index].case_index;
        if (--untaken[case_index] == 0) {
            for (const Planned& planned : plan) {
                if (planned.case_index == case_index) {
                    evaluations->Forget(PreparedFor(planned).table.words);
                }
            }
        }
        return taken;
    }
    Record Run(const Planned& planned) const {
        if (planned.recipe) {
            return RunCase(PreparedFor(planned), *planned.runner, *planned.recipe, *evaluations,
                           repeat);
        }
        Record skipped;
        skipped.case_path = cases[planned.case_index].source.path;
        skipped.covers = cases[planned.case_index].source.covers;
        skipped.device = planned.runner->info().name;
        skipped.recipe = planned.recipe_text;
        skipped.verdict = Verdict::kSkip;
        skipped.reason = planned.recipe.error().message;
        return skipped;
    }
};

class CaseTest : public ::testing::Test {
  public:
    CaseTest(Shared& shared, std::size_t index) : shared_(shared), index_(index) {}

    void TestBody() override {
        const Record record = shared_.Take(index_);
        RecordProperty("verdict", std::string(VerdictName(record.verdict)));
        RecordProperty("seed", std::to_string(record.seed));
        if (record.worst) {
            RecordProperty("worst_ulp_error", ShortNumber(record.worst->ulp_error));
            RecordProperty("margin", ShortNumber(1 - record.worst->used));
            RecordProperty("worst", WorstText(*record.worst));
        }
        if (const Observation* shown = record.Shown(); shown != nullptr && shown->budget) {
            RecordProperty("culprit", shown->budget->culprit);
            RecordProperty("budget", BudgetText(*shown->budget));
        }
        if (!record.parts.empty()) {
            RecordProperty("parts", PartsText(record));
        }
        if (record.held > 0) {
            RecordProperty("specification",
                           format("{}: {} of {} values outside, {} unbounded", record.profile,
                                  record.outside, record.held, record.unbounded));
        }
        for (const ShareCount& count : record.shares) {
            RecordProperty("shares." + count.output, ShareText(count));
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
};

// Starts the tests that GoogleTest has selected on all cores, ahead of their turn.
class Starter : public ::testing::EmptyTestEventListener {
  public:
    Starter(Shared& shared, unsigned threads) : shared_(shared), threads_(threads) {}

    void OnTestIterationStart(const ::testing::UnitTest& tests, int) override {
        std::set<std::string> selected;
        for (int i = 0; i < tests.total_test_suite_count(); ++i) {
            const ::testing::TestSuite& suite = *tests.GetTestSuite(i);
            for (int k = 0; k < suite.total_test_count(); ++k) {
                if (suite.GetTestInfo(k)->should_run()) {
                    selected.insert(std::string(suite.name()) + "." + suite.GetTestInfo(k)->name());
                }
            }
        }
        std::vector<Schedule::Job> jobs;
        shared_.jobs.clear();
        shared_.untaken.clear();
        for (std::size_t i = 0; i < shared_.plan.size(); ++i) {
            const Planned& planned = shared_.plan[i];
            if (selected.contains(planned.name)) {
                shared_.jobs[i] = jobs.size();
                ++shared_.untaken[planned.case_index];
                jobs.push_back({planned.runner, [this, &planned] { return shared_.Run(planned); }});
            }
        }
        shared_.schedule = std::make_unique<Schedule>(std::move(jobs), threads_);
    }
    void OnTestIterationEnd(const ::testing::UnitTest&, int) override { shared_.schedule.reset(); }

  private:
    Shared& shared_;
    unsigned threads_;
};

// A device's or recipe's name as part of a test's: ':' and '-' have a meaning in --gtest_filter.
std::string TestName(const std::string& device, const std::string& recipe) {
    std::string name = device + "/" + recipe;
    std::replace(name.begin(), name.end(), ':', '/');
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

void Register(Shared& shared, Planned planned) {
    const std::string suite = shared.cases[planned.case_index].source.path;
    const std::string test = TestName(planned.runner->info().name, planned.recipe_text);
    planned.name = suite + "." + test;
    const PreparedCase& prepared = shared.cases[planned.case_index];
    const std::pair key(planned.case_index, planned.rows);
    if (planned.recipe && planned.rows < prepared.table.rows && !shared.thin.contains(key)) {
        shared.thin.emplace(key, Thin(prepared, planned.rows));
    }
    const std::size_t index = shared.plan.size();
    shared.plan.push_back(std::move(planned));
    ::testing::RegisterTest(
        suite.c_str(), test.c_str(), nullptr, nullptr, __FILE__, __LINE__,
        [&shared, index]() -> CaseTest* { return new CaseTest(shared, index); });
}

Result<std::vector<Recipe>> RecipesFor(const Case& source, const RunChoice& choice,
                                       const DeviceInfo& device) {
    const std::vector<std::string>& chosen = choice.recipes;
    const std::vector<std::string>& texts = chosen.empty() ? source.recipes : chosen;
    if (texts.empty()) {
        return choice.depth == Depth::kFull ? DefaultRecipes(device)
                                            : QuickRecipes(device, source.path);
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

// Whether the sources compile for fragment shaders only, as those with derivatives do.
bool NeedsFragment(const PreparedCase& prepared) {
    return prepared.signature.stage == Stage::kFragment ||
           std::any_of(prepared.laws.begin(), prepared.laws.end(), [](const PreparedLaw& law) {
               return law.signature.stage == Stage::kFragment;
           });
}

// The most rows at which a case runs. Derivatives are taken between neighbouring rows, which must
// stay neighbours.
std::uint64_t MostRows(const PreparedCase& prepared, const Result<Recipe>& recipe,
                       const DeviceInfo& device, Depth depth) {
    std::uint64_t rows = prepared.table.rows;
    if (recipe && recipe->baked) {
        rows = std::min(rows, kBakedRows);
    }
    const bool is_quick = depth == Depth::kQuick && device.slow;
    if (is_quick && !NeedsFragment(prepared)) {
        rows = std::min(rows, kSlowRows);
    }
    return rows;
}

// Two wanted recipes may fit a device in the same way; one test is enough.
Status<> RegisterAll(Shared& shared, const RunChoice& choice) {
    for (std::size_t index = 0; index < shared.cases.size(); ++index) {
        for (const auto& runner : shared.devices.runners) {
            ETALON_TRY(recipes, RecipesFor(shared.cases[index].source, choice, runner->info()));
            std::vector<std::string> names;
            for (Recipe recipe : recipes) {
                if (NeedsFragment(shared.cases[index])) {
                    recipe.stage = Stage::kFragment;
                }
                const Result<Recipe> fitted = FitRecipe(recipe, runner->info());
                const std::string name = RecipeText(fitted ? *fitted : recipe);
                if (std::find(names.begin(), names.end(), name) == names.end()) {
                    names.push_back(name);
                    const std::uint64_t rows =
                        MostRows(shared.cases[index], fitted, runner->info(), choice.depth);
                    Register(shared, {index, runner.get(), fitted, name, rows, ""});
                }
            }
        }
    }
    return Ok();
}

double SecondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Result<RunOutcome> RunConformance(const RunChoice& choice) {
    const auto start = std::chrono::steady_clock::now();
    ETALON_TRY(paths, ChooseCases(choice.root, choice.patterns));
    if (!choice.at.empty() && paths.size() != 1) {
        return Error{"--at needs exactly one case, the pattern names " +
                     std::to_string(paths.size())};
    }
    std::vector<CatalogueEntry> catalogue;
    if (choice.catalogue) {
        ETALON_TRY(entries, ReadCatalogue(choice.root));
        catalogue = std::move(entries);
    }
    // Static, because GoogleTest keeps the tests, and what they refer to, until the process ends.
    static Shared shared;
    ETALON_TRY(ready, MakeReady(choice, paths, catalogue));
    for (ReadyCase& one : ready) {
        shared.record.cases.push_back(std::move(one.note));
        shared.cases.push_back(std::move(one.prepared));
    }
    ETALON_TRY(devices, OpenDevices(choice.devices));
    shared.devices = std::move(devices);
    shared.evaluations = std::make_unique<Evaluations>(shared.devices.programs);
    for (const Driver& driver : choice.devices.drivers) {
        shared.repeat.options +=
            " --driver " + ShellWord(driver.name + "=" + driver.prefix.string());
    }
    if (!choice.root.empty()) {
        shared.repeat.options += " --root " + ShellWord(choice.root.string());
    }
    if (choice.depth == Depth::kFull) {
        shared.repeat.options += " --depth full";
    }
    if (choice.devices.limits.timeout != WorkerLimits{}.timeout) {
        const double seconds = std::chrono::duration<double>(choice.devices.limits.timeout).count();
        shared.repeat.options += format(" --timeout {}", seconds);
    }
    if (choice.devices.limits.memory_bytes != WorkerLimits{}.memory_bytes) {
        shared.repeat.options += format(" --memory {}", choice.devices.limits.memory_bytes >> 20);
    }
    for (const auto& runner : shared.devices.runners) {
        shared.record.devices.push_back(runner->info());
    }
    shared.record.absent = shared.devices.absent;
    shared.record.version = ETALON_VERSION;

    std::vector<std::string> gtest_arguments = choice.gtest_arguments;
    const GtestReport report(gtest_arguments);
    ETALON_TRY_STEP(InitGoogleTest(gtest_arguments));
    ETALON_TRY_STEP(RegisterAll(shared, choice));
    ::testing::UnitTest& tests = *::testing::UnitTest::GetInstance();
    RunOutcome outcome;
    outcome.catalogue = std::move(catalogue);
    outcome.listed_only = GTEST_FLAG_GET(list_tests);
    if (!outcome.listed_only) {
        ::testing::TestEventListeners& listeners = tests.listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new Starter(shared, choice.jobs));
        listeners.Append(
            MakeListener(shared.record.records, choice.verbose, tests.total_test_count())
                .release());
    }
    outcome.good = RUN_ALL_TESTS() == 0;
    if (auto written = report.Write(); !written) {
        outcome.report_error = written.error().message;
    }
    if (choice.findings) {
        std::map<std::string, const Case*> cases;
        for (const PreparedCase& prepared : shared.cases) {
            cases[prepared.source.path] = &prepared.source;
        }
        FoundOutside found = FindOutside(shared.record, cases, shared.devices.programs);
        shared.record.findings = std::move(found.findings);
        outcome.reproducers = std::move(found.reproducers);
    }
    shared.record.seconds = SecondsSince(start);
    outcome.record = std::move(shared.record);
    // Workers end here, in order, and not in a destructor after main.
    shared.devices = DeviceSet{};
    // A shard may have nothing to do; a filter that leaves nothing is a mistake.
    const bool is_shard = std::getenv("GTEST_TOTAL_SHARDS") != nullptr;
    if (!outcome.listed_only && !is_shard && outcome.record.records.empty()) {
        return Error{"no test was selected: the filter leaves none"};
    }
    outcome.chosen_only = !choice.patterns.empty() || is_shard || GTEST_FLAG_GET(filter) != "*";
    const std::vector<Record>& records = outcome.record.records;
    outcome.nothing_ran =
        !records.empty() && std::all_of(records.begin(), records.end(), [](const Record& record) {
            return record.verdict == Verdict::kSkip;
        });
    return outcome;
}

}  // namespace etalon
