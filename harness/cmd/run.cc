#include <algorithm>
#include <iostream>
#include <system_error>
#include <thread>

#include "base/file.h"
#include "base/format.h"
#include "cmd/command.h"
#include "cmd/options.h"
#include "cmd/report_option.h"
#include "report/catalogue.h"
#include "report/finding.h"
#include "report/json.h"
#include "report/reproducer.h"
#include "report/text.h"
#include "run/conformance.h"

namespace etalon {
namespace {

// What is written beside the summary.
struct RunReports {
    std::string json;
    std::string catalogue;
    std::string findings;
    std::size_t slowest = 0;
};

// The exit status.
int WriteCatalogue(const std::string& file, const RunOutcome& outcome) {
    if (auto written = WriteFile(
            file, CatalogueMarkdown(outcome.catalogue, outcome.record, outcome.chosen_only));
        !written) {
        return Complain("--catalogue: " + written.error().message);
    }
    if (outcome.chosen_only) {
        return 0;
    }
    std::string missing;
    for (const std::string& id : MissingIds(outcome.catalogue, outcome.record)) {
        missing += (missing.empty() ? "" : ", ") + id;
    }
    if (missing.empty()) {
        return 0;
    }
    std::cerr << "etalon: no case covers " << missing << "\n";
    return kVerdict;
}

// Reproducers of an earlier run, and nothing else, are taken away.
void RemoveReproducers(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> stale;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const Result<std::string> text = ReadFile(entry.path());
        if (text && IsReproducer(*text)) {
            stale.push_back(entry.path());
        }
    }
    for (const std::filesystem::path& file : stale) {
        std::filesystem::remove(file);
    }
}

// The exit status.
int WriteFindings(const std::filesystem::path& file, const RunOutcome& outcome) {
    const std::string name = "reproducers";
    const std::filesystem::path folder = file.parent_path() / name;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) {
        return Complain("--findings: " + folder.string() + ": " + error.message());
    }
    RemoveReproducers(folder);
    Status<> written = WriteFile(file, FindingsMarkdown(outcome.record, name));
    for (const auto& [reproducer, text] : outcome.reproducers) {
        if (written) {
            written = WriteFile(folder / reproducer, text);
        }
    }
    return written ? 0 : Complain("--findings: " + written.error().message);
}

class RunCommand : public Command {
  public:
    RunCommand(CLI::App& app, std::vector<std::string> gtest_arguments);

    int Run() override;

  private:
    int Report(const RunOutcome& outcome) const;

    RunChoice choice_;
    RunReports reports_;
    std::string root_;
    std::string depth_ = "quick";
    DeviceOptions devices_;
    ReportOption report_;
};

RunCommand::RunCommand(CLI::App& app, std::vector<std::string> gtest_arguments)
    : Command(app.add_subcommand(
          "run",
          "Run cases; GoogleTest's flags (--gtest_filter, --gtest_output, ...) pass through")) {
    choice_.gtest_arguments = std::move(gtest_arguments);
    word_->add_option("PATTERN", choice_.patterns,
                      "prefix of case paths, or a pattern with * and ?; default: all");
    AddRoot(*word_, root_);
    word_
        ->add_option("--recipe", choice_.recipes,
                     "recipe (plain, spirv+O, glsl+baked, ...); repeatable; default: the case's or "
                     "the device's own set")
        ->allow_extra_args(false);
    word_->add_option("--at", choice_.at, "run one case at one input: 'n1=1,n2=0x1.8p+0'");
    word_->add_option("--json", reports_.json, "write all records to FILE")->type_name("FILE");
    word_
        ->add_option("--catalogue", reports_.catalogue,
                     "write what was found of each id in shaders/catalogue.toml to FILE, as "
                     "Markdown; an id that no case covers is an error, unless only some are run")
        ->type_name("FILE.md");
    word_
        ->add_option("--findings", reports_.findings,
                     "write what no specification allows to FILE, as Markdown, and for each "
                     "finding a file that other tools run, into the folder reproducers beside it")
        ->type_name("FILE.md");
    report_.AddTo(*word_);
    word_->add_option("--slowest", reports_.slowest, "name the N cases that took longest")
        ->check(Within(1, 1e6))
        ->type_name("N");
    choice_.jobs = std::max(1u, std::thread::hardware_concurrency());
    word_->add_option("-j,--jobs", choice_.jobs, "devices at work at the same time")
        ->capture_default_str()
        ->check(Within(1, 1024))
        ->type_name("N");
    word_
        ->add_option("--depth", depth_,
                     "quick, or full: all recipes, inputs in their full counts, all rows on slow "
                     "devices")
        ->capture_default_str()
        ->check(CLI::IsMember({"quick", "full"}))
        ->type_name("DEPTH");
    word_->add_flag("--verbose", choice_.verbose, "a line for each test");
    devices_.AddTo(*word_);
}

int RunCommand::Run() {
    choice_.depth = depth_ == "full" ? Depth::kFull : Depth::kQuick;
    Result<std::filesystem::path> folder = RootOf(root_);
    if (!folder) {
        return Complain(folder.error().message);
    }
    choice_.root = *folder;
    Result<DeviceChoice> devices = devices_.Choice();
    if (!devices) {
        return Complain(devices.error().message);
    }
    choice_.devices = *devices;
    choice_.catalogue = !reports_.catalogue.empty();
    choice_.findings = !reports_.findings.empty();
    if (auto usable = report_.Check(); !usable) {
        return Complain(usable.error().message);
    }
    const Result<RunOutcome> outcome = RunConformance(choice_);
    return outcome ? Report(*outcome) : Complain(outcome.error().message);
}

int RunCommand::Report(const RunOutcome& outcome) const {
    if (outcome.listed_only) {
        return outcome.report_error.empty() ? 0 : Complain(outcome.report_error);
    }
    int passed = 0;
    int failed = 0;
    int skipped = 0;
    for (const Record& record : outcome.record.records) {
        ++(!record.Good() ? failed : record.verdict == Verdict::kSkip ? skipped : passed);
    }
    std::cout << "\n"
              << SummaryText(outcome.record)
              << format("{} passed, {} failed, {} skipped in {:.1f} s\n", passed, failed, skipped,
                        outcome.record.seconds);
    if (reports_.slowest > 0) {
        std::cout << "\n" << SlowestText(outcome.record, reports_.slowest);
    }
    if (!reports_.json.empty()) {
        if (auto written = WriteFile(reports_.json, RunJson(outcome.record)); !written) {
            return Complain("--json: " + written.error().message);
        }
    }
    if (auto added =
            report_.Add(ReportSection::kRun, "", [&outcome] { return RunJson(outcome.record); });
        !added) {
        return Complain(added.error().message);
    }
    if (!outcome.report_error.empty()) {
        return Complain(outcome.report_error);
    }
    if (outcome.nothing_ran) {
        return Complain("no test ran: every one was skipped");
    }
    if (!reports_.findings.empty() && WriteFindings(reports_.findings, outcome) != 0) {
        return kBadInput;
    }
    const int catalogue =
        reports_.catalogue.empty() ? 0 : WriteCatalogue(reports_.catalogue, outcome);
    return catalogue == 0 && !outcome.good ? kVerdict : catalogue;
}

}  // namespace

std::unique_ptr<Command> AddRun(CLI::App& app, std::vector<std::string> gtest_arguments) {
    return std::make_unique<RunCommand>(app, std::move(gtest_arguments));
}

}  // namespace etalon
