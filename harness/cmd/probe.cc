#include "run/probe.h"

#include <iostream>

#include "cmd/command.h"
#include "cmd/options.h"

namespace etalon {
namespace {

class ProbeCommand : public Command {
  public:
    explicit ProbeCommand(CLI::App& app);

    int Run() override;

  private:
    ProbeChoice choice_;
    DeviceOptions devices_;
};

ProbeCommand::ProbeCommand(CLI::App& app)
    : Command(app.add_subcommand("probe", "Call a function now")) {
    word_->add_option("SOURCE", choice_.source, "GLSL source file")->required();
    word_->add_option("CALL", choice_.call, "GLSL expression over the inputs: 'f(v, n, 1.5)'")
        ->required();
    CLI::Option* inputs =
        word_
            ->add_option("--inputs", choice_.inputs,
                         "CSV; its header reads name:type, vectors v.x:float,v.y:float")
            ->type_name("F.csv");
    word_
        ->add_option("--at", choice_.at,
                     "one row of inputs instead: 'n1=1,steps:int=3,v.x=0,v.y=1'")
        ->excludes(inputs);
    word_
        ->add_option("--in", choice_.in,
                     "type of an input that is no scalar or vector: m:mat3, hit:Hit")
        ->type_name("NAME:TYPE")
        ->allow_extra_args(false);
    word_
        ->add_option("--out", choice_.out,
                     "declares an out parameter (inout, if it is an input too)")
        ->type_name("NAME:TYPE")
        ->allow_extra_args(false);
    word_->add_option("-D", choice_.defines, "defines a macro")
        ->type_name("NAME=VALUE")
        ->allow_extra_args(false);
    word_->add_option("--include", choice_.include, "adds a folder for #include")
        ->type_name("DIR")
        ->allow_extra_args(false);
    word_
        ->add_option("--with", choice_.with,
                     "adds a source that defines scene functions, or an image for a sampler2D: "
                     "height=map.png")
        ->type_name("FILE")
        ->allow_extra_args(false);
    word_
        ->add_option(
            "--image", choice_.images,
            "an image for a sampler, as in a case: 'height={ expr = \"sin(2*pi*u)\", size = "
            "[64, 64] }'")
        ->type_name("NAME={ ... }")
        ->allow_extra_args(false);
    word_
        ->add_option("--recipe", choice_.recipes,
                     "recipe (plain, spirv+O, glsl+baked, ...); repeatable")
        ->allow_extra_args(false);
    word_->add_flag("--csv", choice_.csv, "CSV instead of a table");
    devices_.AddTo(*word_);
}

int ProbeCommand::Run() {
    Result<DeviceChoice> devices = devices_.Choice();
    if (!devices) {
        return Complain(devices.error().message);
    }
    choice_.devices = *devices;
    const Result<int> status = RunProbe(choice_, std::cout, std::cerr);
    return status ? *status : Complain(status.error().message);
}

}  // namespace

std::unique_ptr<Command> AddProbe(CLI::App& app) {
    return std::make_unique<ProbeCommand>(app);
}

}  // namespace etalon
