#include "evaluate/count.h"

#include <algorithm>
#include <future>
#include <optional>
#include <thread>

#include "compile/compile.h"
#include "cost/cost.h"
#include "cost/looped_call.h"
#include "cost/scratch_folder.h"
#include "spirv/read.h"

namespace etalon {
namespace {

using evaluate::OperationClass;
using evaluate::Operations;

constexpr std::uint64_t kChunkRows = 1u << 13;

// A loop of one turn, or an empty one, ready to be counted.
class CountedLoop {
  public:
    static Result<CountedLoop> Make(const PreparedCase& subject, const std::filesystem::path& file,
                                    bool empty) {
        ETALON_TRY(looped, LoopCall(subject, file, 1, empty ? 0 : 1));
        Recipe recipe;
        recipe.optimise = Recipe::Optimise::kSpeed;
        const auto program = Compile(looped.call, looped.signature, recipe, Target{}, {});
        if (!program) {
            return Error{program.error().reason};
        }
        ETALON_TRY(module, spirv::ReadModule(program->spirv));
        ETALON_TRY(plan, evaluate::MakePlan(std::move(module)));
        CountedLoop loop;
        loop.plan_ = std::move(plan);
        loop.output_words_ = program->output_words;
        for (const BoundImage& image : program->images) {
            loop.images_.push_back({image.image, image.sampling});
        }
        return loop;
    }

    Result<std::vector<Operations>> Count(std::span<const std::uint32_t> inputs,
                                          std::uint32_t rows) const {
        return evaluate::CountOperations(plan_, images_, rows, inputs, output_words_);
    }

  private:
    CountedLoop() = default;

    std::shared_ptr<const evaluate::Plan> plan_;
    std::vector<evaluate::Texture> images_;
    std::uint32_t output_words_ = 0;
};

std::int64_t Total(const Operations& operations) {
    std::int64_t total = 0;
    for (const std::int64_t count : operations.counts) {
        total += count;
    }
    return total;
}

struct Counted {
    Operations sum;
    std::optional<Operations> worst;
    std::uint64_t worst_row = 0;

    void Add(std::uint64_t row, const Operations& operations) {
        sum += operations;
        if (!worst || Total(operations) > Total(*worst)) {
            worst = operations;
            worst_row = row;
        }
    }

    // Of rows that come after these.
    void Add(const Counted& later) {
        sum += later.sum;
        if (!worst || (later.worst && Total(*later.worst) > Total(*worst))) {
            worst = later.worst;
            worst_row = later.worst_row;
        }
    }
};

class Counter {
  public:
    Counter(const Table& table, CountedLoop full, CountedLoop empty, Operations adding)
        : table_(table), full_(std::move(full)), empty_(std::move(empty)), adding_(adding) {}

    // The rows are shared out among all cores; what is found does not depend on their number.
    Result<Counted> Count() const {
        const std::uint64_t chunks = (table_.rows + kChunkRows - 1) / kChunkRows;
        const std::uint64_t threads =
            std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, chunks);
        std::vector<std::future<Result<Counted>>> shares;
        for (std::uint64_t i = 0; i < threads; ++i) {
            shares.push_back(std::async(std::launch::async, [this, i, threads, chunks] {
                return CountChunks(chunks * i / threads, chunks * (i + 1) / threads);
            }));
        }
        Result<Counted> all = Counted{};
        for (std::future<Result<Counted>>& share : shares) {
            Result<Counted> part = share.get();
            if (all && part) {
                all->Add(*part);
            } else if (all) {
                all = part.error();
            }
        }
        return all;
    }

  private:
    Result<Counted> CountChunks(std::uint64_t begin, std::uint64_t end) const {
        Counted counted;
        for (std::uint64_t chunk = begin; chunk < end; ++chunk) {
            const std::uint64_t first = chunk * kChunkRows;
            const auto rows = static_cast<std::uint32_t>(std::min(kChunkRows, table_.rows - first));
            std::vector<std::uint32_t> inputs;
            inputs.reserve((table_.columns.size() + 1) * rows);
            for (std::size_t column = 0; column < table_.columns.size(); ++column) {
                const auto from = table_.words.begin() +
                                  static_cast<std::ptrdiff_t>(column * table_.rows + first);
                inputs.insert(inputs.end(), from, from + rows);
            }
            inputs.resize(inputs.size() + rows, 1);  // turn
            ETALON_TRY(full, full_.Count(inputs, rows));
            ETALON_TRY(empty, empty_.Count(inputs, rows));
            for (std::uint32_t row = 0; row < rows; ++row) {
                Operations operations = full[row];
                operations -= empty[row];
                operations -= adding_;
                // To add a call's result that is a constant may take less than to add an input.
                for (std::int64_t& count : operations.counts) {
                    count = std::max<std::int64_t>(count, 0);
                }
                counted.Add(first + row, operations);
            }
        }
        return counted;
    }

    const Table& table_;
    CountedLoop full_;
    CountedLoop empty_;
    Operations adding_;
};

// What the loop needs to add up the call's results, beyond what the empty one does: numbers that
// are no floats become some.
Operations ForAdding(const PreparedCase& subject) {
    Operations operations;
    const auto add = [&](const Type& type) {
        for (const Leaf& leaf : Leaves(type)) {
            if (leaf.scalar != Scalar::kFloat) {
                ++operations[leaf.scalar == Scalar::kBool ? OperationClass::kComparison
                                                          : OperationClass::kOther];
            }
        }
    };
    add(subject.signature.wanted.front());
    for (std::size_t i = 0; i < subject.call.arguments.size(); ++i) {
        if (subject.call.arguments[i].is_output) {
            add(subject.signature.arguments[i]);
        }
    }
    return operations;
}

OperationCounts CountsOf(const Operations& operations, double rows) {
    const auto share = [&](OperationClass kind) {
        return static_cast<double>(operations[kind]) / rows;
    };
    return {share(OperationClass::kArithmetic), share(OperationClass::kDivision),
            share(OperationClass::kSpecial),    share(OperationClass::kComparison),
            share(OperationClass::kInteger),    share(OperationClass::kFetch),
            share(OperationClass::kOther)};
}

}  // namespace

Result<CountedCall> CountOperations(const PreparedCase& subject) {
    ETALON_CHECK(subject.table.rows > 0);
    if (subject.signature.stage == Stage::kFragment) {
        return Error{"a fragment shader is not evaluated on the host: its sources use derivatives"};
    }
    ETALON_TRY(folder, ScratchFolder::Make());
    ETALON_TRY(full, CountedLoop::Make(subject, folder.path() / "full.glsl", false));
    ETALON_TRY(empty, CountedLoop::Make(subject, folder.path() / "empty.glsl", true));
    const Counter counter(subject.table, std::move(full), std::move(empty), ForAdding(subject));
    ETALON_TRY(counted, counter.Count());
    return CountedCall{CountsOf(counted.sum, static_cast<double>(subject.table.rows)),
                       CountsOf(*counted.worst, 1), counted.worst_row};
}

}  // namespace etalon
