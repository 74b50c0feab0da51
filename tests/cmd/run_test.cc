// `etalon run`, `list`, `devices` and help, as a user meets them. On null:echo, which gives every
// call its inputs back: no driver is touched.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class RunTest : public testing::Test {
  protected:
    RunTest() {
        folder_.Write("f.glsl", "float same(float x) { return x; }\n");
        for (const char* name : {"a/one", "a/two", "ab", "b/one"}) {
            folder_.Write("cases/" + std::string(name) + ".toml", Case("x"));
        }
        folder_.Write("cases/wrong.toml", Case("x + 1"));
        options_.folder = folder_.path();
    }

    static std::string Case(const std::string& oracle) {
        return "source = \"f.glsl\"\ncall = \"same(x)\"\noracle = \"" + oracle +
               "\"\naccept = { ulp = 1 }\nrecipes = [\"glsl\", \"spirv\"]\n[domain]\n"
               "x = { values = [1.5, 2.5, 0.1] }\n";
    }
    Finished Etalon(const std::vector<std::string>& words) { return RunEtalon(words, options_); }
    Finished Run(std::vector<std::string> more) {
        more.insert(more.begin(), {"run", "-d", "null:echo"});
        return Etalon(more);
    }
    // "case device recipe verdict" of each record of a run.
    std::multiset<std::string> Records(std::vector<std::string> more, int status = 0) {
        more.insert(more.end(), {"--json", "r.json"});
        const Finished finished = Run(more);
        EXPECT_EQ(finished.status, status) << finished.err << finished.out;
        std::multiset<std::string> records;
        const json read = json::parse(folder_.Read("r.json"), nullptr, false);
        for (const json& record : read["records"]) {
            records.insert(record["case"].get<std::string>() + " " +
                           record["device"].get<std::string>() + " " +
                           record["recipe"].get<std::string>() + " " +
                           record["verdict"].get<std::string>());
        }
        return records;
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(RunTest, HelpTellsOfEverySubcommand) {
    const Finished help = Etalon({"--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.err, "");
    for (const char* name : {"devices", "list", "run", "probe"}) {
        EXPECT_THAT(help.out, HasSubstr(std::string("\n  ") + name));
        const Finished own = Etalon({name, "--help"});
        EXPECT_EQ(own.status, 0);
        EXPECT_EQ(own.err, "");
        EXPECT_THAT(own.out, HasSubstr("--help"));
    }
    EXPECT_THAT(Etalon({"probe", "--help"}).out,
                AllOf(HasSubstr("--inputs"), HasSubstr("--out"), HasSubstr("--with"),
                      HasSubstr("--include"), HasSubstr("--recipe"), HasSubstr("--csv"),
                      HasSubstr("--driver"), HasSubstr("--timeout"), HasSubstr("-D")));
    const Finished version = Etalon({"--version"});
    EXPECT_EQ(version.status, 0);
    EXPECT_THAT(version.out, testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(RunTest, DepthDecidesOnTheRows) {
    folder_.Write("cases/deep.toml",
                  "source = \"f.glsl\"\ncall = \"same(x)\"\noracle = \"x\"\n"
                  "accept = { ulp = 1 }\nrecipes = [\"glsl\"]\n[domain]\n"
                  "x = { range = [1.0, 2.0], sample = \"linear\", count = 5000, full = 9000 }\n");
    const auto rows = [&](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"run", "deep",      "-d",     "null:echo",
                                          "-d",  "null:slow", "--json", "r.json"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(Etalon(words).status, 0);
        std::vector<std::vector<int>> all;
        const json read = json::parse(folder_.Read("r.json"), nullptr, false);
        for (const json& record : read["records"]) {
            all.push_back({record["rows"], record["all_rows"]});
        }
        return all;
    };
    const auto quick = rows({});
    ASSERT_EQ(quick.size(), 2u);
    const int all = quick[0][1];
    EXPECT_GE(all, 5000);
    EXPECT_LT(all, 5100);
    EXPECT_EQ(quick, (std::vector<std::vector<int>>{{all, all}, {2048, all}}));
    EXPECT_EQ(rows({"--depth", "quick"}), quick);
    const auto full = rows({"--depth", "full"});
    ASSERT_EQ(full.size(), 2u);
    EXPECT_GE(full[0][0], 9000);
    EXPECT_EQ(full[1], full[0]);
    EXPECT_EQ(full[1][0], full[1][1]);
}

TEST_F(RunTest, NamesTheSlowestCases) {
    const Finished finished = Run({"a", "b", "--slowest", "2"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("slowest of 3 cases"));
    EXPECT_EQ(Run({"a", "--slowest", "-1"}).status, 2);
}

// Must fail: an id that no case covers.
TEST_F(RunTest, TheCatalogueMissesNoId) {
    folder_.Write("shaders/catalogue.toml",
                  "[F1]\nname = \"the same\"\nsource = \"thesis (1)\"\n"
                  "[F2]\nname = \"another\"\nsource = \"thesis (2)\"\n");
    std::filesystem::remove(folder_.path() / "cases/wrong.toml");
    folder_.Write("cases/a/one.toml", "covers = [\"F1\"]\n" + Case("x"));
    const Finished missing = Run({"--catalogue", "c.md"});
    EXPECT_EQ(missing.status, 1);
    EXPECT_EQ(missing.err, "etalon: no case covers F2\n");
    EXPECT_THAT(folder_.Read("c.md"),
                AllOf(HasSubstr("| F1 | the same | thesis (1) | `f.glsl`: same | 1: `a`: one | "
                                "expression | exact |\n"),
                      HasSubstr("| F2 | another | thesis (2) | - | **missing** | - | - |\n")));
    for (const char* chosen : {"a", "--gtest_filter=a/*"}) {
        EXPECT_EQ(Run({chosen, "--catalogue", "c.md"}).status, 0);
        EXPECT_THAT(folder_.Read("c.md"), Not(HasSubstr("F2")));
    }
    folder_.Write("cases/b/one.toml", "covers = [\"F2\"]\n" + Case("x"));
    EXPECT_EQ(Run({"--catalogue", "c.md"}).status, 0);
    EXPECT_THAT(Run({"--catalogue", "no/folder/c.md"}).err, StartsWith("etalon: --catalogue: "));

    folder_.Write("cases/b/one.toml", "\ncovers = [\"F3\"]\n" + Case("x"));
    const Finished unknown = Run({"--catalogue", "c.md"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_EQ(unknown.err, "etalon: cases/b/one.toml:2: 'covers': the catalogue has no F3\n");
    EXPECT_EQ(Run({}).status, 0) << "no catalogue, no ids to know";
}

TEST_F(RunTest, ListNamesCasesByPrefixAndPattern) {
    EXPECT_EQ(Etalon({"list"}).out, "a/one\na/two\nab\nb/one\nwrong\n");
    EXPECT_EQ(Etalon({"list", "a"}).out, "a/one\na/two\n");
    EXPECT_EQ(Etalon({"list", "a/"}).out, "a/one\na/two\n");
    EXPECT_EQ(Etalon({"list", "ab"}).out, "ab\n");
    EXPECT_EQ(Etalon({"list", "*/one"}).out, "a/one\nb/one\n");
    EXPECT_EQ(Etalon({"list", "b/one", "a/*", "b"}).out, "a/one\na/two\nb/one\n");
    ProgramOptions below;
    below.folder = folder_.path() / "cases/a";
    EXPECT_EQ(RunEtalon({"list", "ab"}, below).out, "ab\n");
    EXPECT_EQ(RunEtalon({"list", "ab", "--root", folder_.path().string()}).out, "ab\n");
}

TEST_F(RunTest, DevicesTellsWhatIsHere) {
    const Finished text = Etalon({"devices", "-d", "null:echo"});
    EXPECT_EQ(text.status, 0);
    EXPECT_THAT(text.out, StartsWith("null:echo\n  implementation  "));
    const Finished as_json = Etalon({"devices", "-d", "null:echo", "-d", "null:lost", "--json"});
    const json read = json::parse(as_json.out, nullptr, false);
    ASSERT_TRUE(read.is_array()) << as_json.out;
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0]["name"], "null:echo");
    EXPECT_EQ(read[1]["name"], "null:lost");
    EXPECT_THAT(text.out,
                HasSubstr("  fingerprint     " + read[0]["fingerprint"].get<std::string>()));
}

TEST_F(RunTest, RunsEachCaseByEachRecipe) {
    EXPECT_THAT(Records({"a", "ab"}),
                ElementsAre("a/one null:echo glsl pass", "a/one null:echo spirv pass",
                            "a/two null:echo glsl pass", "a/two null:echo spirv pass",
                            "ab null:echo glsl pass", "ab null:echo spirv pass"));
    EXPECT_THAT(Records({"ab", "--recipe", "glsl+fragment", "--recipe", "spirv+O"}),
                ElementsAre("ab null:echo glsl+fragment pass", "ab null:echo spirv+O pass"));
    EXPECT_THAT(Records({"wrong", "ab", "--recipe", "glsl"}, 1),
                ElementsAre("ab null:echo glsl pass", "wrong null:echo glsl fail"));
}

TEST_F(RunTest, EndsWithASummary) {
    const Finished good = Run({"a", "b"});
    EXPECT_EQ(good.status, 0);
    EXPECT_EQ(good.err, "");
    EXPECT_THAT(good.out, StartsWith("\ndevice "));
    EXPECT_THAT(good.out, HasSubstr("\n6 passed, 0 failed, 0 skipped in "));
    const Finished bad = Run({});
    EXPECT_EQ(bad.status, 1);
    EXPECT_EQ(bad.err, "");
    EXPECT_THAT(bad.out, HasSubstr("\n8 passed, 2 failed, 0 skipped in "));
    EXPECT_THAT(bad.out, HasSubstr("wrong on null:echo (glsl): fail\n"));
    EXPECT_THAT(bad.out,
                HasSubstr("wrong on null:echo (spirv): fail, with the same input and value\n"));
    EXPECT_THAT(bad.out, Not(HasSubstr("[ RUN")));
}

TEST_F(RunTest, VerboseHasALineForEachTest) {
    const Finished finished = Run({"--verbose"});
    int lines = 0;
    for (const std::string& line : Lines(finished.out)) {
        lines += line.starts_with("pass ") || line.starts_with("fail ") ? 1 : 0;
    }
    EXPECT_EQ(lines, 10);
    EXPECT_THAT(finished.out, HasSubstr("pass a/one.null/echo/glsl ("));
    EXPECT_THAT(finished.out, HasSubstr("fail wrong.null/echo/spirv ("));
}

TEST_F(RunTest, RunsAtOneInput) {
    const Finished wrong = Run({"wrong", "--at", "x=0x1.8p+1", "--recipe", "glsl"});
    EXPECT_EQ(wrong.status, 1);
    EXPECT_THAT(wrong.out, HasSubstr("  refused   1 of 1 values (1 rows, seed 1); the worst:\n"
                                     "  input     x=3\n"
                                     "            x=0x1.8p+1\n"
                                     "  output    result\n"
                                     "  actual    3 = 0x1.8p+1\n"
                                     "  expected  4 = 0x1p+2\n"));
    EXPECT_EQ(Run({"ab", "--at", "x=0x1p-149"}).status, 0);
}

TEST_F(RunTest, TheReportIsComplete) {
    const Finished finished = Run({"wrong", "ab", "--json", "r.json"});
    EXPECT_EQ(finished.status, 1);
    const json read = json::parse(folder_.Read("r.json"));
    EXPECT_EQ(read["version"].get<std::string>() + "\n", Etalon({"--version"}).out);
    EXPECT_EQ(read["devices"][0]["name"], "null:echo");
    ASSERT_EQ(read["records"].size(), 4u);
    const json& passed = read["records"][0];
    EXPECT_EQ(passed["case"], "ab");
    EXPECT_EQ(passed["judged"], 3);
    EXPECT_EQ(passed["refused"], 0);
    EXPECT_EQ(passed["failed"], json::array());
    // The worst is told on a pass too: the oracle's 0.1 is not the float's.
    EXPECT_EQ(passed["worst"]["output"], "result");
    EXPECT_EQ(passed["worst"]["rule"], "ulp 1");
    const json& failed = read["records"][2];
    EXPECT_EQ(failed["case"], "wrong");
    EXPECT_EQ(failed["refused"], 3);
    EXPECT_EQ(failed["failed"], json::array({"result"}));
    EXPECT_EQ(failed["worst"]["expected"]["decimal"].get<std::string>().substr(0, 3), "1.1");
    EXPECT_GT(failed["worst"]["used"], 1e6);
    EXPECT_EQ(failed["repeat"],
              "etalon run wrong --device null:echo --recipe glsl --at x=0x1.99999ap-4");
}

TEST_F(RunTest, FiltersTests) {
    EXPECT_THAT(Records({"--gtest_filter=*one*glsl"}),
                ElementsAre("a/one null:echo glsl pass", "b/one null:echo glsl pass"));
    EXPECT_THAT(Records({"--gtest_filter=a*-*two*"}),
                ElementsAre("a/one null:echo glsl pass", "a/one null:echo spirv pass",
                            "ab null:echo glsl pass", "ab null:echo spirv pass"));
}

TEST_F(RunTest, ListsTestsAndRunsNone) {
    const Finished finished = Run({"a", "--gtest_list_tests"});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, "");
    EXPECT_EQ(finished.out,
              "a/one.\n  null/echo/glsl\n  null/echo/spirv\n"
              "a/two.\n  null/echo/glsl\n  null/echo/spirv\n");
    folder_.Write("t.json", "old");
    EXPECT_EQ(Run({"a", "--gtest_list_tests", "--json", "t.json"}).status, 0);
    EXPECT_EQ(folder_.Read("t.json"), "old");
}

TEST_F(RunTest, ShardsPartitionTheTests) {
    const std::multiset<std::string> all = Records({"a", "ab", "b"});
    ASSERT_EQ(all.size(), 8u);
    std::multiset<std::string> together;
    for (int shard = 0; shard < 3; ++shard) {
        options_.environment = {"GTEST_TOTAL_SHARDS=3",
                                "GTEST_SHARD_INDEX=" + std::to_string(shard)};
        const std::multiset<std::string> own = Records({"a", "ab", "b"});
        EXPECT_GE(own.size(), 2u);
        together.insert(own.begin(), own.end());
    }
    EXPECT_EQ(together, all);
}

TEST_F(RunTest, WritesGoogleTestsXmlWithItsProperties) {
    const Finished finished = Run({"wrong", "ab", "--recipe", "glsl", "--gtest_output=xml:t.xml"});
    EXPECT_EQ(finished.status, 1);
    const std::string xml = folder_.Read("t.xml");
    EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\""));
    for (const char* text :
         {"<property name=\"verdict\" value=\"pass\"/>",
          "<property name=\"verdict\" value=\"fail\"/>", "<property name=\"margin\" value=\"",
          "<property name=\"worst_ulp_error\" value=\"",
          "<property name=\"worst\" value=\"result: ", "wrong on null:echo (glsl): fail"}) {
        EXPECT_THAT(xml, HasSubstr(text));
    }
}

TEST_F(RunTest, TellsWhyACaseWasSkipped) {
    const Finished finished =
        Etalon({"run", "ab", "-d", "null:unsupported", "--gtest_output=xml:t.xml"});
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.err, "etalon: no test ran: every one was skipped\n");
    EXPECT_THAT(finished.out, HasSubstr("skipped, 2 times: the null device supports no program\n"));
    EXPECT_THAT(finished.out, HasSubstr("\n0 passed, 0 failed, 2 skipped in "));
    EXPECT_THAT(folder_.Read("t.xml"), HasSubstr("the null device supports no program"));
}

}  // namespace
}  // namespace etalon
