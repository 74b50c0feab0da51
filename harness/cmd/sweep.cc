#include "run/sweep.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <thread>

#include "base/file.h"
#include "cmd/command.h"
#include "cmd/options.h"
#include "cmd/report_option.h"

namespace etalon {
namespace {

// "2/8"
Result<SweepShard> ReadShard(const std::string& text) {
    SweepShard shard;
    const char* const end = text.data() + text.size();
    const auto index = std::from_chars(text.data(), end, shard.index);
    if (index.ec == std::errc() && index.ptr != end && *index.ptr == '/') {
        const auto count = std::from_chars(index.ptr + 1, end, shard.count);
        if (count.ec == std::errc() && count.ptr == end && shard.index >= 1 &&
            shard.index <= shard.count && shard.count <= 1'000'000) {
            return shard;
        }
    }
    return Error{"--shard '" + text + "': it reads I/N, 1/4 to 4/4"};
}

class SweepCommand : public Command {
  public:
    explicit SweepCommand(CLI::App& app);

    int Run() override;

  private:
    Result<SweepRecord> Find();

    SweepChoice choice_;
    std::string root_;
    std::string shard_;
    bool exhaustive_ = false;
    bool json_ = false;
    std::vector<std::string> merged_;
    DeviceOptions devices_;
    ReportOption report_;
};

SweepCommand::SweepCommand(CLI::App& app)
    : Command(app.add_subcommand(
          "sweep",
          "Every float of one input of a case, judged on one device; a journal lets it go "
          "on after it was ended")) {
    CLI::Option* const pattern =
        word_->add_option("CASE", choice_.pattern, "a case's path, or a pattern that names one");
    word_->add_flag("--exhaustive", exhaustive_, "take every float of the range; must be said");
    word_
        ->add_option("--over", choice_.scope.over,
                     "the input to sweep; default: the only float that has a range")
        ->type_name("NAME");
    word_->add_option("--from", choice_.scope.from, "first float; default: the range's")
        ->type_name("A");
    word_->add_option("--to", choice_.scope.to, "last float; default: the range's")->type_name("B");
    word_->add_option("--at", choice_.scope.at,
                      "other inputs: 'n1=1,n2=0x1.8p+0'; default: all that the case gives them");
    word_
        ->add_option("--grid", choice_.scope.grid,
                     "values of each other input that has a range in the case")
        ->capture_default_str()
        ->check(Within(1, 4096))
        ->type_name("N");
    word_->add_option("--recipe", choice_.recipe, "recipe; default: the device's own");
    word_
        ->add_option("--journal", choice_.journal,
                     "where to keep what is done, /dev/null for nowhere; default: in the current "
                     "folder, by the names of "
                     "case, device and recipe")
        ->type_name("FILE");
    word_->add_option("--shard", shard_, "only the I-th of N parts: 1/4 to 4/4")->type_name("I/N");
    CLI::Option* const merge =
        word_
            ->add_option("--merge", merged_,
                         "print what the journals of all shards say together, and sweep nothing")
            ->type_name("JOURNAL...")
            ->excludes(pattern);
    choice_.jobs = std::max(1u, std::thread::hardware_concurrency());
    word_->add_option("-j,--jobs", choice_.jobs, "threads that check results")
        ->capture_default_str()
        ->check(Within(1, 1024))
        ->type_name("N");
    word_->add_flag("--json", json_, "as JSON");
    report_.AddTo(*word_);
    AddRoot(*word_, root_);
    devices_.AddTo(*word_, "none, one must be named");
    pattern->excludes(merge);
}

Result<SweepRecord> SweepCommand::Find() {
    ETALON_TRY_STEP(report_.Check());
    if (!merged_.empty()) {
        return MergeSweeps({merged_.begin(), merged_.end()});
    }
    if (choice_.pattern.empty()) {
        return Error{"sweep: no case is named; --help tells more"};
    }
    if (!exhaustive_) {
        return Error{"sweep: --exhaustive must be said: it takes every float of the range"};
    }
    if (!shard_.empty()) {
        ETALON_TRY(shard, ReadShard(shard_));
        choice_.shard = shard;
    }
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
    return RunSweep(choice_, std::cerr);
}

int SweepCommand::Run() {
    Result<SweepRecord> record = Find();
    if (!record) {
        return Complain(record.error().message);
    }
    std::cout << (json_ ? SweepJson(*record) : SweepText(*record));
    if (auto added = report_.Add(ReportSection::kSweeps, SweepKey(*record),
                                 [&record] { return SweepJson(*record); });
        !added) {
        return Complain(added.error().message);
    }
    return record->verdict == Verdict::kPass ? 0 : kVerdict;
}

}  // namespace

std::unique_ptr<Command> AddSweep(CLI::App& app) {
    return std::make_unique<SweepCommand>(app);
}

}  // namespace etalon
