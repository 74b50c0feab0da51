// Charts as a user asks for them, on the evaluator as a device.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* kShader = R"glsl(
float product(float x) { return x * x; }
float power(float x) { return exp2(2.0 * log2(x)); }
float rough(float x) { return x * x + 0.01; }
float wrong(float x) { return 0.0; }
float nothing(float x) { return 0.0 / (x - x); }
#ifdef STEPS
float search(float level)
{
    for (int i = 0; i <= STEPS; ++i) {
        float x = float(i) / float(STEPS);
        if (x >= level) {
            return x;
        }
    }
    return -1.0;
}
#endif
)glsl";

constexpr const char* kSquares = R"toml(quantity = "square"
source = "f.glsl"
oracle = "x * x"
accept = { absolute = 0.1 }
reference = "product"
domain = { x = { range = [0.5, 1.0], sample = "linear", count = 50 } }
[[member]]
name = "rough"
call = "rough(x)"
[[member]]
name = "product"
call = "product(x)"
[[member]]
name = "wrong"
call = "wrong(x)"
[[member]]
name = "nothing"
call = "nothing(x)"
)toml";

constexpr const char* kSearch = R"toml(oracle = "level"
source = "f.glsl"
call = "search(level)"
accept = { absolute = 1e-6, missed = 0, wrong = 0, beyond = 0.2 }
domain = { level = { range = [0.0, 1.0], sample = "linear", count = 50 } }
[[scene]]
name = "low"
domain = { level = { range = [0.0, 0.5], sample = "linear", count = 50 } }
[[scene]]
name = "all of it"
[[member]]
name = "linear"
settings = { STEPS = [2, 10, 100] }
)toml";

class ChartTest : public testing::Test {
  protected:
    ChartTest() {
        folder_.Write("f.glsl", kShader);
        folder_.Write("cases/squares.family.toml", kSquares);
        folder_.Write("cases/search.family.toml", kSearch);
        folder_.Write("cases/c.toml", "");
        options_.folder = folder_.path();
    }

