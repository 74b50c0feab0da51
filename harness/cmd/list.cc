#include <iostream>

#include "cmd/command.h"
#include "cmd/options.h"
#include "run/case_choice.h"

namespace etalon {
namespace {

class ListCommand : public Command {
  public:
    explicit ListCommand(CLI::App& app) : Command(app.add_subcommand("list", "Cases, by path")) {
        word_->add_option("PATTERN", patterns_, "prefix of case paths, or a pattern with * and ?");
        AddRoot(*word_, root_);
    }

    int Run() override {
        Result<std::filesystem::path> folder = RootOf(root_);
        if (!folder) {
            return Complain(folder.error().message);
        }
        Result<std::vector<std::string>> paths = ChooseCases(*folder, patterns_);
        if (!paths) {
            return Complain(paths.error().message);
        }
        for (const std::string& path : *paths) {
            std::cout << path << "\n";
        }
        return 0;
    }

  private:
    std::string root_;
    std::vector<std::string> patterns_;
};

}  // namespace

std::unique_ptr<Command> AddList(CLI::App& app) {
    return std::make_unique<ListCommand>(app);
}

}  // namespace etalon
