// The program `etalon`: words of the command line, nothing else.

#include <pthread.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>

#include "bake/bake.h"
#include "base/file.h"
#include "base/format.h"
#include "cmd/options.h"
#include "cmd/sweep.h"
#include "image/read.h"
#include "image/write.h"
#include "report/catalogue.h"
#include "report/explanation.h"
#include "report/json.h"
#include "report/reproducer.h"
#include "report/text.h"
#include "run/case_choice.h"
#include "run/conformance.h"
#include "run/explain.h"
#include "run/probe.h"
#include "worker/serve.h"

namespace etalon {
namespace {

// The compiler recurses over the source's expressions: a deep one needs a deep stack, in every
// thread that compiles. The limit of the process stays as it is, for the workers inherit that. A
// file that grows beyond a limit is an error, not the end.
void PrepareProcess() {
    constexpr std::size_t kStackBytes = 128u << 20;
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, kStackBytes);
    pthread_setattr_default_np(&attributes);
    pthread_attr_destroy(&attributes);
    std::signal(SIGXFSZ, SIG_IGN);
}

// The exit status, unless what was printed could not be written.
int Finish(int status) {
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        return Complain("standard output: cannot be written");
    }
    return status;
}

int ListDevices(const DeviceOptions& options, bool json, bool all) {
    Result<DeviceChoice> choice = options.Choice();
    if (!choice) {
        return Complain(choice.error().message);
    }
    Result<DeviceSet> devices = OpenDevices(*choice);
    if (!devices) {
        return Complain(devices.error().message);
    }
    RunRecord record;
    for (const auto& runner : devices->runners) {
        record.devices.push_back(runner->info());
    }
    record.absent = devices->absent;
    std::cout << (json ? DevicesJson(record) : DevicesText(record, all));
    return 0;
}

int List(const std::string& root, const std::vector<std::string>& patterns) {
    Result<std::filesystem::path> folder = RootOf(root);
    if (!folder) {
        return Complain(folder.error().message);
    }
    Result<std::vector<std::string>> paths = ChooseCases(*folder, patterns);
    if (!paths) {
        return Complain(paths.error().message);
    }
    for (const std::string& path : *paths) {
        std::cout << path << "\n";
    }
    return 0;
}

// What `etalon run` writes beside the summary.
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

int Run(RunChoice choice, const std::string& root, const DeviceOptions& options,
        const RunReports& reports) {
    Result<std::filesystem::path> folder = RootOf(root);
    if (!folder) {
        return Complain(folder.error().message);
    }
    choice.root = *folder;
    Result<DeviceChoice> devices = options.Choice();
    if (!devices) {
        return Complain(devices.error().message);
    }
    choice.devices = *devices;
    choice.catalogue = !reports.catalogue.empty();
    choice.findings = !reports.findings.empty();
    Result<RunOutcome> outcome = RunConformance(choice);
    if (!outcome) {
        return Complain(outcome.error().message);
    }
    if (outcome->listed_only) {
        return outcome->report_error.empty() ? 0 : Complain(outcome->report_error);
    }
    int passed = 0;
    int failed = 0;
    int skipped = 0;
    for (const Record& record : outcome->record.records) {
        ++(!record.Good() ? failed : record.verdict == Verdict::kSkip ? skipped : passed);
    }
    std::cout << "\n"
              << SummaryText(outcome->record)
              << format("{} passed, {} failed, {} skipped in {:.1f} s\n", passed, failed, skipped,
                        outcome->record.seconds);
    if (reports.slowest > 0) {
        std::cout << "\n" << SlowestText(outcome->record, reports.slowest);
    }
    if (!reports.json.empty()) {
        if (auto written = WriteFile(reports.json, RunJson(outcome->record)); !written) {
            return Complain("--json: " + written.error().message);
        }
    }
    if (!outcome->report_error.empty()) {
        return Complain(outcome->report_error);
    }
    if (outcome->nothing_ran) {
        return Complain("no test ran: every one was skipped");
    }
    if (!reports.findings.empty() && WriteFindings(reports.findings, *outcome) != 0) {
        return kBadInput;
    }
    const int catalogue =
        reports.catalogue.empty() ? 0 : WriteCatalogue(reports.catalogue, *outcome);
    return catalogue == 0 && !outcome->good ? kVerdict : catalogue;
}

