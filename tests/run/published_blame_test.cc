// The methods as their sources print them: whose fault their failures are. What cancels is blamed
// on rounding, what is not the physics on the method.
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "base/file.h"
#include "case/case.h"
#include "run/case_run.h"
#include "run/devices.h"
#include "run/fit.h"

namespace etalon {
namespace {

using testing::AnyOf;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;

// Null where the device is not here.
Runner* RunnerOf(const std::string& name) {
    static std::map<std::string, DeviceSet> sets;
    if (!sets.contains(name)) {
        DeviceChoice choice;
        choice.patterns = {name};
        Result<DeviceSet> devices = OpenDevices(choice);
        sets[name] = devices ? std::move(*devices) : DeviceSet{};
    }
    const auto& runners = sets[name].runners;
    return runners.empty() ? nullptr : runners.front().get();
}

constexpr std::uint64_t kMostRows = 1000;

// One case on one device, as `etalon run` has it.
class Judged {
  public:
    // All rows, or the one `at`.
    Judged(const std::string& path, Runner& runner, const std::string& at = "")
        : evaluations_(std::make_shared<Programs>()) {
        const Result<Case> read = ReadCase(".", path);
        EXPECT_TRUE(read.ok()) << read.error().message;
        Result<PreparedCase> prepared = at.empty() ? Prepare(*read) : PrepareAt(*read, at);
        EXPECT_TRUE(prepared.ok()) << prepared.error().message;
        prepared_ = prepared->table.rows > kMostRows ? Thin(*prepared, kMostRows) : *prepared;
        record = RunCase(prepared_, runner, DefaultRecipe(runner.info()), evaluations_, {});
    }

    Record record;

