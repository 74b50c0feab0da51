#include "chart/chart.h"

#include <algorithm>
#include <iostream>

#include "base/file.h"
#include "cmd/command.h"
#include "cmd/options.h"
#include "cmd/report_option.h"
#include "run/case_choice.h"

namespace etalon {
namespace {

class ChartCommand : public Command {
  public:
    explicit ChartCommand(CLI::App& app);

    int Run() override;

  private:
    int List() const;
    Result<ChartRecord> Make();

    ChartChoice choice_;
    std::string root_;
    bool no_times_ = false;
    bool scenes_ = false;
    bool json_ = false;
    bool list_ = false;
    DeviceOptions devices_;
    ReportOption report_;
};

ChartCommand::ChartCommand(CLI::App& app)
    : Command(app.add_subcommand(
          "chart",
          "Accuracy and cost of several functions for one quantity: a line for each, those that "
          "nothing beats in both marked *, and the cheapest that holds each of six errors")) {
    word_->add_option("FAMILY", choice_.name,
                      "a family's address below cases/, or a TOML file, whose sources are relative "
                      "to the folder that holds cases/, or to its own where it is below none");
    word_
        ->add_option("--scene", choice_.scenes,
                     "only these scenes, by name or pattern; repeatable; default: all")
        ->type_name("NAME")
        ->allow_extra_args(false);
    word_
        ->add_option("--member", choice_.members,
                     "only these members or points, by name or pattern, and the reference; "
                     "repeatable; default: all")
        ->type_name("NAME")
        ->allow_extra_args(false);
    word_
        ->add_option("--seconds", choice_.seconds, "about so long each point is timed, on a device")
        ->capture_default_str()
        ->check(Within(0.01, 1e4))
        ->type_name("S");
    word_->add_flag("--no-times", no_times_,
                    "accuracy and counts of operations alone: the same bytes each time");
    word_->add_option("--recipe", choice_.recipe,
                      "recipe; default: the family's, else the device's own");
    word_->add_option("--at", choice_.at,
                      "one input in place of the domain: 'x=0x1.8p+0'; tells the values, too");
    word_->add_flag("--scenes", scenes_, "a table for each scene, before that for all together");
    word_->add_flag("--json", json_, "as JSON, with each scene");
    word_->add_flag("--list", list_, "the families below the root, with their quantity");
    report_.AddTo(*word_);
    AddRoot(*word_, root_);
    devices_.AddTo(*word_, "the first found");
}

int ChartCommand::List() const {
    const Result<std::filesystem::path> root = RootOf(root_);
    if (!root) {
        return Complain(root.error().message);
    }
    const auto addresses = ListFamilies(*root);
    if (!addresses) {
        return Complain(addresses.error().message);
    }
    std::size_t width = 0;
    for (const std::string& address : *addresses) {
        width = std::max(width, address.size());
    }
    for (const std::string& address : *addresses) {
        const auto quantity = ReadQuantity(*root / "cases" / (address + ".family.toml"));
        if (!quantity) {
            return Complain(quantity.error().message);
        }
        std::cout << (quantity->empty()
                          ? address
                          : address + std::string(width + 2 - address.size(), ' ') + *quantity)
                  << "\n";
    }
    return 0;
}

Result<ChartRecord> ChartCommand::Make() {
    if (choice_.name.empty()) {
        return Error{"chart: no family is named; `etalon chart --list` shows them"};
    }
    ETALON_TRY_STEP(report_.Check());
    std::filesystem::path root;
    if (!root_.empty()) {
        ETALON_TRY(given, RootOf(root_));
        root = given;
        choice_.options += " --root " + ShellWord(root_);
    }
    ETALON_TRY(place, FindFamily(root, choice_.name));
    choice_.place = place;
    for (const std::string& driver : devices_.drivers) {
        choice_.options += " --driver " + ShellWord(driver);
    }
    choice_.times = !no_times_;
    choice_.first_device_only = devices_.patterns.empty();
    ETALON_TRY(devices, devices_.Choice());
    choice_.devices = devices;
    return MakeChart(choice_, std::cerr);
}

int ChartCommand::Run() {
    if (list_) {
        return List();
    }
    const Result<ChartRecord> chart = Make();
    if (!chart) {
        return Complain(chart.error().message);
    }
    std::cout << (json_ ? ChartJson(*chart) : ChartText(*chart, scenes_));
    if (auto added = report_.Add(ReportSection::kCharts, chart->family,
                                 [&chart] { return ChartJson(*chart); });
        !added) {
        return Complain(added.error().message);
    }
    const bool has_failed = std::any_of(chart->points.begin(), chart->points.end(),
                                        [](const ChartPoint& point) { return point.failed; });
    return has_failed ? kVerdict : 0;
}

}  // namespace

std::unique_ptr<Command> AddChart(CLI::App& app) {
    return std::make_unique<ChartCommand>(app);
}

}  // namespace etalon
