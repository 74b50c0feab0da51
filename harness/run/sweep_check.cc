#include "run/sweep_check.h"

#include <algorithm>
#include <atomic>
#include <future>

#include "numeric/ulp.h"
#include "run/truths.h"

namespace etalon {
namespace {

// Rows whose truths and results stay in the nearest cache.
constexpr std::size_t kBatch = 2048;
// Batches that a thread takes at once.
constexpr std::size_t kBatches = 16;

bool HasSubnormal(std::int64_t first, std::size_t rows) {
    // The subnormals are the 2^23 - 1 floats next to each zero.
    constexpr std::int64_t kSubnormals = (std::int64_t{1} << 23) - 1;
    const std::int64_t last = first + static_cast<std::int64_t>(rows) - 1;
    return (first <= kSubnormals && last >= 1) || (first <= -2 && last >= -1 - kSubnormals);
}

// The same summary of rows that are counted from `first` on.
Summary Moved(Summary summary, std::uint64_t first) {
    for (std::uint64_t* index :
         {&summary.first_refused, &summary.worst_ulp_at, &summary.worst_used_at}) {
        *index += *index == Summary::kNone ? 0 : first;
    }
    return summary;
}

// One thread's work on a block.
class Check {
  public:
    Check(const SweepPlan& plan, const SweepBlock& block, std::span<const std::uint32_t> words)
        : plan_(plan), block_(block), words_(words) {
        const Table& settings = plan.settings;
        for (std::size_t c = 0; c < settings.columns.size(); ++c) {
            const std::uint32_t word = settings.At(block.setting, c);
            const Scalar scalar = settings.columns[c].scalar;
            numbers_.emplace_back(kBatch, WordValue(scalar, word));
            has_subnormal_ = has_subnormal_ ||
                             (c != plan.swept && scalar == Scalar::kFloat && IsSubnormal(word));
        }
        for (const std::vector<double>& column : numbers_) {
            pointers_.push_back(column.data());
        }
        for (const SweepPlan::Oracle& oracle : plan.oracles) {
            found_.resize(found_.size() + oracle.outputs.size());
        }
    }

    void Run(std::size_t first, std::size_t rows) {
        floats_.resize(rows);
        FillFloats(block_.first_float + static_cast<std::int64_t>(first), floats_);
        for (std::size_t row = 0; row < rows; ++row) {
            numbers_[plan_.swept][row] = FromBits(floats_[row]);
        }
        const bool flushed =
            has_subnormal_ ||
            HasSubnormal(block_.first_float + static_cast<std::int64_t>(first), rows);
        std::size_t output = 0;
        for (const SweepPlan::Oracle& oracle : plan_.oracles) {
            const bool is_plain =
                !flushed && oracle.expression.IsFast() &&
                std::all_of(oracle.outputs.begin(), oracle.outputs.end(),
                            [](const auto& column) { return column.scalar == Scalar::kFloat; });
            if (is_plain) {
                JudgeFast(oracle, first, rows, &found_[output]);
            } else {
                JudgeSlowly(oracle, first, rows, &found_[output]);
            }
            output += oracle.outputs.size();
        }
    }

    // The value at one row, judged by itself.
    SweptValue Look(std::size_t oracle, std::size_t component, std::uint64_t row) {
        floats_.resize(1);
        FillFloats(block_.first_float + static_cast<std::int64_t>(row), floats_);
        const Table table = BatchTable();
        const JudgedColumn& output = plan_.oracles[oracle].outputs[component];
        const Truth truth = TruthsOf(plan_.oracles[oracle].expression, table)[component];
        SweptValue value;
        value.row = block_.first_row + row;
        value.inputs = table.words;
        value.actual = words_[output.column * block_.rows + row];
        value.expected = truth.values[0];
        value.judgement = JudgeValue(output.accept, output.scalar, value.actual, truth, 0);
        return value;
    }

    std::vector<SweptColumn>& found() { return found_; }

  private:
    std::span<const std::uint32_t> Results(const JudgedColumn& output, std::size_t first,
                                           std::size_t rows) const {
        return words_.subspan(output.column * block_.rows + first, rows);
    }