int ExplainCase(ExplainChoice choice, const std::string& root, const DeviceOptions& options,
                bool json, bool all) {
    Result<std::filesystem::path> folder = RootOf(root);
    if (!folder) {
        return Complain(folder.error().message);
    }
    choice.root = *folder;
    Result<DeviceChoice> devices = options.Choice();
    if (!devices) {
        return Complain(devices.error().message);
    }
    choice.devices = *devices;
    Result<Explanation> explanation = Explain(choice);
    if (!explanation) {
        return Complain(explanation.error().message);
    }
    std::cout << (json ? ExplanationJson(*explanation) : ExplanationText(*explanation, all));
    const bool is_good =
        std::all_of(explanation->devices.begin(), explanation->devices.end(),
                    [](const ExplainedDevice& device) { return device.record.Good(); });
    return is_good ? 0 : kVerdict;
}

struct BakeChoice {
    std::string kind;
    std::string heights;
    std::string out;
    bake::Plan plan;
};

int Bake(BakeChoice choice) {
    choice.plan.kind = *bake::KindNamed(choice.kind);
    const Result<Image> heights = ReadImage(choice.heights);
    if (!heights) {
        return Complain(heights.error().message);
    }
    const Result<Image> map = bake::Bake(*heights, choice.plan);
    if (!map) {
        return Complain(choice.heights + ": " + map.error().message);
    }
    const Status<> written = WriteExr(choice.out, *map);
    return written ? 0 : Complain(written.error().message);
}

// GoogleTest's flags go through untouched; CLI11 never sees them.
std::vector<std::string> TakeGoogleTestFlags(std::vector<std::string>& arguments) {
    std::vector<std::string> taken;
    std::erase_if(arguments, [&](const std::string& argument) {
        const bool is_flag = argument.starts_with("--gtest_");
        if (is_flag) {
            taken.push_back(argument);
        }
        return is_flag;
    });
    return taken;
}

