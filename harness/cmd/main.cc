// The program `etalon`: words of the command line, nothing else.

#include <pthread.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>

#include "base/check.h"
#include "cmd/command.h"
#include "cmd/options.h"
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
    const std::vector<std::string> gtest_arguments = TakeGoogleTestFlags(arguments);
    std::vector<std::unique_ptr<Command>> commands;
    commands.push_back(AddDevices(app));
    commands.push_back(AddList(app));
    commands.push_back(AddRun(app, gtest_arguments));
    commands.push_back(AddExplain(app));
    commands.push_back(AddSweep(app));
    commands.push_back(AddChart(app));
    commands.push_back(AddMap(app));
    commands.push_back(AddProbe(app));
    commands.push_back(AddBake(app));
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
    if (!gtest_arguments.empty() && !app.got_subcommand("run")) {
        return Complain("'" + gtest_arguments.front() + "' is for `etalon run`");
    }
    const auto chosen =
        std::find_if(commands.begin(), commands.end(),
                     [](const std::unique_ptr<Command>& command) { return command->IsChosen(); });
    ETALON_CHECK(chosen != commands.end());
    return (*chosen)->Run();
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
