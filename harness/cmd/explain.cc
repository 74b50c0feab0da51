#include "run/explain.h"

#include <algorithm>
#include <iostream>

#include "cmd/command.h"
#include "cmd/options.h"
#include "report/explanation.h"

namespace etalon {
namespace {

class ExplainCommand : public Command {
  public:
    explicit ExplainCommand(CLI::App& app);

    int Run() override;

  private:
    ExplainChoice choice_;
    std::string root_;
    bool json_ = false;
    bool all_ = false;
    DeviceOptions devices_;
};

ExplainCommand::ExplainCommand(CLI::App& app)
    : Command(app.add_subcommand(
          "explain",
          "One input of a case: every device's result and whose fault its error is, then a row for "
          "each operation of the path with its value in binary32, its exact value, the error so "
          "far "
          "in ulp of the exact value, and the amplification: how much larger the relative error of "
          "the result can be than those of the operands (the sum of |x df/dx| / |f| over the "
          "operands x), and the first operation at which each device parts")) {
    word_->add_option("CASE", choice_.pattern, "a case's path, or a pattern that names one")
        ->required();
    word_->add_option("--at", choice_.at,
                      "the input: 'n1=1,n2=0x1.8p+0'; default: the worst that a run of the case "
                      "on these devices finds");
    word_
        ->add_option("--output", choice_.output,
                     "result.x, or an out parameter; default: the first that is judged")
        ->type_name("NAME");
    AddRoot(*word_, root_);
    word_
        ->add_option("--recipe", choice_.recipes,
                     "recipe (plain, spirv+O, glsl+baked, ...); repeatable; default: each "
                     "device's own")
        ->allow_extra_args(false);
    word_->add_flag("--all", all_, "print all operations of a long path");
    word_->add_flag("--json", json_, "as JSON, with all operations");
    devices_.AddTo(*word_);
}

int ExplainCommand::Run() {
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
    const Result<Explanation> explanation = Explain(choice_);
    if (!explanation) {
        return Complain(explanation.error().message);
    }
    std::cout << (json_ ? ExplanationJson(*explanation) : ExplanationText(*explanation, all_));
    const bool is_good =
        std::all_of(explanation->devices.begin(), explanation->devices.end(),
                    [](const ExplainedDevice& device) { return device.record.Good(); });
    return is_good ? 0 : kVerdict;
}

}  // namespace

std::unique_ptr<Command> AddExplain(CLI::App& app) {
    return std::make_unique<ExplainCommand>(app);
}

}  // namespace etalon
