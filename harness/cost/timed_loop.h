// A looped call on a device: how long so many turns take.
#pragma once

#include <cstdint>
#include <vector>

#include "cost/looped_call.h"
#include "run/runner.h"

namespace etalon {

class TimedLoop {
  public:
    // At the rows of the table, each as often as any other, at least `fewest_rows` in all.
    TimedLoop(LoopedCall looped, const Table& table, const Recipe& recipe,
              std::uint64_t fewest_rows);

    struct Run {
        RunTime time;
        std::uint32_t turns = 0;  // that were made, at the row where they were fewest: a device may
                                  // end a loop that it takes for one without end
    };

    // One run of so many turns at all rows.
    Result<Run> Make(Runner& runner, std::uint32_t turns);

    std::uint64_t rows() const { return rows_; }

  private:
    LoopedCall looped_;
    Recipe recipe_;
    std::uint64_t rows_ = 0;
    std::vector<std::uint32_t> words_;  // the last column is the turns
};

}  // namespace etalon