  private:
    PreparedCase prepared_;
    Evaluations evaluations_;
};

struct Published {
    const char* path;
    const char* culprit;
};

// Wherever they run.
constexpr Published kPublished[] = {
    // The intensity of refraction near the critical angle.
    {"published/optics/d14_intensity_above_critical", "rounding"},
    {"published/optics/d14_above_critical", "rounding"},
    // A ratio of indices near one.
    {"published/optics/d14_nearly_equal", "rounding"},
    {"published/optics/d14_index_10003", "rounding"},
    {"published/optics/d14_index_100001", "rounding"},
    // T = 1 - R at grazing angles.
    {"published/optics/d15_grazing", "rounding"},
    {"published/optics/d15_last_cosine", "rounding"},
    // The trigonometric forms at the angle 0 itself are 0 / 0 in any arithmetic.
    {"published/optics/d02_normal_incidence", "method"},
    // v + 2 (v . n) n.
    {"published/optics/d03_reflect_50_degrees", "method"},
    {"published/optics/d03_reflect_50_degrees_length", "method"},
    {"published/optics/d03_reflect_straight_back", "method"},
    // The colour of absorption as a mix.
    {"published/optics/d06_colour", "method"},
    {"published/optics/d06_double_layer", "method"},
    {"published/optics/d06_two_layers", "method"},
    // A plane half as deep as the search.
    {"published/translucent/d20_position", "method"},
    {"published/relief/lateral", "method"},
    // F_t = 1 - k + n k.
    {"published/shadow_map/transmission", "method"},
    {"published/shadow_map/transmission_points", "method"},
    {"published/shadow_map/irradiance", "method"},
};

// A driver's sines err more than all rounding of the trigonometric forms: only where sines are
// good.
constexpr Published kPublishedOfSines[] = {{"published/optics/d02_index_100001", "rounding"}};

std::string NameOf(const testing::TestParamInfo<Published>& published) {
    std::string name = published.param.path;
    std::replace(name.begin(), name.end(), '/', '_');
    return name.substr(std::string("published_").size());
}

class PublishedBlame : public testing::TestWithParam<Published> {
  protected:
    static void ExpectCulprit(Runner& runner) {
        const Judged judged(GetParam().path, runner);
        const Record& record = judged.record;
        EXPECT_EQ(record.verdict, Verdict::kFail);
        EXPECT_THAT(record.known_cause, Not(IsEmpty())) << "the case expects to fail otherwise";
        ASSERT_TRUE(record.worst && record.worst->budget) << record.unevaluated;
        EXPECT_EQ(record.worst->budget->culprit, GetParam().culprit);
        // Not the worst value alone.
        EXPECT_THAT(record.culprits, testing::Each(Pair(GetParam().culprit, testing::Gt(0u))));
    }
};

using PublishedBlameOnCpu = PublishedBlame;
using PublishedBlameOnLlvmpipe = PublishedBlame;

TEST_P(PublishedBlameOnCpu, IsTheCulprit) {
    ExpectCulprit(*RunnerOf("cpu"));
}

TEST_P(PublishedBlameOnLlvmpipe, IsTheCulprit) {
    Runner* runner = RunnerOf("vulkan:llvmpipe");
    if (runner == nullptr) {
        GTEST_SKIP() << "no vulkan:llvmpipe here";
    }
    ExpectCulprit(*runner);
}

INSTANTIATE_TEST_SUITE_P(Cases, PublishedBlameOnCpu, testing::ValuesIn(kPublished), NameOf);
INSTANTIATE_TEST_SUITE_P(OfSines, PublishedBlameOnCpu, testing::ValuesIn(kPublishedOfSines),
                         NameOf);
INSTANTIATE_TEST_SUITE_P(Cases, PublishedBlameOnLlvmpipe, testing::ValuesIn(kPublished), NameOf);

// 1 - (1 - x^2), the square of cos_t between equal media, is x^2 in any precision that holds it,
// and 0 in another: M must hold it for every float, or the method is blamed for what M lost.
TEST(TinyCosines, AreOfRoundingDownToTheLeastFloat) {
    for (const char* cosine : {"0x1p-13", "0x1p-30", "0x1p-80", "0x1p-149"}) {
        const Judged judged("published/optics/d12_equal_indices", *RunnerOf("cpu"),
                            std::string("n=1,cos_i=") + cosine);
        ASSERT_TRUE(judged.record.worst && judged.record.worst->budget) << cosine;
        EXPECT_EQ(judged.record.worst->budget->culprit, "rounding") << cosine;
    }
    const Judged zero("published/optics/d12_equal_indices", *RunnerOf("cpu"), "n=1,cos_i=0");
    EXPECT_EQ(zero.record.worst->budget->culprit, "method");
}

// A case that says "method" or "rounding" of a failure is right about it.
TEST(ExpectedBlame, IsWhatTheBudgetFinds) {
    const Result<std::vector<std::string>> paths = ListCases(".");
    ASSERT_TRUE(paths.ok()) << paths.error().message;
    Runner& runner = *RunnerOf("cpu");
    std::map<std::string, int> held;
    for (const std::string& path : *paths) {
        const Result<Case> read = ReadCase(".", path);
        ASSERT_TRUE(read.ok()) << read.error().message;
        std::set<std::string> statuses;
        for (const ExpectedFailure& expected : read->expected_failures) {
            if (GlobMatches(expected.device, "cpu") && expected.verdict == "fail") {
                statuses.insert(expected.status);
            }
        }
        if (!statuses.contains("method") && !statuses.contains("rounding")) {
            continue;
        }
        const Judged judged(path, runner);
        const Record& record = judged.record;
        EXPECT_EQ(record.verdict, Verdict::kFail) << path << ": " << record.reason;
        if (!record.worst || !record.worst->budget) {
            ADD_FAILURE() << path << ": no budget: " << record.unevaluated;
            continue;
        }
        EXPECT_THAT(statuses, testing::Contains(record.worst->budget->culprit)) << path;
        ++held[record.worst->budget->culprit];
    }
    EXPECT_GT(held["method"], 100);
    EXPECT_GT(held["rounding"], 8);
}

}  // namespace
}  // namespace etalon
