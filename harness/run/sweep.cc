#include "run/sweep.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <future>
#include <optional>
#include <ostream>

#include "base/file.h"
#include "base/file_lock.h"
#include "base/format.h"
#include "base/hash.h"
#include "base/progress.h"
#include "case/case.h"
#include "numeric/ulp.h"
#include "run/case_choice.h"
#include "run/case_run.h"
#include "run/fit.h"
#include "run/sweep_check.h"

namespace etalon {
namespace {

using Clock = std::chrono::steady_clock;

// Large, so that handing over costs nothing; what a kill may cost is one of these.
constexpr std::uint64_t kBlockRows = 1u << 20;
constexpr std::uint64_t kSlowBlockRows = 1u << 16;

double Seconds(Clock::duration time) {
    return std::chrono::duration<double>(time).count();
}

// Everything that decides what a row's result and its judgement are.
std::string ContentOf(const SweepPlan& plan, const Program& program) {
    Hash hash;
    hash.Add(program.glsl);
    hash.Add(program.spirv);
    for (const BoundImage& image : program.images) {
        hash.Add(image.name);
        const std::uint32_t shape[] = {image.image->width,
                                       image.image->height,
                                       image.image->levels,
                                       static_cast<std::uint32_t>(image.image->shape),
                                       static_cast<std::uint32_t>(image.sampling.filter),
                                       static_cast<std::uint32_t>(image.sampling.wrap)};
        hash.Add(shape);
        for (const float value : image.image->rgba) {
            const std::uint32_t word = ToBits(value);
            hash.Add({&word, 1});
        }
    }
    for (const SweepPlan::Oracle& oracle : plan.oracles) {
        hash.Add(oracle.expression.text());
        hash.Add("|");
    }
    hash.Add(plan.settings.words);
    return format("{:016x}", hash.value());
}

SweepHeader HeaderOf(const Case& source, const SweepPlan& plan, const Program& program,
                     const DeviceInfo& device, const Recipe& recipe, const std::string& options) {
    SweepHeader header;
    header.version = ETALON_VERSION;
    header.case_path = source.path;
    header.content = ContentOf(plan, program);
    header.device = device.name;
    header.driver = device.description + ", " + device.driver + " " + device.version;
    header.fingerprint = Fingerprint(device);
    header.recipe = RecipeText(recipe);
    header.options = options;
    header.columns = plan.settings.columns;
    header.swept = plan.swept;
    header.from = plan.from;
    header.to = plan.to;
    header.fixed = plan.fixed;
    header.settings = plan.settings.rows;
    header.block_rows = device.slow ? kSlowBlockRows : kBlockRows;
    header.laws = source.laws.size();
    for (const SweepPlan::Oracle& oracle : plan.oracles) {
        for (const JudgedColumn& output : oracle.outputs) {
            header.outputs.push_back(
                {output.name, output.scalar,
                 output.scalar == Scalar::kFloat ? output.accept.Text() : "equal"});
        }
    }
    // A line each in the journal.
    for (std::string* text : {&header.driver, &header.options, &header.case_path}) {
        std::replace(text->begin(), text->end(), '\n', ' ');
    }
    return header;
}

std::filesystem::path JournalPath(const SweepHeader& header, SweepShard shard) {
    std::string name = "sweep-" + header.case_path + "-" + header.device + "-" + header.recipe;
    std::replace_if(
        name.begin(), name.end(),
        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_'; }, '-');
    if (shard.count > 1) {
        name += format("-{}of{}", shard.index, shard.count);
    }
    return name + ".journal";
}

// That of the file, where there is one, else a new one.
Result<SweepJournal> OpenJournal(const std::filesystem::path& path, const SweepHeader& header,
                                 SweepShard shard) {
    ETALON_TRY(fresh, NewJournal(header, shard));
    const auto status = std::filesystem::status(path);
    if (!std::filesystem::exists(status) || std::filesystem::is_character_file(status)) {
        return std::move(fresh);
    }
    ETALON_TRY(journal, ReadJournal(path));
    std::string why = Difference(journal.header, header);
    if (why.empty() && (journal.first != fresh.first || journal.end != fresh.end)) {
        why = format("'shard' is '{}/{}', not '{}/{}'", journal.shard.index, journal.shard.count,
                     shard.index, shard.count);
    }
    if (!why.empty()) {
        return Error{path.string() + ": is the journal of another sweep: " + why +
                     "; remove it, or name another file by --journal"};
    }
    return std::move(journal);
}

class Sweep {
  public:
    Sweep(const SweepPlan& plan, Runner& runner, Recipe recipe, unsigned jobs,
          std::filesystem::path path, std::ostream& notes)
        : plan_(plan),
          runner_(runner),
          recipe_(recipe),
          jobs_(jobs),
          path_(std::move(path)),
          notes_(notes) {}

    Result<SweepRecord> Run(SweepJournal journal) {
        journal_ = std::move(journal);
        const SweepHeader& header = journal_.header;
        // A place where nothing can be written is told before the work and not after.
        ETALON_TRY_STEP(WriteFile(path_, JournalText(journal_)));
        std::optional<EvaluationFailure> failure;
        std::uint64_t failed = 0;
        Progress progress(static_cast<std::int64_t>(journal_.end - journal_.next));
        const Clock::time_point start = Clock::now();
        const std::uint64_t start_row = header.FirstRow(journal_.next);
        for (std::uint64_t block = journal_.next; block < journal_.end && !failure; ++block) {
            Work& work = work_[block % 2];
            Prepare(block, work);
            auto evaluated = Evaluate(work);
            if (auto finished = Finish(); !finished) {
                progress.Clear();
                return finished.error();
            }
            if (!evaluated) {
                failure = evaluated.error();
                failed = block;
                break;
            }
            checked_ = std::async(std::launch::async, [this, &work] {
                return CheckBlock(plan_, work.block, work.results, jobs_);
            });
            const double seconds = Seconds(Clock::now() - start);
            progress.Step(format(
                "{:.1f} million rows a second",
                static_cast<double>(header.FirstRow(block + 1) - start_row) / seconds / 1e6));
        }
        const Status<> finished = Finish();
        progress.Clear();
        if (!finished) {
            return finished.error();
        }
        const double seconds = Seconds(Clock::now() - start);
        const std::uint64_t rows = header.FirstRow(journal_.next) - start_row;
        if (rows > 0) {
            notes_ << format(
                "{} rows in {:.1f} s, {:.1f} million a second; the device waited for the checker "
                "{:.1f} % of the time\n",
                rows, seconds, static_cast<double>(rows) / seconds / 1e6,
                100 * Seconds(waited_) / seconds);
        }
        SweepRecord record = RecordOf(journal_);
        if (failure) {
            if (failure->kind == EvaluationFailure::Kind::kInput ||
                failure->kind == EvaluationFailure::Kind::kUnsupported) {
                return Error{record.device + " (" + record.recipe + "): " + failure->reason};
            }
            record.verdict = VerdictOf(*failure);
            const bool is_anywhere = failure->kind == EvaluationFailure::Kind::kRejected;
            record.reason = failure->reason + (is_anywhere ? "" : Where(failed));
        }
        return record;
    }

  private:
    struct Work {
        SweepBlock block;
        std::vector<std::uint32_t> inputs;
        std::vector<std::uint32_t> results;
    };

    void Prepare(std::uint64_t index, Work& work) const {
        const SweepHeader& header = journal_.header;
        SweepBlock& block = work.block;
        block.setting = index / header.BlocksPerSetting();
        block.first_row = header.FirstRow(index);
        block.rows = static_cast<std::uint32_t>(header.FirstRow(index + 1) - block.first_row);
        block.first_float =
            OrderedBits(FromBits(header.from)) +
            static_cast<std::int64_t>(block.first_row - block.setting * header.Floats());
        const Table& settings = plan_.settings;
        work.inputs.resize(settings.columns.size() * block.rows);
        for (std::size_t c = 0; c < settings.columns.size(); ++c) {
            const auto column = std::span(work.inputs).subspan(c * block.rows, block.rows);
            if (c == plan_.swept) {
                FillFloats(block.first_float, column);
            } else {
                std::fill(column.begin(), column.end(), settings.At(block.setting, c));
            }
        }
    }

    Result<Nothing, EvaluationFailure> Evaluate(Work& work) {
        const std::size_t outputs = plan_.signature.OutputWords(plan_.call);
        const std::uint32_t all = work.block.rows;
        work.results.resize(outputs * all);
        auto evaluated = runner_.Evaluate(
            plan_.call, plan_.signature, recipe_, {work.inputs, all, plan_.settings.columns.size()},
            [&](std::uint64_t first, std::uint32_t rows, std::span<const std::uint32_t> words) {
                for (std::size_t c = 0; c < outputs; ++c) {
                    const auto from = words.subspan(c * rows, rows);
                    std::copy(from.begin(), from.end(),
                              work.results.begin() + static_cast<std::ptrdiff_t>(c * all + first));
                }
            });
        if (evaluated && !runner_.flake().empty()) {
            notes_ << runner_.info().name << " (" << RecipeText(recipe_)
                   << ") failed once and not again: " << runner_.flake() << "\n";
        }
        return evaluated;
    }

    // Waits for the check that is under way and writes down what it found.
    Status<> Finish() {
        if (!checked_.valid()) {
            return Ok();
        }
        const Clock::time_point start = Clock::now();
        const std::vector<SweptColumn> found = checked_.get();
        waited_ += Clock::now() - start;
        for (std::size_t k = 0; k < found.size(); ++k) {
            journal_.found[k].Add(found[k]);
        }
        ++journal_.next;
        return WriteFile(path_, JournalText(journal_));
    }

    std::string Where(std::uint64_t block) const {
        const std::uint32_t rows = static_cast<std::uint32_t>(journal_.header.FirstRow(block + 1) -
                                                              journal_.header.FirstRow(block));
        const std::int64_t first = work_[block % 2].block.first_float;
        const auto text = [&](std::int64_t at) { return HexFloat(FromOrderedBits(at)); };
        std::string where =
            format("; at {} from {} to {}", plan_.settings.columns[plan_.swept].name, text(first),
                   text(first + rows - 1));
        for (std::size_t c = 0; c < plan_.settings.columns.size(); ++c) {
            const Column& column = plan_.settings.columns[c];
            const std::uint32_t word = plan_.settings.At(work_[block % 2].block.setting, c);
            if (c != plan_.swept) {
                where += ", " + column.name + "=" + ExactText(column.scalar, word);
            }
        }
        return where;
    }

    const SweepPlan& plan_;
    Runner& runner_;
    Recipe recipe_;
    unsigned jobs_;
    std::filesystem::path path_;
    std::ostream& notes_;
    SweepJournal journal_;
    Work work_[2];  // one at the device, one that is checked
    std::future<std::vector<SweptColumn>> checked_;
    Clock::duration waited_ = {};
};

Result<std::unique_ptr<Runner>> OpenOne(const SweepChoice& choice,
                                        std::shared_ptr<Programs>& programs) {
    if (choice.devices.patterns.empty()) {
        return Error{"a sweep runs on one device: --device NAME says on which"};
    }
    ETALON_TRY(devices, OpenDevices(choice.devices));
    if (devices.runners.size() != 1) {
        std::string names;
        for (const auto& runner : devices.runners) {
            names += (names.empty() ? "" : ", ") + runner->info().name;
        }
        return Error{"a sweep runs on one device, and --device names " + names};
    }
    programs = devices.programs;
    return std::move(devices.runners.front());
}

}  // namespace

Result<SweepRecord> RunSweep(const SweepChoice& choice, std::ostream& notes) {
    ETALON_TRY(name, ChooseOneCase(choice.root, choice.pattern, "swept"));
    ETALON_TRY(source, ReadCase(choice.root, name));
    std::optional<Recipe> wanted;
    if (!choice.recipe.empty()) {
        ETALON_TRY(recipe, ParseRecipe(choice.recipe));
        if (recipe.baked) {
            return Error{"--recipe " + choice.recipe + ": a sweep's inputs cannot be constants"};
        }
        wanted = recipe;
    }
    // What is wrong with the scope is told before a device is opened.
    ETALON_TRY(plan, PlanSweep(source, choice.scope));
    std::shared_ptr<Programs> programs;
    ETALON_TRY(runner, OpenOne(choice, programs));
    const DeviceInfo& device = runner->info();
    Recipe recipe = wanted.value_or(DefaultRecipe(device));
    if (plan.signature.stage == Stage::kFragment) {
        recipe.stage = Stage::kFragment;
    }
    ETALON_TRY(fitted, FitRecipe(recipe, device));
    const auto& program = programs->Get(plan.call, plan.signature, fitted, TargetOf(device), {});
    if (!program) {
        return Error{device.name + " (" + RecipeText(fitted) + "): " + program.error().reason};
    }
    const SweepHeader header = HeaderOf(source, plan, *program, device, fitted, choice.options);
    const std::filesystem::path path =
        choice.journal.empty() ? JournalPath(header, choice.shard) : choice.journal;
    std::optional<FileLock> lock;
    std::error_code ignored;
    if (!std::filesystem::is_character_file(path, ignored)) {
        ETALON_TRY(taken, FileLock::Beside(path));
        lock.emplace(std::move(taken));
    }
    ETALON_TRY(journal, OpenJournal(path, header, choice.shard));
    if (journal.next > journal.first) {
        notes << format("{}: {} of {} blocks are done\n", path.string(),
                        journal.next - journal.first, journal.end - journal.first);
    }
    return Sweep(plan, *runner, fitted, choice.jobs, path, notes).Run(std::move(journal));
}

Result<SweepRecord> MergeSweeps(const std::vector<std::filesystem::path>& journals) {
    ETALON_TRY(journal, MergeJournals(journals));
    return RecordOf(journal);
}

}  // namespace etalon
