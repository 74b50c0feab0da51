// The options --report and --svg, and what they ask for.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

#include "base/result.h"
#include "report/html.h"

namespace etalon {

class ReportOption {
  public:
    void AddTo(CLI::App& word);

    // Before the work: fails where its result could not be reported. Does nothing where no report
    // was asked for, and so does Add.
    Status<> Check() const;

    // Adds what the command found to the report (see AddToReport), and draws its pictures where
    // they were asked for. `json` is called only then.
    Status<> Add(ReportSection section, const std::string& key,
                 const std::function<std::string()>& json) const;

  private:
    std::string folder_;
    bool has_pictures_ = false;
};

}  // namespace etalon
