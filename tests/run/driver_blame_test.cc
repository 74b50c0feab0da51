// Faults put into a probe's SPIR-V: the faulty module plays the driver, and the error budget must
// find it to blame; of the right module it must not.
#include <gmock/gmock.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <map>

#include "compile/compile.h"
#include "device/backends.h"
#include "device/cpu/cpu_device.h"
#include "evaluate/faults.h"
#include "run/blame.h"
#include "run/evaluation.h"
#include "run/prepared_case.h"
#include "support/folder.h"
#include "worker/client.h"

namespace etalon {
namespace {

using Words = std::vector<std::uint32_t>;

// A case, one of its programs, and what the host knows of it.
class Trial {
  public:
    Trial(const std::filesystem::path& root, const std::string& path, const std::string& recipe,
          std::uint64_t most_rows) {
        const Result<Case> read = ReadCase(root, path);
        EXPECT_TRUE(read.ok()) << read.error().message;
        const Result<PreparedCase> all = Prepare(*read);
        EXPECT_TRUE(all.ok()) << all.error().message;
        prepared_ = all->table.rows > most_rows ? Thin(*all, most_rows) : *all;
        const auto compiled =
            Compile(prepared_.call, prepared_.signature, *ParseRecipe(recipe), Target{}, {});
        EXPECT_TRUE(compiled.ok()) << compiled.error().reason;
        program_ = *compiled;
        evaluation_ = std::make_unique<Evaluation>(
            program_,
            Rows{prepared_.table.words, prepared_.table.rows, prepared_.table.columns.size()});
        EXPECT_TRUE(evaluation_->Get().ok()) << evaluation_->Get().error().message;
    }

    const Program& program() const { return program_; }
    std::uint32_t rows() const { return static_cast<std::uint32_t>(prepared_.table.rows); }
    const Words& inputs() const { return prepared_.table.words; }
    const Words& strict() const { return evaluation_->Get()->strict; }

    // The case's judgement of these results and the budget's, as a record has them.
    Record Judge(const Words& results) const {
        Record record;
        Blame blame(*evaluation_, prepared_.table, *evaluate::FindProfile("vulkan-1.3"), record);
        for (const JudgedColumn& column : prepared_.judged) {
            const auto words = std::span(results).subspan(column.column * rows(), rows());
            Summary summary;
            JudgeColumn(column.accept, column.scalar, words, column.truth, 0, summary);
            record.judged += summary.judged;
            record.refused += summary.refused;
            blame.AddColumn(column, words, summary.refused);
        }
        EXPECT_EQ(record.unevaluated, "");
        return record;
    }
    std::size_t ChangedFrom(const Words& right, const Words& results) const {
        std::size_t changed = 0;
        for (std::size_t i = 0; i < right.size(); ++i) {
            const auto is_nan = [](std::uint32_t word) {
                return (word & ~0x80000000u) > kInfinity;
            };
            const bool same = right[i] == results[i] || ((right[i] | results[i]) << 1) == 0 ||
                              (is_nan(right[i]) && is_nan(results[i]));
            changed += same ? 0 : 1;
        }
        return changed;
    }

  private:
    static constexpr std::uint32_t kInfinity = 0x7f800000;

