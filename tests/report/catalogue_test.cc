#include "report/catalogue.h"

#include <gmock/gmock.h>

#include "report/records.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::vector<CatalogueEntry> kEntries = {
    {"F2", "Bent | ray", "thesis (6)", ""},
    {"F9", "Never shown", "thesis (9)", ""},
    {"D1", "Zero for a right angle", "thesis (7)", ""},
    {"D8", "Two ranges", "thesis", "a sentence"},
};

Record Of(const std::string& path, const std::string& device, const std::string& rule, double ulp,
          double error) {
    Record record = Passed();
    record.case_path = path;
    record.device = device;
    record.worst->rule = rule;
    record.worst->ulp_error = ulp;
    record.worst->error = error;
    return record;
}

// A hardened case on two devices, one by laws, and a published one that fails as expected.
RunRecord SomeRun() {
    RunRecord run;
    run.devices = {Llvmpipe(), Silent()};
    const FunctionNote hardened{"bend", "shaders/optics/bend.glsl"};
    run.cases = {
        {"optics/bend/angle", {"F2", "D1"}, {hardened}, {"snell.angle(n, a)"}, 0},
        {"optics/bend/laws", {"F2"}, {hardened, {"back", "shaders/optics/bend.glsl"}}, {}, 2},
        {"published/bend", {"D1"}, {{"bend", "shaders/published/optics.glsl"}}, {"pi / 2"}, 0},
    };
    run.records = {
        Of("optics/bend/angle", "osmesa:llvmpipe", "ulp 4 or absolute 1e-06", 3.21, 1),
        Of("optics/bend/angle", "osmesa:llvmpipe", "ulp 4 or absolute 1e-06", 900, 2.5e-7),
        Of("optics/bend/angle", "vulkan:silent@new", "ulp 4 or absolute 1e-06", 2, 1),
        Of("optics/bend/laws", "osmesa:llvmpipe", "x < 1, within exact", 0, 0),
        Of("optics/bend/laws", "vulkan:silent@new", "x < 1, within exact", 0, 0),
        Refused(),
        Refused(),
    };
    for (Record& record : run.records) {
        if (record.case_path == "optics/bend/laws") {
            record.worst->output = "law 'one', left side";
        }
    }
    for (std::size_t i : {5, 6}) {
        run.records[i].case_path = "published/bend";
        run.records[i].known_cause = "method: zero";
        run.records[i].figures = {{"absolute 1.571 within 0.01", "1.570796", true}};
    }
    run.records[6].device = "vulkan:silent@new";
    run.records[6].figures[0].seen = "1.570801";
    return run;
}

constexpr const char* kHead = R"md(# The catalogue

Written by `etalon run --catalogue`, of these devices:

- osmesa:llvmpipe: llvmpipe (LLVM 15.0.6, 256 bits), Mesa 22.3.6
- vulkan:silent@new: Silent, silent 1

An error is the worst of all cases and recipes that pass, in the measure by which it was accepted; it is the same on all devices where none is named.

## Functions

| id | function | source | GLSL functions | cases | oracle | hardened: worst error |
| --- | --- | --- | --- | --- | --- | --- |
)md";
constexpr const char* kF2 =
    R"md(| F2 | Bent \| ray | thesis (6) | `shaders/optics/bend.glsl`: back, bend | 2: `optics/bend`: angle, laws | `snell.angle`, laws | 3.2 ulp, 2.5e-07 absolute (osmesa:llvmpipe)<br>2 ulp (vulkan:silent@new) |
)md";
constexpr const char* kF9 =
    R"md(| F9 | Never shown | thesis (9) | - | **missing** | - | - |
)md";
constexpr const char* kDefects = R"md(
## Defects

| id | defect | source | GLSL functions | cases | oracle | published: expected and seen | hardened: worst error |
| --- | --- | --- | --- | --- | --- | --- | --- |
| D1 | Zero for a right angle | thesis (7) | `shaders/optics/bend.glsl`: bend<br>`shaders/published/optics.glsl`: bend | 2: `optics/bend`: angle<br>`published`: bend | `snell.angle`, expression | `published/bend`: absolute 1.571 within 0.01; saw 1.571 | 3.2 ulp, 2.5e-07 absolute (osmesa:llvmpipe)<br>2 ulp (vulkan:silent@new) |
)md";
constexpr const char* kD8 =
    R"md(| D8 | Two ranges | thesis | - | by reading | - | a sentence | - |
)md";

TEST(Catalogue, HasARowForEachId) {
    EXPECT_EQ(CatalogueMarkdown(kEntries, SomeRun(), false),
              std::string(kHead) + kF2 + kF9 + kDefects + kD8);
}

TEST(Catalogue, LeavesOutWhatWasNotChosen) {
    EXPECT_EQ(CatalogueMarkdown(kEntries, SomeRun(), true), std::string(kHead) + kF2 + kDefects);
}

TEST(Catalogue, NamesTheMissing) {
    EXPECT_THAT(MissingIds(kEntries, SomeRun()), ElementsAre("F9"));
    RunRecord run = SomeRun();
    run.cases[1].covers = {"F9"};
    EXPECT_THAT(MissingIds(kEntries, run), IsEmpty());
    run.cases.clear();
    EXPECT_THAT(MissingIds(kEntries, run), ElementsAre("F2", "F9", "D1"));
}

TEST(Catalogue, TellsEachKindOfError) {
    const auto cell = [](const std::function<void(Record&)>& change) {
        RunRecord run = SomeRun();
        for (Record& record : run.records) {
            if (record.case_path == "optics/bend/angle") {
                change(record);
            }
        }
        std::string text = CatalogueMarkdown({kEntries[0]}, run, false);
        text = text.substr(0, text.find("\n\n## Defects"));
        return text.substr(text.rfind("laws | ") + 7);
    };
    EXPECT_EQ(cell([](Record& record) {
                  record.worst->rule = "relative 0.01";
                  record.worst->error = 0.002;
                  record.worst->expected = {"-0.5", ""};
              }),
              "0.004 relative |");
    EXPECT_EQ(cell([](Record& record) {
                  record.worst->rule = "exact";
                  record.worst->error = 0;
              }),
              "exact |");
    EXPECT_EQ(cell([](Record& record) { record.worst->output = "law 'energy', left side"; }),
              "laws hold |");
    EXPECT_EQ(cell([](Record& record) {
                  ShareCount share;
                  share.search = true;
                  share.rows = 1000;
                  share.wrong = 5;
                  share.hits = 400;
                  share.missed = 1;
                  share.worst_right = 0.0125;
                  record.shares = {share};
              }),
              "0.013 absolute, 0.25 % missed, 0.5 % wrong |");
    EXPECT_EQ(cell([](Record& record) {
                  record.verdict = Verdict::kFail;
                  record.known_cause = "bug: of the driver";
              }),
              "laws hold, known failure |");
    EXPECT_EQ(cell([](Record& record) { record.verdict = Verdict::kCrash; }),
              "laws hold, **fails** |");
    EXPECT_EQ(cell([](Record& record) { record.verdict = Verdict::kSkip; }), "laws hold |");
}

TEST(Catalogue, TellsOfAFailureWithoutAFigure) {
    RunRecord run = SomeRun();
    run.records[5].figures.clear();
    run.records[6].figures.clear();
    EXPECT_THAT(CatalogueMarkdown(kEntries, run, false),
                HasSubstr("| `published/bend`: fails as expected |"));
    run.records.resize(5);
    EXPECT_THAT(CatalogueMarkdown(kEntries, run, false), Not(HasSubstr("fails as expected")));
}

}  // namespace
}  // namespace etalon
