// Maps as a user asks for them. The null device plays the driver.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class MapCommandTest : public testing::Test {
  protected:
    MapCommandTest() {
        folder_.Write("f.glsl", "float f(float a, float b) { return a + b; }\n");
        options_.folder = folder_.path();
        Write("c",
              "fails = \"a > b + 0.01\"\nsafe = \"a < b\"\nbecause = \"the lesser is returned\"\n");
    }

    // The null device returns a; what is asked for is the lesser of both.
    void Write(const std::string& name, const std::string& prediction) {
        folder_.Write("cases/" + name + ".toml",
                      "description = \"the lesser\"\nsource = \"f.glsl\"\ncall = \"f(a, b)\"\n"
                      "oracle = \"min(a, b)\"\naccept = { absolute = 1e-3 }\n[domain]\n"
                      "a = { range = [0.0, 1.0], sample = \"linear\", count = 9 }\n"
                      "b = { range = [0.0, 1.01], sample = \"linear\", count = 9 }\n"
                      "c = { values = [3.0, 4.0] }\n"
                      "[map]\nover = [\"a\", \"b\"]\nsize = [6, 4]\n" +
                          prediction);
    }
    Finished Map(const std::vector<std::string>& more) {
        std::vector<std::string> words = {"map", "c", "-d", "null:echo"};
        words.insert(words.end(), more.begin(), more.end());
        return RunEtalon(words, options_);
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(MapCommandTest, DrawsThePicture) {
    const Finished finished = Map({});
    EXPECT_EQ(finished.status, 0);
    EXPECT_EQ(finished.err, "");
    EXPECT_THAT(finished.out, StartsWith("c, result by absolute 0.001\n"
                                         "  about     the lesser\n"
                                         "  across    a, 6 cells from 0 to 1, linear\n"
                                         "  upwards   b, 4 cells from 0 to 1.01, linear\n"
                                         "  others    c=3\n"));
    EXPECT_THAT(finished.out, HasSubstr("  cells     12 holds (50 %), 12 refused (50 %)\n"));
    EXPECT_THAT(finished.out,
                HasSubstr("\n    ....+x\n    ..++xx\n    .+xxxx\n    +xxxxx\n"
                          "    . holds  x refused  + where the prediction changes\n"));
    EXPECT_THAT(finished.out, HasSubstr("  agrees    null:echo: 12 of 12 cells that must fail do, "
                                        "12 of 12 that must hold do\n"));
    EXPECT_THAT(finished.out, EndsWith("\nrepeat: etalon map c --device null:echo\n"));
}

TEST_F(MapCommandTest, AWrongPredictionIsAVerdict) {
    Write("c", "safe = \"a < 1.2 * b\"\nbecause = \"wrong\"\n");
    const Finished safe = Map({});
    EXPECT_EQ(safe.status, 1);
    EXPECT_THAT(safe.out, HasSubstr("  DIFFERS   null:echo: "));
    EXPECT_THAT(safe.err, StartsWith("c on null:echo (glsl): predicted to hold, and it is refused, "
                                     "at a=0x1."));
    EXPECT_THAT(safe.err, HasSubstr("\n  repeat    etalon run c --device null:echo --recipe glsl "
                                    "--at a=0x1."));
    Write("c", "fails = \"a > 0.8 * b\"\nbecause = \"wrong\"\n");
    const Finished fails = Map({"--json"});
    EXPECT_EQ(fails.status, 1);
    EXPECT_THAT(fails.err, HasSubstr("predicted to fail, and it holds, at a=0x1."));
}

TEST_F(MapCommandTest, TheRepeatCommandShowsTheCell) {
    Write("c", "safe = \"a < 1.2 * b\"\nbecause = \"wrong\"\n");
    const std::string command = Lines(Map({}).err).at(1);
    const Finished again = RunInShell(command.substr(command.find("etalon")), options_);
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.out, HasSubstr("refused   1 of 1 values"));
}