    PreparedCase prepared_;
    Program program_;
    std::unique_ptr<Evaluation> evaluation_;
};

// Nothing where the program is stopped, as where a loop has no end.
Words RunOnCpu(const Program& program, const Trial& trial) {
    const auto device = OpenCpuDevice(Candidate{});
    EXPECT_TRUE(device.ok());
    const auto handle = (*device)->Load(program);
    EXPECT_TRUE(handle.ok()) << handle.error().reason;
    Words out(std::size_t{program.output_words} * trial.rows());
    return (*device)->Run(*handle, trial.rows(), trial.inputs(), out, nullptr).ok() ? out : Words{};
}

bool IsDrivers(const std::string& culprit) {
    return culprit.starts_with("driver");
}

struct Subject {
    const char* path;
    const char* recipe;
    int outside;  // faults that the specification's bound alone must find, at least
};

constexpr Subject kSubjects[] = {{"optics/fresnel/transmittance", "spirv", 20},
                                 {"optics/fresnel/reflectance_sp", "spirv+precise", 45},
                                 {"optics/intensity/refraction", "spirv", 40},
                                 {"optics/snell/refract", "spirv", 28},
                                 {"optics/snell/refract", "spirv+precise", 29},
                                 {"optics/plane/ray_parameter", "spirv+precise", 5},
                                 {"optics/absorption/transmitted_medium", "spirv", 3}};

// Of all faults that the program can have, how many the specification's bound finds. Those that the
// case refuses must be the driver's.
int FindFaults(const Trial& trial) {
    struct Count {
        int places = 0, change = 0, stopped = 0, outside = 0, refused = 0, inside = 0;
    };
    std::map<Fault::Kind, Count> counts;
    for (const Fault& fault : FaultsOf(trial.program().spirv)) {
        Count& count = counts[fault.kind];
        ++count.places;
        Program program = trial.program();
        program.spirv = fault.spirv;
        const Words words = RunOnCpu(program, trial);
        if (words.empty()) {
            ++count.stopped;
            continue;
        }
        if (trial.ChangedFrom(trial.strict(), words) == 0) {
            continue;
        }
        ++count.change;
        const Record faulty = trial.Judge(words);
        count.outside += faulty.outside > 0 ? 1 : 0;
        count.refused += faulty.refused > 0 ? 1 : 0;
        count.inside += faulty.outside == 0 && faulty.refused == 0 ? 1 : 0;
        for (const auto& [culprit, values] : faulty.culprits) {
            EXPECT_TRUE(IsDrivers(culprit))
                << fault.what << ": " << values << " values are blamed on " << culprit;
        }
    }
    int outside = 0;
    for (const auto& [kind, count] : counts) {
        std::cout << std::left << std::setw(32) << NameOf(kind) << count.places << " places, "
                  << count.change << " change results, " << count.stopped
                  << " never end: outside of the specification " << count.outside
                  << ", refused by the case " << count.refused << ", neither " << count.inside
                  << "\n";
        outside += count.outside;
    }
    return outside;
}

class DriverBlame : public testing::TestWithParam<Subject> {};

TEST_P(DriverBlame, FindsEachFaultThatMatters) {
    const Trial trial(".", GetParam().path, GetParam().recipe, 256);
    const Record right = trial.Judge(RunOnCpu(trial.program(), trial));
    ASSERT_EQ(right.refused, 0u) << "a case that fails tells no faults";
    ASSERT_EQ(right.outside, 0u);
    EXPECT_GE(FindFaults(trial), GetParam().outside);
}

INSTANTIATE_TEST_SUITE_P(Programs, DriverBlame, testing::ValuesIn(kSubjects),
                         [](const testing::TestParamInfo<Subject>& subject) {
                             std::string name =
                                 std::string(subject.param.path) + "_" + subject.param.recipe;
                             std::replace_if(
                                 name.begin(), name.end(),
                                 [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                             return name;
                         });

TEST(LoopBlame, FindsADroppedIteration) {
    Folder folder;
    folder.Write("f.glsl",
                 "float f(float x) { float sum = 0.0; float term = 1.0;\n"
                 "  for (int i = 0; i < 8; ++i) { sum += term; term *= x; }\n"
                 "  return sum; }\n");
    folder.Write("cases/c.toml",
                 "source = \"f.glsl\"\ncall = \"f(x)\"\noracle = \"(1 - x^8) / (1 - x)\"\n"
                 "accept = { ulp = 8 }\n[domain]\n"
                 "x = { range = [0.1, 0.9], sample = \"linear\", count = 50 }\n");
    const Trial trial(folder.path(), "c", "spirv", 1000);
    EXPECT_EQ(trial.Judge(RunOnCpu(trial.program(), trial)).refused, 0u);
    int dropped = 0;
    for (const Fault& fault : FaultsOf(trial.program().spirv)) {
        if (fault.kind == Fault::Kind::kIterationDropped) {
            ++dropped;
            Program program = trial.program();
            program.spirv = fault.spirv;
            const Record record = trial.Judge(RunOnCpu(program, trial));
            EXPECT_GT(record.outside, 30u);
            EXPECT_THAT(record.culprits, testing::Contains(testing::Key("driver")));
        }
    }
    EXPECT_EQ(dropped, 1);
    EXPECT_GE(FindFaults(trial), 2);
}

// A product and a sum of one rounding lie between those of two; but where they cancel, they are no
// multiple of the product's ulp.
TEST(FusedBlame, IsTheDrivers) {
    Folder folder;
    folder.Write("f.glsl",
                 "float f(float x, float y) { precise float r = x * x - y * y; return r; }\n");
    folder.Write("cases/c.toml",
                 "source = \"f.glsl\"\ncall = \"f(x, y)\"\noracle = \"0\"\n"
                 "accept = { exact = true }\n[domain]\n"
                 "x = { range = [1.0, 2.0], sample = \"linear\", count = 50 }\n"
                 "y = { expr = \"x\" }\n");
    const Trial trial(folder.path(), "c", "spirv", 1000);
    EXPECT_EQ(trial.Judge(RunOnCpu(trial.program(), trial)).refused, 0u);
    int fused = 0;
    for (const Fault& fault : FaultsOf(trial.program().spirv)) {
        if (fault.kind != Fault::Kind::kFused) {
            continue;
        }
        ++fused;
        Program program = trial.program();
        program.spirv = fault.spirv;
        const Record record = trial.Judge(RunOnCpu(program, trial));
        EXPECT_GT(record.refused, 20u);
        EXPECT_EQ(record.outside, record.refused);
        EXPECT_THAT(record.culprits, testing::ElementsAre(testing::Pair("driver", record.refused)));
    }
    EXPECT_EQ(fused, 2);
}

// A real driver with a faulty compiler: lavapipe, given the faulty module.
class Lavapipe {
  public:
    Lavapipe() {
        for (const Candidate& candidate : Candidates(Driver{})) {
            if (candidate.backend != "vulkan") {
                continue;
            }
            auto client = std::make_unique<Client>("/proc/self/exe", candidate, WorkerLimits{});
            if (!client->Start()) {
                continue;
            }
            if (const auto info = client->Open(); info && info->name == "vulkan:llvmpipe") {
                client_ = std::move(client);
                return;
            }
        }
    }
    bool IsHere() const { return client_ != nullptr; }
    Words Run(const Program& program, const Trial& trial) {
        const auto handle = client_->Load(program);
        EXPECT_TRUE(handle.ok()) << handle.error().reason;
        const auto in = client_->Inputs(trial.rows(), program.input_words, program.output_words);
        std::copy(trial.inputs().begin(), trial.inputs().end(), in.begin());
        const auto out = client_->Run(*handle);
        EXPECT_TRUE(out.ok()) << out.error().reason;
        return out ? Words(out->begin(), out->end()) : Words{};
    }

  private:
    std::unique_ptr<Client> client_;
};

TEST(DriverBlameOfLavapipe, IsThatOfTheEvaluator) {
    Lavapipe lavapipe;
    if (!lavapipe.IsHere()) {
        GTEST_SKIP() << "lavapipe is not here";
    }
    for (const Subject& subject : {kSubjects[0], kSubjects[4]}) {
        const Trial trial(".", subject.path, subject.recipe, 64);
        const Words right = lavapipe.Run(trial.program(), trial);
        EXPECT_EQ(trial.Judge(right).refused, 0u);
        EXPECT_EQ(trial.Judge(right).outside, 0u);
        int found = 0;
        for (const Fault& fault : FaultsOf(trial.program().spirv)) {
            Program program = trial.program();
            program.spirv = fault.spirv;
            const Words host = RunOnCpu(program, trial);
            if (host.empty()) {
                continue;
            }
            const Record expected = trial.Judge(host);
            const Record seen = trial.Judge(lavapipe.Run(program, trial));
            found += seen.outside > 0 ? 1 : 0;
            EXPECT_EQ(seen.outside > 0, expected.outside > 0)
                << fault.what << ": " << seen.outside << " outside, of the evaluator "
                << expected.outside;
            EXPECT_EQ(seen.refused > 0, expected.refused > 0) << fault.what;
            for (const auto& [culprit, values] : seen.culprits) {
                EXPECT_TRUE(IsDrivers(culprit)) << fault.what << ": " << culprit;
            }
        }
        EXPECT_GT(found, 15) << subject.path;
    }
}

}  // namespace
}  // namespace etalon
