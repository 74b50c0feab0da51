// The checker must be able to fail: tests/must_fail holds, for each rule, a case just outside its
// tolerance and the twin just inside.
#include <gmock/gmock.h>

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

const std::string kRoot = "tests/must_fail";

std::vector<std::string> Cases(const std::string& side) {
    std::vector<std::string> names = Lines(RunEtalon({"list", side, "--root", kRoot}).out);
    for (std::string& name : names) {
        name = name.substr(side.size() + 1);
    }
    return names;
}

struct Ran {
    Finished finished;
    json records;
};

Ran RunCases(const std::string& pattern, const std::vector<std::string>& more = {}) {
    const Folder folder;
    const std::string report = (folder.path() / "r.json").string();
    std::vector<std::string> words = {"run", pattern,          "--root", kRoot,
                                      "-d",  SoftwareDevice(), "--json", report};
    words.insert(words.end(), more.begin(), more.end());
    Ran ran{RunEtalon(words), {}};
    ran.records = json::parse(folder.Read("r.json"), nullptr, false)["records"];
    return ran;
}

TEST(MustFail, EveryCaseHasItsTwin) {
    const std::vector<std::string> outside = Cases("outside");
    EXPECT_GE(outside.size(), 30u);
    EXPECT_EQ(outside, Cases("inside"));
}

TEST(MustFail, OutsideFailsByEveryRecipe) {
    ETALON_NEED_DEVICE();
    const Ran ran = RunCases("outside");
    EXPECT_EQ(ran.finished.status, 1);
    std::set<std::string> cases;
    for (const json& record : ran.records) {
        cases.insert(record["case"]);
        EXPECT_EQ(record["verdict"], "fail") << record.dump(2);
        EXPECT_EQ(record["known_cause"], "") << record.dump(2);
        const bool is_refused = record["refused"] > 0 && !record["failed"].empty();
        const bool passes_unexpectedly = record["case"] == "outside/expected_failure";
        EXPECT_NE(is_refused, passes_unexpectedly) << record.dump(2);
    }
    EXPECT_EQ(cases.size(), Cases("outside").size());
}

TEST(MustFail, InsidePassesByEveryRecipe) {
    ETALON_NEED_DEVICE();
    const Ran ran = RunCases("inside");
    EXPECT_EQ(ran.finished.status, 0) << ran.finished.out;
    for (const json& record : ran.records) {
        const bool is_expected =
            record["case"] == "inside/expected_failure" || record["case"] == "inside/expected_law";
        EXPECT_EQ(record["verdict"], is_expected ? "fail" : "pass") << record.dump(2);
        EXPECT_EQ(record["known_cause"].empty() || record["known_cause"] == "", !is_expected);
        EXPECT_GT(record["judged"], 0);
    }
}

TEST(MustFail, OneWrongRowOfAThousandIsNamed) {
    ETALON_NEED_DEVICE();
    const Ran ran = RunCases("outside/one_row");
    for (const json& record : ran.records) {
        EXPECT_EQ(record["refused"], 1);
        EXPECT_GE(record["rows"], 1000);
        EXPECT_EQ(record["worst"]["inputs"]["x"]["hex"], "0x1.4p-1");
        EXPECT_EQ(record["worst"]["ulp_error"], 2.0);
    }
}

// What a person reads, by case: all figures of the failure's text.
const std::map<std::string, std::string> kTexts = {
    {"ulp",
     "  refused   2 of 2 values (2 rows, seed 1); the worst:\n"
     "  input     x=1.25\n"
     "            x=0x1.4p+0\n"
     "  output    result\n"
     "  actual    1.2500005 = 0x1.400008p+0\n"
     "  expected  1.25 = 0x1.4p+0\n"
     "  error     4 ulp, 4.77e-07 absolute, 1.33 times the tolerance\n"
     "  rule      ulp 3\n"},
    {"exact",
     "  refused   2 of 2 values (2 rows, seed 1); the worst:\n"
     "  input     x=1.25\n"
     "            x=0x1.4p+0\n"
     "  output    result\n"
     "  actual    1.2500001 = 0x1.400002p+0\n"
     "  expected  1.25 = 0x1.4p+0\n"
     "  error     1 ulp, 1.19e-07 absolute, infinite times the tolerance\n"
     "  rule      exact\n"},
    {"nan",
     "  output    result\n"
     "  actual    nan = nan\n"
     "  expected  1.25 = 0x1.4p+0\n"
     "  error     infinite ulp, infinite absolute, infinite times the tolerance\n"
     "  rule      absolute 0.5\n"},
    {"component",
     "  output    result.y\n"
     "  actual    1.2500002 = 0x1.400004p+0\n"
     "  expected  1.25 = 0x1.4p+0\n"
     "  error     2 ulp, 2.38e-07 absolute, 2 times the tolerance\n"
     "  rule      ulp 1\n"},
    {"matrix", "  output    result[1].y\n"},
    {"own_rule",
     "  refused   2 of 4 values (2 rows, seed 1); the worst:\n"
     "  input     x=1.375\n"
     "            x=0x1.6p+0\n"
     "  output    rest\n"},
    {"unsigned",
     "  input     u=1\n"
     "            u=1\n"
     "  output    result\n"
     "  actual    0 = 0\n"
     "  expected  1 = 0x1p+0\n"},
    {"boolean",
     "  refused   1 of 3 values (3 rows, seed 1); the worst:\n"
     "  input     x=0\n"
     "            x=0x0p+0\n"
     "  output    result\n"
     "  actual    true = true\n"},
    {"missed",
     "  shares    result: missed 2 of 10 (20 %, 10 % allowed), wrong 0 of 10 (0 %, 0 % allowed), "
     "worst right hit off by 0\n"
     "  refused   2 of 10 values (10 rows, seed 1); the worst:\n"
     "  input     x=4\n"
     "            x=0x1p+2\n"
     "  output    result\n"
     "  actual    -1 = -0x1p+0\n"
     "  expected  4 = 0x1p+2\n"
     "  error     infinite ulp, infinite absolute, infinite times the tolerance\n"
     "  rule      absolute 0.25, missed 0.1, wrong 0, beyond 2\n"},
    {"position",
     "  shares    result: missed 0 of 10 (0 %, 40 % allowed), wrong 0 of 10 (0 %, 40 % allowed), "
     "worst right hit off by 0.5\n"
     "  refused   1 of 10 values (10 rows, seed 1); the worst:\n"
     "  input     x=4\n"},
    {"integer_share", "  shares    result: wrong 2 of 4 (50 %, 25 % allowed)\n"},
    {"law_less_equal_within",
     "  output    law 'less_equal_within', left side\n"
     "  actual    1.2500002 = 0x1.400004p+0\n"
     "  expected  1.25 = 0x1.4p+0\n"
     "  error     2 ulp, 2.38e-07 absolute, 2 times the tolerance\n"
     "  rule      above(x, 2) <= x, within ulp 1\n"},
    {"expected_failure",
     "  reason    passes, but is expected to fail (bug: the shader adds two floats "
     "(https://example.org/1)); take the expectation out of the case\n"},
};

