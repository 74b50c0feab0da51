// GoogleTest's own report (--gtest_output), written so that a full disk is noticed.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"

namespace etalon {

// GoogleTest ignores what goes wrong while it writes. It is given a file in memory instead of the
// one asked for, by flag or by the variable GTEST_OUTPUT; Write then writes the real one. A folder
// is left to GoogleTest, which names the files.
class GtestReport {
  public:
    // Changes `arguments`; to be called before they reach GoogleTest.
    explicit GtestReport(std::vector<std::string>& arguments);
    ~GtestReport();
    GtestReport(const GtestReport&) = delete;
    GtestReport& operator=(const GtestReport&) = delete;

    // To be called after the tests. Nothing where no report was asked for.
    Status<> Write() const;

  private:
    std::string path_;  // as asked for; empty where there is nothing to do
    int memory_ = -1;
};

}  // namespace etalon
