#include "cost/timed_loop.h"

#include <algorithm>
#include <limits>

namespace etalon {
TimedLoop::TimedLoop(LoopedCall looped, const Table& table, const Recipe& recipe,
                     std::uint64_t fewest_rows)
    : looped_(std::move(looped)), recipe_(recipe) {
    ETALON_CHECK(table.rows > 0);
    const std::uint64_t repeats = (fewest_rows + table.rows - 1) / table.rows;
    rows_ = repeats * table.rows;
    words_.reserve((table.columns.size() + 1) * rows_);
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const auto first = table.words.begin() + static_cast<std::ptrdiff_t>(column * table.rows);
        for (std::uint64_t i = 0; i < repeats; ++i) {
            words_.insert(words_.end(), first, first + static_cast<std::ptrdiff_t>(table.rows));
        }
    }
    words_.resize(words_.size() + rows_);
}

Result<TimedLoop::Run> TimedLoop::Make(Runner& runner, std::uint32_t turns) {
    std::fill(words_.end() - static_cast<std::ptrdiff_t>(rows_), words_.end(), turns);
    Run run;
    run.turns = std::numeric_limits<std::uint32_t>::max();
    const auto evaluated = runner.Evaluate(
        looped_.call, looped_.signature, recipe_, {words_, rows_, words_.size() / rows_},
        [&](std::uint64_t, std::uint32_t rows, std::span<const std::uint32_t> words) {
            const auto done = words.subspan(looped_.done_column * rows, rows);
            run.turns = std::min(run.turns, *std::min_element(done.begin(), done.end()));
        },
        &run.time);
    if (!evaluated) {
        return Error{evaluated.error().reason};
    }
    return run;
}

}  // namespace etalon