TEST(MustFail, TheTextHasEveryFigure) {
    ETALON_NEED_DEVICE();
    const Finished finished = RunCases("outside").finished;
    for (const auto& [name, text] : kTexts) {
        const std::size_t at = finished.out.find("outside/" + name + " on " + SoftwareDevice());
        ASSERT_NE(at, std::string::npos) << name;
        const std::size_t end = finished.out.find("\noutside/", at);
        EXPECT_THAT(finished.out.substr(at, end - at), HasSubstr(text));
    }
}

TEST(MustFail, TheRepeatCommandRepeatsIt) {
    ETALON_NEED_DEVICE();
    const Folder folder;
    struct Repeat {
        json record;
        std::string report;
        std::unique_ptr<RunningProgram> program;
    };
    std::vector<Repeat> repeats;
    std::set<std::string> names;
    const Ran ran = RunCases("outside");
    for (const json& record : ran.records) {
        if (names.insert(record["case"]).second) {  // one recipe is enough
            repeats.push_back({record, std::to_string(names.size()) + ".json", nullptr});
        }
    }
    const auto start = [&](Repeat& repeat) {
        repeat.program = StartInShell(repeat.record["repeat"].get<std::string>() + " --json " +
                                      (folder.path() / repeat.report).string());
    };
    constexpr std::size_t kAtOnce = 4;
    for (std::size_t i = 0; i < repeats.size() + kAtOnce; ++i) {
        if (i < repeats.size()) {
            start(repeats[i]);
        }
        if (i < kAtOnce) {
            continue;
        }
        Repeat& repeat = repeats[i - kAtOnce];
        const std::string command = repeat.record["repeat"];
        EXPECT_THAT(command, StartsWith("etalon run outside/"));
        const Finished again = repeat.program->Wait();
        EXPECT_EQ(again.status, 1) << command << "\n" << again.err << again.out;
        const json read = json::parse(folder.Read(repeat.report), nullptr, false);
        ASSERT_TRUE(read.is_object() && read["records"].size() == 1) << command;
        for (const char* key : {"verdict", "case", "recipe", "device", "worst", "reason"}) {
            EXPECT_EQ(read["records"][0][key], repeat.record[key]) << command;
        }
    }
}

TEST(MustFail, TheRepeatCommandIsWhatAShellTakes) {
    ETALON_NEED_DEVICE();
    const Folder folder;
    const std::filesystem::path root = folder.path() / "a root; with $HOME in 'it'";
    std::filesystem::create_directories(root);
    std::filesystem::copy(kRoot, root, std::filesystem::copy_options::recursive);
    const Finished finished =
        RunEtalon({"run", "outside/ulp", "--root", root.string(), "-d", SoftwareDevice()});
    ASSERT_EQ(finished.status, 1) << finished.err;
    const std::size_t at = finished.out.find("  repeat    ");
    ASSERT_NE(at, std::string::npos);
    const std::string command = finished.out.substr(at + 12, finished.out.find('\n', at) - at - 12);
    const Finished again = RunInShell(command);
    EXPECT_EQ(again.status, 1) << command << "\n" << again.err;
    EXPECT_THAT(again.out, HasSubstr("  actual    1.2500005 = 0x1.400008p+0\n"));
}

}  // namespace
}  // namespace etalon