int Main(std::vector<std::string> arguments) {
    CLI::App app{
        "Calls GLSL functions on every graphics implementation of this machine and holds "
        "the numbers against physics."};
    app.name("etalon");
    app.require_subcommand(1);
    app.set_version_flag("--version", ETALON_VERSION);

    DeviceOptions devices;
    CLI::App* list_devices =
        app.add_subcommand("devices", "What can run here: versions, features, fingerprint");
    bool devices_json = false;
    bool devices_all = false;
    devices.AddTo(*list_devices);
    list_devices->add_flag("--json", devices_json, "as JSON");
    list_devices->add_flag("--all", devices_all, "also tell what was tried and is not here");

    CLI::App* list = app.add_subcommand("list", "Cases, by path");
    std::string root;
    std::vector<std::string> patterns;
    list->add_option("PATTERN", patterns, "prefix of case paths, or a pattern with * and ?");
    list->add_option("--root", root, "folder that holds cases/; default: here or above")
        ->type_name("DIR");

    CLI::App* run = app.add_subcommand(
        "run", "Run cases; GoogleTest's flags (--gtest_filter, --gtest_output, ...) pass through");
    RunChoice run_choice;
    RunReports reports;
    run->add_option("PATTERN", run_choice.patterns,
                    "prefix of case paths, or a pattern with * and ?; default: all");
    run->add_option("--root", root, "folder that holds cases/; default: here or above")
        ->type_name("DIR");
    run->add_option("--recipe", run_choice.recipes,
                    "recipe (plain, spirv+O, glsl+baked, ...); repeatable; default: the case's or "
                    "the device's own set")
        ->allow_extra_args(false);
    run->add_option("--at", run_choice.at, "run one case at one input: 'n1=1,n2=0x1.8p+0'");
    run->add_option("--json", reports.json, "write all records to FILE")->type_name("FILE");
    run->add_option("--catalogue", reports.catalogue,
                    "write what was found of each id in shaders/catalogue.toml to FILE, as "
                    "Markdown; an id that no case covers is an error, unless only some are run")
        ->type_name("FILE.md");
    run->add_option("--findings", reports.findings,
                    "write what no specification allows to FILE, as Markdown, and for each "
                    "finding a file that other tools run, into the folder reproducers beside it")
        ->type_name("FILE.md");
    run->add_option("--slowest", reports.slowest, "name the N cases that took longest")
        ->check(Within(1, 1e6))
        ->type_name("N");
    run_choice.jobs = std::max(1u, std::thread::hardware_concurrency());
    run->add_option("-j,--jobs", run_choice.jobs, "devices at work at the same time")
        ->capture_default_str()
        ->check(Within(1, 1024))
        ->type_name("N");
    std::string depth = "quick";
    run->add_option("--depth", depth,
                    "quick, or full: all recipes, inputs in their full counts, all rows on slow "
                    "devices")
        ->capture_default_str()
        ->check(CLI::IsMember({"quick", "full"}))
        ->type_name("DEPTH");
    run->add_flag("--verbose", run_choice.verbose, "a line for each test");
    devices.AddTo(*run);

    CLI::App* explain = app.add_subcommand(
        "explain",
        "One input of a case: every device's result and whose fault its error is, then a row for "
        "each operation of the path with its value in binary32, its exact value, the error so far "
        "in ulp of the exact value, and the amplification: how much larger the relative error of "
        "the result can be than those of the operands (the sum of |x df/dx| / |f| over the "
        "operands x), and the first operation at which each device parts");
    ExplainChoice explain_choice;
    bool explain_json = false;
    bool explain_all = false;
    explain
        ->add_option("CASE", explain_choice.pattern, "a case's path, or a pattern that names one")
        ->required();
    explain->add_option("--at", explain_choice.at,
                        "the input: 'n1=1,n2=0x1.8p+0'; default: the worst that a run of the case "
                        "on these devices finds");
    explain
        ->add_option("--output", explain_choice.output,
                     "result.x, or an out parameter; default: the first that is judged")
        ->type_name("NAME");
    explain->add_option("--root", root, "folder that holds cases/; default: here or above")
        ->type_name("DIR");
    explain
        ->add_option("--recipe", explain_choice.recipes,
                     "recipe (plain, spirv+O, glsl+baked, ...); repeatable; default: each "
                     "device's own")
        ->allow_extra_args(false);
    explain->add_flag("--all", explain_all, "print all operations of a long path");
    explain->add_flag("--json", explain_json, "as JSON, with all operations");
    devices.AddTo(*explain);

    SweepCommand sweep(app);

    CLI::App* probe = app.add_subcommand("probe", "Call a function now");
    ProbeChoice probe_choice;
    probe->add_option("SOURCE", probe_choice.source, "GLSL source file")->required();
    probe->add_option("CALL", probe_choice.call, "GLSL expression over the inputs: 'f(v, n, 1.5)'")
        ->required();
    CLI::Option* inputs =
        probe
            ->add_option("--inputs", probe_choice.inputs,
                         "CSV; its header reads name:type, vectors v.x:float,v.y:float")
            ->type_name("F.csv");
    probe
        ->add_option("--at", probe_choice.at,
                     "one row of inputs instead: 'n1=1,steps:int=3,v.x=0,v.y=1'")
        ->excludes(inputs);
    probe
        ->add_option("--in", probe_choice.in,
                     "type of an input that is no scalar or vector: m:mat3, hit:Hit")
        ->type_name("NAME:TYPE")
        ->allow_extra_args(false);
    probe
        ->add_option("--out", probe_choice.out,
                     "declares an out parameter (inout, if it is an input too)")
        ->type_name("NAME:TYPE")
        ->allow_extra_args(false);
    probe->add_option("-D", probe_choice.defines, "defines a macro")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    probe->add_option("--include", probe_choice.include, "adds a folder for #include")
        ->type_name("DIR")
        ->allow_extra_args(false);
    probe
        ->add_option("--with", probe_choice.with,
                     "adds a source that defines scene functions, or an image for a sampler2D: "
                     "height=map.png")
        ->type_name("FILE")
        ->allow_extra_args(false);
    probe
        ->add_option(
            "--image", probe_choice.images,
            "an image for a sampler, as in a case: 'height={ expr = \"sin(2*pi*u)\", size = "
            "[64, 64] }'")
        ->type_name("NAME={ ... }")
        ->allow_extra_args(false);
    probe
        ->add_option("--recipe", probe_choice.recipes,
                     "recipe (plain, spirv+O, glsl+baked, ...); repeatable")
        ->allow_extra_args(false);
    probe->add_flag("--csv", probe_choice.csv, "CSV instead of a table");
    devices.AddTo(*probe);

    CLI::App* bake = app.add_subcommand(
        "bake", "Make a map that a search of a relief reads, from an image of its heights");
    BakeChoice bake_choice;
    bake_choice.plan.level = bake::kFileLevel;
    bake->add_option("KIND", bake_choice.kind, "what to make")
        ->required()
        ->check(CLI::IsMember(
            std::vector<std::string>(bake::KindNames().begin(), bake::KindNames().end())));
    bake->add_option("HEIGHT", bake_choice.heights,
                     "the image; its red channel, repeating and bilinear")
        ->required();
    bake->add_option("-o,--out", bake_choice.out, "the map, OpenEXR in binary32")
        ->required()
        ->type_name("OUT.exr");
    bake->add_option("--slices", bake_choice.plan.slices, "of a distance map; default: 32")
        ->type_name("N");
    bake->add_option("--bearings", bake_choice.plan.bearings, "of a horizon map; default: 16")
        ->type_name("K");
    bake->add_option("--texels-per-height", bake_choice.plan.texels_per_height,
                     "texels as long as the relief's box is high; default: a tenth of the width")
        ->type_name("X");
    bake->add_option("--scale", bake_choice.plan.scale,
                     "z = scale * red + level, -0.5 to 0.5 in the box")
        ->capture_default_str()
        ->type_name("X");
    bake->add_option("--level", bake_choice.plan.level, "see --scale")
        ->capture_default_str()
        ->type_name("X");
    bake->add_flag("--published", bake_choice.plan.published,
                   "a distance or cone map as published, not safe between its points");

    run_choice.gtest_arguments = TakeGoogleTestFlags(arguments);
    try {
        std::reverse(arguments.begin(), arguments.end());
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            app.exit(error);
            return 0;
        }
        return Complain(std::string(error.what()) + "; --help tells more");
    }
    if (!*run && !run_choice.gtest_arguments.empty()) {
        return Complain("'" + run_choice.gtest_arguments.front() + "' is for `etalon run`");
    }
    if (*list_devices) {
        return ListDevices(devices, devices_json, devices_all);
    }
    if (sweep.IsChosen()) {
        return sweep.Run();
    }
    if (*bake) {
        return Bake(bake_choice);
    }
    if (*list) {
        return List(root, patterns);
    }
    if (*run) {
        run_choice.depth = depth == "full" ? Depth::kFull : Depth::kQuick;
        return Run(run_choice, root, devices, reports);
    }
    if (*explain) {
        return ExplainCase(explain_choice, root, devices, explain_json, explain_all);
    }
    Result<DeviceChoice> choice = devices.Choice();
    if (!choice) {
        return Complain(choice.error().message);
    }
    probe_choice.devices = *choice;
    Result<int> status = RunProbe(probe_choice, std::cout, std::cerr);
    return status ? *status : Complain(status.error().message);
}

}  // namespace
}  // namespace etalon

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "worker") {
        return etalon::ServeWorker(argc, argv);
    }
    etalon::PrepareProcess();
    std::ios::sync_with_stdio(false);
    int status = etalon::kBadInput;
    try {
        std::thread([&] {
            try {
                status = etalon::Main(std::vector<std::string>(argv + 1, argv + argc));
            } catch (const std::bad_alloc&) {
                status = etalon::Complain("out of memory");
            }
        }).join();
    } catch (const std::system_error&) {
        return etalon::Complain("out of memory");
    }
    return etalon::Finish(status);
}
