#include <iostream>

#include "cmd/command.h"
#include "cmd/options.h"
#include "report/json.h"
#include "report/text.h"

namespace etalon {
namespace {

class DevicesCommand : public Command {
  public:
    explicit DevicesCommand(CLI::App& app)
        : Command(
              app.add_subcommand("devices", "What can run here: versions, features, fingerprint")) {
        devices_.AddTo(*word_);
        word_->add_flag("--json", json_, "as JSON");
        word_->add_flag("--all", all_, "also tell what was tried and is not here");
    }

    int Run() override {
        Result<DeviceChoice> choice = devices_.Choice();
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
        std::cout << (json_ ? DevicesJson(record) : DevicesText(record, all_));
        return 0;
    }

  private:
    DeviceOptions devices_;
    bool json_ = false;
    bool all_ = false;
};

}  // namespace

std::unique_ptr<Command> AddDevices(CLI::App& app) {
    return std::make_unique<DevicesCommand>(app);
}

}  // namespace etalon
