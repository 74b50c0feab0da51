#include "map/map.h"

#include <iostream>

#include "base/file.h"
#include "base/format.h"
#include "cmd/command.h"
#include "cmd/options.h"
#include "cmd/report_option.h"

namespace etalon {
namespace {

class MapCommand : public Command {
  public:
    explicit MapCommand(CLI::App& app);

    int Run() override;

  private:
    Result<MapRecord> Find();
    std::string KeyOf(const MapRecord& map) const;

    MapChoice choice_;
    std::string root_;
    bool json_ = false;
    DeviceOptions devices_;
    ReportOption report_;
};

MapCommand::MapCommand(CLI::App& app)
    : Command(app.add_subcommand(
          "map",
          "A picture of a case over two of its inputs: where it holds, by how much it is off, "
          "where it yields NaN or misses a hit; held against what theory predicts, where the "
          "case's [map] says so")) {
    word_->add_option("CASE", choice_.pattern, "a case's path, or a pattern that names one")
        ->required();
    word_
        ->add_option("--over", choice_.scope.over,
                     "the two inputs, floats or integers; default: those of the case's [map]")
        ->type_name("X,Y");
    word_
        ->add_option("--range", choice_.scope.ranges,
                     "the range of one of them: 'X=1e-6:1:log'; repeatable; default: the map's, "
                     "else the input's own")
        ->allow_extra_args(false)
        ->type_name("NAME=LOW:HIGH[:log]");
    word_->add_option("--at", choice_.scope.at,
                      "other inputs: 'n1=1,n2=0x1.8p+0'; default: the map's, else their first "
                      "value");
    word_
        ->add_option(
            "--size", choice_.scope.size,
            "cells across and upwards, of an integer at most as many; default: the map's, else "
            "96x64")
        ->type_name("WxH");
    word_
        ->add_option("--output", choice_.scope.output,
                     "result.x, an out parameter, or a law's name; default: the worst of all "
                     "outputs, or of all laws where there is no oracle")
        ->type_name("NAME");
    word_->add_option("--recipe", choice_.recipe, "recipe; default: each device's own");
    word_->add_flag("--json", json_, "as JSON");
    report_.AddTo(*word_);
    AddRoot(*word_, root_);
    devices_.AddTo(*word_, "the first found of vulkan:llvmpipe, osmesa:llvmpipe and cpu");
}

Result<MapRecord> MapCommand::Find() {
    ETALON_TRY_STEP(report_.Check());
    ETALON_TRY(root, RootOf(root_));
    choice_.root = root;
    if (!root_.empty()) {
        choice_.options += " --root " + ShellWord(root_);
    }
    for (const std::string& driver : devices_.drivers) {
        choice_.options += " --driver " + ShellWord(driver);
    }
    ETALON_TRY(devices, devices_.Choice());
    choice_.devices = devices;
    return MakeMap(choice_);
}

// What the user says beside the case makes it another map; its size does not.
std::string MapCommand::KeyOf(const MapRecord& map) const {
    std::string key = format("{} over {},{}", map.case_path, map.x.name, map.y.name);
    for (const std::string& range : choice_.scope.ranges) {
        key += " in " + range;
    }
    const auto add = [&key](const char* word, const std::string& value) {
        key += value.empty() ? "" : word + value;
    };
    add(" at ", choice_.scope.at);
    add(" of ", choice_.scope.output);
    return key;
}

int MapCommand::Run() {
    const Result<MapRecord> map = Find();
    if (!map) {
        return Complain(map.error().message);
    }
    std::cout << (json_ ? MapJson(*map) : MapText(*map));
    if (auto added =
            report_.Add(ReportSection::kMaps, KeyOf(*map), [&map] { return MapJson(*map); });
        !added) {
        return Complain(added.error().message);
    }
    if (map->prediction && map->prediction->contradiction) {
        std::cerr << ContradictionText(*map);
    }
    return map->Good() ? 0 : kVerdict;
}

}  // namespace

std::unique_ptr<Command> AddMap(CLI::App& app) {
    return std::make_unique<MapCommand>(app);
}

}  // namespace etalon