TEST_F(MapCommandTest, TellsAllAsJson) {
    const Finished finished = Map({"--json", "-d", "null:flaw"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    const auto json = nlohmann::json::parse(finished.out);
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) {
        keys.push_back(key);
    }
    EXPECT_THAT(
        keys, testing::UnorderedElementsAre("case", "description", "output", "measure", "tolerance",
                                            "x", "y", "fixed", "search", "marks", "devices",
                                            "condition", "disagreement", "prediction", "repeat"));
    EXPECT_EQ(json["x"]["name"], "a");
    EXPECT_EQ(json["x"]["scale"], "linear");
    EXPECT_EQ(json["x"]["edges"].size(), 7u);
    EXPECT_EQ(json["x"]["values"].size(), 6u);
    EXPECT_EQ(json["search"], false);
    EXPECT_EQ(json["marks"].size(), 9u);
    EXPECT_EQ(json["devices"].size(), 2u);
    for (const auto& device : json["devices"]) {
        EXPECT_EQ(device["error"].size(), 24u);
        EXPECT_EQ(device["mark"].size(), 24u);
        EXPECT_EQ(device["mark"][0], 0);
        EXPECT_EQ(device["mark"][5], 1);  // a = 11/12, b = 1/8
        EXPECT_EQ(device["worst"]["output"], "result");
    }
    EXPECT_EQ(json["condition"].size(), 24u);
    EXPECT_EQ(json["disagreement"].size(), 24u);
    EXPECT_EQ(json["prediction"]["cells"][0], 1);
    EXPECT_EQ(json["prediction"]["cells"][5], 2);
    EXPECT_EQ(json["prediction"]["agreement"][1]["failed"], 12);
}

TEST_F(MapCommandTest, DrawsAtMostSoManyCharacters) {
    const Finished finished = Map({"--size", "200x100"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    std::size_t lines = 0;
    for (const std::string& line : Lines(finished.out)) {
        const bool is_picture =
            line.starts_with("    ") && line.find_first_not_of(".x+", 4) == std::string::npos;
        lines += is_picture ? 1 : 0;
        EXPECT_TRUE(!is_picture || line.size() == 4 + 64) << line;
    }
    EXPECT_EQ(lines, 24u);
    EXPECT_THAT(finished.out, HasSubstr("  (up to 4x5 cells each; what fails goes first)\n"));
}

// Of an integer: a line of cells each, and the command that repeats one.
TEST_F(MapCommandTest, MapsWholeNumbers) {
    const auto write = [&](const std::string& safe) {
        folder_.Write("cases/c.toml",
                      "source = \"f.glsl\"\ncall = \"f(a, float(n))\"\noracle = \"min(a, n)\"\n"
                      "accept = { absolute = 1e-3 }\n[domain]\n"
                      "a = { range = [0.0, 4.0], sample = \"linear\", count = 9 }\n"
                      "n = { type = \"int\", range = [1, 3], count = 3 }\n[map]\n"
                      "over = [\"a\", \"n\"]\nsize = [4, 64]\nsafe = \"" +
                          safe + "\"\nbecause = \"theory\"\n");
    };
    write("a <= n");
    const Finished finished = Map({});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("  upwards   n, 3 cells from 1 to 3, linear\n"));
    EXPECT_THAT(finished.out, HasSubstr("\n    ..+x\n    .+xx\n    +xxx\n"));
    write("a < n + 1");
    const Finished wrong = Map({});
    EXPECT_EQ(wrong.status, 1);
    const std::string command = Lines(wrong.err).at(1);
    EXPECT_THAT(command, EndsWith(" --at a=0x1.8p+0,n=1"));
    const Finished again = RunInShell(command.substr(command.find("etalon")), options_);
    EXPECT_THAT(again.out, HasSubstr("refused   1 of 1 values"));
}

// One cell of thousands, and a line of predictions through it.
TEST_F(MapCommandTest, HidesNoFailure) {
    folder_.Write("cases/c.toml",
                  "source = \"f.glsl\"\ncall = \"f(a, b)\"\n"
                  "oracle = \"a + 1.0 * (abs(a - 0.5) < 0.003) * (abs(b - 0.5) < 0.006)\"\n"
                  "accept = { absolute = 1e-3 }\n[domain]\n"
                  "a = { range = [0.0, 1.0], sample = \"linear\", count = 9 }\n"
                  "b = { range = [0.0, 1.0], sample = \"linear\", count = 9 }\n[map]\n"
                  "over = [\"a\", \"b\"]\nsize = [199, 99]\n"
                  "safe = \"b < 0.49\"\nbecause = \"an example\"\n");
    const Finished finished = Map({});
    EXPECT_THAT(finished.out, HasSubstr("(99.99 %), 1 refused"));
    EXPECT_THAT(finished.out,
                HasSubstr("\n    " + std::string(32, '+') + "x" + std::string(31, '+') + "\n"));
}

// What theory says of certain cells is not held against fewer of them.
TEST_F(MapCommandTest, AnotherSizeNeedsNotShowAllOfThePrediction) {
    Write("c", "fails = \"abs(a - 0.75) < 0.01 && b < 0.2\"\nbecause = \"one cell\"\n");
    EXPECT_EQ(Map({}).status, 0);
    const Finished finished = Map({"--size", "3x2"});
    EXPECT_EQ(finished.status, 0) << finished.err;
    EXPECT_THAT(finished.out, HasSubstr("0 of 0 cells that must fail do"));
}

TEST_F(MapCommandTest, ACrashIsAVerdict) {
    const Finished finished = RunEtalon({"map", "c", "-d", "null:crash"}, options_);
    EXPECT_EQ(finished.status, 1);
    EXPECT_THAT(finished.out, HasSubstr("24 crash (100 %)"));
}

TEST_F(MapCommandTest, SaysWhatIsWrong) {
    const auto why = [&](const std::vector<std::string>& words) {
        const Finished finished = Map(words);
        EXPECT_EQ(finished.status, 2);
        EXPECT_EQ(finished.out, "");
        EXPECT_EQ(Lines(finished.err).size(), 1u) << finished.err;
        return finished.err;
    };
    EXPECT_THAT(why({"--over", "a"}), HasSubstr("it reads X,Y"));
    EXPECT_THAT(why({"--size", "3"}), HasSubstr("it reads WIDTHxHEIGHT"));
    EXPECT_THAT(why({"--recipe", "spirv+baked"}), HasSubstr("cannot be constants"));
    EXPECT_THAT(why({"-d", "null:nobody"}), HasSubstr("null:nobody"));
    EXPECT_THAT(why({"--root", "nowhere"}), Not(HasSubstr("terminate")));
    Write("c", "fails = \"a > 2\"\nbecause = \"nothing\"\n");
    EXPECT_THAT(why({}), HasSubstr("c.toml:13: 'fails' is true in no cell of the map"));
    Write("c", "fails = \"a > 0.1\"\nsafe = \"b > 0.1\"\nbecause = \"both\"\n");
    EXPECT_THAT(why({}), HasSubstr("'fails' and 'safe' are both true at a=0x1p-2,b=0x1."));
}

}  // namespace
}  // namespace etalon