    void JudgeFast(const SweepPlan::Oracle& oracle, std::size_t first, std::size_t rows,
                   SweptColumn* found) {
        oracle.expression.EvaluateFast(pointers_, rows, truths_);
        values_.resize(rows);
        for (std::size_t k = 0; k < oracle.outputs.size(); ++k) {
            const auto words = Results(oracle.outputs[k], first, rows);
            std::transform(words.begin(), words.end(), values_.begin(), FromBits);
            JudgeAll(oracle.outputs[k].accept, values_, std::span(truths_).subspan(k * rows, rows),
                     oracle.expression.relative_bound(), oracle.expression.absolute_bound(),
                     block_.first_row + first, found[k].summary, &found[k].histogram);
        }
    }

    void JudgeSlowly(const SweepPlan::Oracle& oracle, std::size_t first, std::size_t rows,
                     SweptColumn* found) {
        const std::vector<Truth> truths = TruthsOf(oracle.expression, BatchTable());
        for (std::size_t k = 0; k < oracle.outputs.size(); ++k) {
            Summary summary;
            JudgeColumn(oracle.outputs[k].accept, oracle.outputs[k].scalar,
                        Results(oracle.outputs[k], first, rows), truths[k], 0, summary,
                        &found[k].histogram);
            found[k].summary.Add(Moved(summary, block_.first_row + first));
        }
    }

    // The rows of floats_.
    Table BatchTable() const {
        Table table;
        table.variables = plan_.settings.variables;
        table.columns = plan_.settings.columns;
        table.rows = floats_.size();
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            if (c == plan_.swept) {
                table.words.insert(table.words.end(), floats_.begin(), floats_.end());
            } else {
                table.words.insert(table.words.end(), table.rows,
                                   plan_.settings.At(block_.setting, c));
            }
        }
        return table;
    }

    const SweepPlan& plan_;
    const SweepBlock& block_;
    std::span<const std::uint32_t> words_;
    std::vector<std::vector<double>> numbers_;  // inputs by columns, kBatch rows each
    std::vector<const double*> pointers_;
    bool has_subnormal_ = false;
    std::vector<std::uint32_t> floats_;
    std::vector<float> values_;
    std::vector<double> truths_;
    std::vector<SweptColumn> found_;
};

}  // namespace

void FillFloats(std::int64_t first, std::span<std::uint32_t> words) {
    for (std::size_t row = 0; row < words.size(); ++row) {
        words[row] = ToBits(FromOrderedBits(first + static_cast<std::int64_t>(row)));
    }
}

std::vector<SweptColumn> CheckBlock(const SweepPlan& plan, const SweepBlock& block,
                                    std::span<const std::uint32_t> words, unsigned threads) {
    constexpr std::size_t kStep = kBatch * kBatches;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        Check check(plan, block, words);
        for (;;) {
            const std::size_t begin = next.fetch_add(kStep);
            const std::size_t end = std::min<std::size_t>(begin + kStep, block.rows);
            for (std::size_t first = begin; first < end; first += kBatch) {
                check.Run(first, std::min(kBatch, end - first));
            }
            if (end == block.rows) {
                return std::move(check.found());
            }
        }
    };
    std::vector<std::future<std::vector<SweptColumn>>> others;
    for (unsigned k = 1; k < threads; ++k) {
        others.push_back(std::async(std::launch::async, work));
    }
    std::vector<SweptColumn> found = work();
    for (auto& other : others) {
        const std::vector<SweptColumn> part = other.get();
        for (std::size_t k = 0; k < found.size(); ++k) {
            found[k].Add(part[k]);
        }
    }
    Check check(plan, block, words);
    std::size_t output = 0;
    for (std::size_t oracle = 0; oracle < plan.oracles.size(); ++oracle) {
        for (std::size_t k = 0; k < plan.oracles[oracle].outputs.size(); ++k, ++output) {
            SweptColumn& column = found[output];
            const auto look = [&](std::uint64_t row, std::optional<SweptValue>& value) {
                if (row != Summary::kNone) {
                    value = check.Look(oracle, k, row - block.first_row);
                }
            };
            look(column.summary.worst_ulp_at, column.worst_ulp);
            look(column.summary.worst_used_at, column.worst_used);
            look(column.summary.first_refused, column.first_refused);
            // A journal keeps these and not the summary's, and must yield the same comparisons.
            if (column.worst_ulp) {
                column.summary.worst_ulp_error = column.worst_ulp->judgement.ulp_error;
            }
            if (column.worst_used) {
                column.summary.worst_used = column.worst_used->judgement.used;
            }
        }
    }
    return found;
}

}  // namespace etalon
