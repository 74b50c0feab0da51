#include "run/listener.h"

#include <iostream>
#include <set>

#include "base/format.h"
#include "base/progress.h"
#include "report/text.h"

namespace etalon {
namespace {

class Listener : public ::testing::EmptyTestEventListener {
  public:
    Listener(const std::vector<Record>& records, bool verbose, int total)
        : records_(records), verbose_(verbose), progress_(total) {}

    void OnTestEnd(const ::testing::TestInfo& test) override {
        if (test.result()->Failed()) {
            progress_.Clear();
            std::cout << Told(records_.back()) << "\n" << std::flush;
        }
        const std::string name = std::string(test.test_suite_name()) + "." + test.name();
        if (verbose_) {
            std::cout << (!records_.back().known_cause.empty() ? "known "
                          : test.result()->Failed()            ? "fail "
                          : test.result()->Skipped()           ? "skip "
                                                               : "pass ")
                      << name << format(" ({:.0f} ms)", 1000 * records_.back().seconds)
                      << (records_.back().figures.empty() ? "" : " ")
                      << FiguresText(records_.back()) << (records_.back().parts.empty() ? "" : " ")
                      << PartsText(records_.back()) << "\n";
        }
        progress_.Step(name);
    }
    void OnTestProgramEnd(const ::testing::UnitTest&) override { progress_.Clear(); }

  private:
    // The whole failure, or one line where the case has failed alike on another device: same input,
    // same value.
    std::string Told(const Record& record) {
        if (const Observation* shown = record.Shown()) {
            std::string same = record.case_path + shown->output + shown->actual.hex;
            for (const auto& [name, value] : shown->inputs) {
                same += name + value.hex;
            }
            if (!told_.insert(same).second) {
                return format("{} on {} ({}): {}, with the same input and value", record.case_path,
                              record.device, record.recipe, VerdictName(record.verdict));
            }
        }
        return FailureText(record);
    }

    const std::vector<Record>& records_;
    bool verbose_;
    Progress progress_;
    std::set<std::string> told_;
};

}  // namespace

std::unique_ptr<::testing::TestEventListener> MakeListener(const std::vector<Record>& records,
                                                           bool verbose, int total) {
    return std::make_unique<Listener>(records, verbose, total);
}

}  // namespace etalon