    Finished Chart(std::vector<std::string> words) {
        words.insert(words.begin(), "chart");
        return RunEtalon(words, options_);
    }
    json ChartAsJson(std::vector<std::string> words) {
        words.insert(words.end(), {"--json", "-d", "cpu"});
        const Finished finished = Chart(words);
        EXPECT_EQ(finished.err, "");
        return json::parse(finished.out);
    }
    static json PointOf(const json& chart, const std::string& label, const std::string& scene) {
        for (const json& point : chart["points"]) {
            if (point["label"] == label && point["scene"] == scene) {
                return point;
            }
        }
        ADD_FAILURE() << "no point " << label << " in scene " << scene;
        return {};
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(ChartTest, WithoutTimesItIsTheSameEachTime) {
    const Finished first = Chart({"squares", "--no-times", "-d", "cpu"});
    EXPECT_EQ(first.status, 0) << first.err;
    EXPECT_EQ(first.err, "");
    EXPECT_THAT(first.out, StartsWith("squares: square\n"));
    EXPECT_EQ(Chart({"squares", "--no-times", "-d", "cpu"}).out, first.out);
    const Finished text = Chart({"search", "--no-times", "-d", "cpu", "--json"});
    EXPECT_EQ(Chart({"search", "--no-times", "-d", "cpu", "--json"}).out, text.out);
}

// What must fail: a member that is cheaper and wrong.
TEST_F(ChartTest, AWrongMemberIsNotOnTheFront) {
    const json chart = ChartAsJson({"squares", "--no-times"});
    for (const char* const label : {"wrong", "nothing"}) {
        const json point = PointOf(chart, label, "all");
        EXPECT_EQ(point["refused"], true) << label;
        EXPECT_EQ(point["front"], false) << label;
    }
    EXPECT_EQ(PointOf(chart, "nothing", "all")["accuracy"]["worst"], "inf");
    EXPECT_EQ(PointOf(chart, "nothing", "all")["accuracy"]["not_finite"], 52);
    EXPECT_EQ(PointOf(chart, "product", "all")["front"], true);
    EXPECT_EQ(PointOf(chart, "rough", "all")["refused"], false);
    EXPECT_EQ(PointOf(chart, "rough", "all")["front"], false);
    EXPECT_NEAR(PointOf(chart, "rough", "all")["accuracy"]["worst"].get<double>(), 0.01, 1e-6);
    EXPECT_NEAR(PointOf(chart, "wrong", "all")["accuracy"]["bits"].get<double>(), 0, 1e-6);
    for (const json& bound : chart["bounds"]) {
        ASSERT_FALSE(bound["point"].is_null());
        EXPECT_EQ(chart["points"][bound["point"].get<std::size_t>()]["label"], "product");
    }
    EXPECT_THAT(Chart({"squares", "--no-times", "-d", "cpu"}).out, HasSubstr("\n!  "));
}

TEST_F(ChartTest, ASearchIsToldByErrorAndShares) {
    const json chart = ChartAsJson({"search", "--no-times"});
    EXPECT_EQ(chart["search"], true);
    const json coarse = PointOf(chart, "linear, STEPS=2", "all");
    EXPECT_EQ(coarse["refused"], true);  // steps of 0.5 meet other hits
    EXPECT_GT(coarse["accuracy"]["wrong"], 0.3);
    EXPECT_EQ(coarse["accuracy"]["missed"], 0);
    EXPECT_LE(coarse["accuracy"]["worst"], 0.2);
    const json fine = PointOf(chart, "linear, STEPS=100", "all");
    EXPECT_EQ(fine["accuracy"]["wrong"], 0);
    EXPECT_NEAR(fine["accuracy"]["worst"].get<double>(), 0.01, 1e-3);
    EXPECT_EQ(fine["settings"]["STEPS"], 100);
    EXPECT_EQ(fine["accuracy"]["rows"], 104);
    EXPECT_EQ(PointOf(chart, "linear, STEPS=100", "low")["accuracy"]["rows"], 52);
    const json some = ChartAsJson({"search", "--no-times", "--scene", "low", "--member", "*=10"});
    EXPECT_EQ(some["points"].size(), 2u);  // in the scene and in all
}

TEST_F(ChartTest, TheRepeatCommandRunsTheWorstInput) {
    const json chart = ChartAsJson({"search", "--no-times"});
    const json accuracy = PointOf(chart, "linear, STEPS=10", "all")["accuracy"];
    const std::string repeat = accuracy["repeat"];
    EXPECT_THAT(repeat, StartsWith("etalon chart search --device cpu --recipe spirv --member "
                                   "'linear, STEPS=10' --scene "));
    const Finished again = RunInShell(repeat, options_);
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.out,
                HasSubstr("\n  actual    " + accuracy["actual"]["decimal"].get<std::string>()));
    EXPECT_THAT(again.out,
                HasSubstr("\n  expected  " + accuracy["expected"]["decimal"].get<std::string>()));
}

TEST_F(ChartTest, TimesAreRatiosToTheReference) {
    const json chart = ChartAsJson({"squares", "--seconds", "0.05", "--member", "rough"});
    const json reference = PointOf(chart, "product", "all");  // timed although not asked for
    EXPECT_EQ(reference["cost"]["ratio"], 1);
    EXPECT_GT(reference["cost"]["nanoseconds"], 0);
    EXPECT_GT(PointOf(chart, "rough", "all")["cost"]["ratio"], 0);
    EXPECT_EQ(chart["cost_by"], "time");
}

TEST_F(ChartTest, AUsersFileIsARootOfItsOwn) {
    folder_.Write("mine/g.glsl", "float half_of(float x) { return 0.5 * x; }\n");
    folder_.Write("mine/halves.toml",
                  "oracle = \"x / 2\"\ndomain = { x = { values = [1.0, 3.0] } }\n[[member]]\n"
                  "name = \"half\"\nsource = \"g.glsl\"\ncall = \"half_of(x)\"\n");
    const Finished finished = Chart({"mine/halves.toml", "--no-times", "-d", "cpu"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, StartsWith("halves\n"));
    EXPECT_THAT(finished.out, HasSubstr("exact  half\n"));
}

TEST_F(ChartTest, ListsFamiliesAndNoCases) {
    EXPECT_EQ(Chart({"--list"}).out, "search\nsquares  square\n");
    EXPECT_THAT(RunEtalon({"list"}, options_).out, "c\n");
}

TEST_F(ChartTest, ADeviceThatFailsIsAVerdict) {
    const Finished crash = Chart({"squares", "--no-times", "-d", "null:crash"});
    EXPECT_EQ(crash.status, 1);
    EXPECT_THAT(crash.out, HasSubstr("  product  ("));
    EXPECT_THAT(crash.out, Not(HasSubstr("*  ")));
}

TEST_F(ChartTest, MistakesAreToldInOneLine) {
    const auto complaint = [this](std::vector<std::string> words) {
        words.insert(words.end(), {"--no-times", "-d", "cpu"});
        const Finished finished = Chart(words);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        return finished.err;
    };
    EXPECT_EQ(complaint({}),
              "etalon: chart: no family is named; `etalon chart --list` shows them\n");
    EXPECT_EQ(complaint({"square"}),
              "etalon: no family is called 'square'; did you mean 'squares'?\n");
    EXPECT_EQ(complaint({"squares", "--member", "ruogh"}),
              "etalon: --member 'ruogh': the family has no such member; did you mean 'rough'?\n");
    EXPECT_THAT(complaint({"search", "--scene", "high"}),
                StartsWith("etalon: --scene 'high': the family has no such scene"));
    EXPECT_THAT(complaint({"squares", "--recipe", "nonsense"}), HasSubstr("nonsense"));
    EXPECT_THAT(complaint({"squares", "--at", "y=1"}),
                HasSubstr("--at: the case has no input 'y'"));
    folder_.Write("cases/bad.family.toml",
                  "oracle = \"x\"\nsource = \"f.glsl\"\ndomain = { x = { values = [1] } }\n"
                  "[[member]]\nname = \"m\"\ncall = \"missing(x)\"\n");
    EXPECT_THAT(complaint({"bad"}),
                testing::AllOf(StartsWith("etalon: cases/bad.family.toml:6:"), EndsWith(" (m)\n")));
}

}  // namespace
}  // namespace etalon
