#include "chart/family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;
using testing::SizeIs;

constexpr const char* kShort = R"toml(oracle = "x * x"
domain = { x = { range = [0.0, 1.0], count = 8 } }
[[member]]
name = "product"
source = "a.glsl"
call = "a(x)"
[[member]]
name = "power"
source = "b.glsl"
call = "b(x)"
[[member]]
name = "sum"
source = "c.glsl"
call = "c(x)"
)toml";

constexpr const char* kFull = R"toml(quantity = "way"
description = "all of it"
measure = "absolute"
unit = "texels"
published_unit = "ms"
reference = { member = "linear", settings = { STEPS = 16, BIAS = 0.5 } }
source = "f.glsl"
call = "f(x)"
oracle = "x"
accept = { absolute = 0.5, missed = 0.1, beyond = 1.0 }
with = ["scene.glsl"]
include = ["one"]
define = { A = "1", B = "2" }
at = "y=3"

[domain]
x = { range = [0.0, 1.0], count = 8 }
y = { values = [1.0, 2.0] }
v = { type = "vec2", range = [0.0, 1.0], count = 4 }

[[scene]]
name = "plane"
description = "flat"
define = { B = "3", C = "4" }

[[scene]]
name = "ramp"
oracle = "x + y"
at = "v.x=1,v.y=2"

[[member]]
name = "linear"
description = "steps"
settings = { STEPS = [8, 16], BIAS = [0.5, 1.0] }
include = ["two"]
at = "y=4"

[[member]]
name = "other"
source = "g.glsl"
define = { C = "5" }
published = 22.8
)toml";

class FamilyTest : public testing::Test {
  protected:
    FamilyTest() {
        for (const char* const folder : {"", "mine/"}) {
            for (const char* const source : {"a", "b", "c", "f", "g", "scene"}) {
                folder_.Write(folder + std::string(source) + ".glsl", "");
            }
        }
    }
    Result<Family> Read(const std::string& text) {
        folder_.Write("cases/t/f.family.toml", text);
        return ReadFamily(folder_.path(), folder_.path() / "cases/t/f.family.toml");
    }
    // The error, without the folder's name.
    std::string Complaint(const std::string& text) {
        const auto family = Read(text);
        return family ? "" : family.error().message.substr(folder_.path().string().size() + 1);
    }
    static std::string With(const std::string& text, const std::string& from,
                            const std::string& to) {
        const std::size_t at = text.find(from);
        EXPECT_NE(at, std::string::npos) << from;
        return std::string(text).replace(at, from.size(), to);
    }

    Folder folder_;
};

TEST_F(FamilyTest, AShortOneNamesFunctionsOnly) {
    const auto family = Read(kShort);
    ASSERT_TRUE(family.ok()) << family.error().message;
    EXPECT_EQ(family->address, "t/f");
    EXPECT_THAT(family->points, SizeIs(3));
    EXPECT_THAT(family->scenes, SizeIs(1));
    EXPECT_EQ(family->scenes[0].name, "");
    EXPECT_EQ(family->points[2].label, "sum");
    EXPECT_EQ(family->points[2].cases[0].call, "c(x)");
    EXPECT_EQ(family->points[2].cases[0].source, "c.glsl");
    EXPECT_EQ(family->reference, 0u);
    EXPECT_TRUE(family->has_truth);
    EXPECT_FALSE(family->is_judged);
    EXPECT_FALSE(family->is_search);
    EXPECT_EQ(family->measure, ErrorMeasure::kAbsolute);
}

TEST_F(FamilyTest, PointsAreMembersBySettingsByScenes) {
    const auto family = Read(kFull);
    ASSERT_TRUE(family.ok()) << family.error().message;
    std::vector<std::string> labels;
    for (const FamilyPoint& point : family->points) {
        labels.push_back(point.label);
        EXPECT_THAT(point.cases, SizeIs(2));
    }
    EXPECT_THAT(labels,
                ElementsAre("linear, STEPS=8, BIAS=0.5", "linear, STEPS=8, BIAS=1.0",
                            "linear, STEPS=16, BIAS=0.5", "linear, STEPS=16, BIAS=1.0", "other"));
    EXPECT_EQ(family->points[1].settings[1].number, 1.0);
    EXPECT_TRUE(family->is_search);
    EXPECT_EQ(family->members[1].published, 22.8);
    EXPECT_EQ(family->unit, "texels");
    EXPECT_EQ(family->scenes[0].description, "flat");
}

TEST_F(FamilyTest, KeysLieOverEachOther) {
    const auto family = Read(kFull);
    ASSERT_TRUE(family.ok()) << family.error().message;
    EXPECT_EQ(family->reference, 2u);
    const Case& linear = family->points[0].cases[0];
    EXPECT_THAT(linear.define, ElementsAre(Pair("A", "1"), Pair("B", "3"), Pair("BIAS", "0.5"),
                                           Pair("C", "4"), Pair("STEPS", "8")));
    EXPECT_THAT(linear.include, ElementsAre("one", "two"));
    EXPECT_THAT(linear.with, ElementsAre("scene.glsl"));
    EXPECT_EQ(linear.expectations[0].truth->text(), "x");
    EXPECT_THAT(linear.domains[0].inputs[1].values, ElementsAre(ElementsAre(4.0)));
    EXPECT_TRUE(linear.domains[0].inputs[2].range.has_value());
    const Case& other = family->points[4].cases[1];
    EXPECT_THAT(other.define, ElementsAre(Pair("A", "1"), Pair("B", "2"), Pair("C", "5")));
    EXPECT_EQ(other.source, "g.glsl");
    EXPECT_EQ(other.expectations[0].truth->text(), "x + y");
    EXPECT_THAT(other.domains[0].inputs[1].values, ElementsAre(ElementsAre(3.0)));
    EXPECT_THAT(other.domains[0].inputs[2].values, ElementsAre(ElementsAre(1.0, 2.0)));
}

TEST_F(FamilyTest, TakesTheKeysOfWhatItIsLike) {
    folder_.Write("cases/t/c.toml",
                  "source = \"a.glsl\"\ncall = \"a(x)\"\noracle = \"x\"\naccept = { ulp = 1 }\n"
                  "[domain]\nx = { values = [1.0] }\n[[law]]\nname = \"l\"\nholds = \"x == x\"\n");
    const auto family = Read(
        "like = \"c.toml\"\noracle = \"x + 1\"\n[[member]]\nname = \"a\"\n[[member]]\nname = "
        "\"b\"\n"
        "call = \"b(x)\"\n");
    ASSERT_TRUE(family.ok()) << family.error().message;
    const Case& b = family->points[1].cases[0];
    EXPECT_EQ(b.call, "b(x)");
    EXPECT_EQ(b.expectations[0].truth->text(), "x + 1");
    EXPECT_TRUE(b.laws.empty());
    EXPECT_TRUE(family->is_judged);
    EXPECT_EQ(Complaint("like = \"d.toml\"\n[[member]]\nname = \"a\"\n"),
              "cases/t/f.family.toml:1: 'like': there is no file " + folder_.path().string() +
                  "/cases/t/d.toml");
    EXPECT_EQ(Complaint("[[member]]\nname = \"a\"\nlike = \"c.toml\"\n"),
              "cases/t/f.family.toml:3: unknown key 'like'");
}

TEST_F(FamilyTest, WithoutAnOracleThereAreNoErrors) {
    const auto family = Read(With(kShort, "oracle = \"x * x\"\n", ""));
    ASSERT_TRUE(family.ok()) << family.error().message;
    EXPECT_FALSE(family->has_truth);
    EXPECT_TRUE(family->points[0].cases[0].expectations.empty());
}

TEST_F(FamilyTest, MistakesAreToldInOneLine) {
    const std::string file = "cases/t/f.family.toml:";
    EXPECT_EQ(Complaint("quantiy = \"x\"\n[[member]]\nname = \"a\"\n"),
              file + "1: unknown key 'quantiy'; did you mean 'quantity'?");
    EXPECT_EQ(Complaint(With(kShort, "call = \"b(x)\"", "cal = \"b(x)\"")),
              file + "10: unknown key 'cal'; did you mean 'call'?");
    EXPECT_EQ(Complaint(With(kShort, "name = \"power\"\n", "")),
              file + "7: a member without a 'name'");
    EXPECT_EQ(Complaint(With(kShort, "\"power\"", "\"product\"")),
              file + "7: two members are called 'product'");
    EXPECT_EQ(Complaint(With(kShort, "call = \"b(x)\"\n", "")),
              file + "7: member 'power' has no 'call', and neither has the family");
    EXPECT_EQ(Complaint(With(kShort, "range = [0.0, 1.0], count = 8", "values = []")),
              file + "2: input 'x': 'values' is empty: the domain has no rows");
    EXPECT_EQ(Complaint(With(kShort, "domain = ", "# ")), file + "1: [domain] is missing");
    EXPECT_EQ(Complaint(With(kShort, "x * x", "x * y")), file + "1:15: 'y' is no input");
    EXPECT_EQ(Complaint("reference = \"powr\"\n" + std::string(kShort)),
              file + "1: 'reference' names no member: 'powr'; did you mean 'power'?");
    EXPECT_EQ(Complaint("at = \"y=1\"\n" + std::string(kShort)),
              file + "1: 'at': the case has no input 'y'");
    EXPECT_EQ(Complaint("at = 1\n" + std::string(kShort)),
              file + "1: 'at' must be a text in quotes");
    EXPECT_EQ(Complaint("measure = \"percent\"\n" + std::string(kShort)),
              file + "1: 'measure' must be absolute, relative or ulp");
    EXPECT_EQ(Complaint("recipes = [\"spirv\", \"spirv+O\"]\n" + std::string(kShort)),
              file + "1: 'recipes': a chart has one");
    EXPECT_THAT(Complaint("recipes = [\"spirw\"]\n" + std::string(kShort)),
                testing::StartsWith(file + "1: unknown recipe 'spirw': "));
    EXPECT_EQ(Complaint(With(kShort, "\"b.glsl\"", "\"d.glsl\"")),
              file + "9: 'source': there is no file " + (folder_.path() / "d.glsl").string());
    EXPECT_EQ(Complaint(With(kFull, "[\"scene.glsl\"]", "[\"d.glsl\"]")),
              file + "11: 'with': there is no file " + (folder_.path() / "d.glsl").string());
    EXPECT_EQ(Complaint(With(kFull, "[8, 16]", "[99999999999]")),
              file + "34: setting 'STEPS': 99999999999 is no integer of 32 bits");
    EXPECT_THAT(Complaint("map = { over = [\"x\", \"y\"] }\n" + std::string(kShort)),
                HasSubstr("1: unknown key 'map'"));
    EXPECT_EQ(Complaint(With(kShort, "call = \"b(x)\"", "call = \"b(x)\"\nrecipes = [\"spirv\"]")),
              file + "7: 'recipes': all members have the same in all scenes");
    EXPECT_EQ(Complaint("oracle = \"x\"\ndomain = { x = { values = [1] } }\n"),
              file + "1: a family has members: [[member]] is missing");
    EXPECT_EQ(Complaint(With(kFull, "[8, 16]", "8")), file + "34: setting 'STEPS' must be a list");
    EXPECT_EQ(Complaint(With(kFull, "[8, 16]", "[]")), file + "34: setting 'STEPS' has no values");
    EXPECT_EQ(Complaint(With(kFull, "[8, 16]", "[8, 8]")),
              file + "31: two points are called 'linear, STEPS=8, BIAS=0.5'");
    EXPECT_EQ(Complaint(With(kFull, "STEPS = 16, BIAS = 0.5 }", "STEPS = 4 }")),
              file + "6: 'reference' names no point: 'linear, STEPS=4'");
    EXPECT_EQ(Complaint(With(kFull, "STEPS = 16, BIAS = 0.5 }", "STEPS = 16 }")),
              file + "6: 'reference' names 2 points; the first is 'linear, STEPS=16, BIAS=0.5'");
    EXPECT_EQ(Complaint(With(kFull, "\"ramp\"", "\"plane\"")),
              file + "26: two scenes are called 'plane'");
    EXPECT_EQ(Complaint(With(kFull, "\"ramp\"", "\"all\"")),
              file + "26: 'all' is the name of all scenes together");
    EXPECT_EQ(Complaint(With(kFull, "v.x=1,v.y=2", "v.x=1")),
              file + "29: 'at': of 'v' not all components are given");
    EXPECT_EQ(Complaint(With(kFull, "include = [\"two\"]", "published = 1")),
              file + "35: 'published' is one figure, and the member has 4 points");
    EXPECT_EQ(Complaint(With(kShort, "call = \"b(x)\"", "call = \"b(x)\"\naccept = { ulp = 1 }")),
              file + "7: all members have an 'accept' in all scenes, or none has");
    EXPECT_THAT(Complaint("covers = [\"F1\"]\n" + std::string(kShort)),
                HasSubstr("1: unknown key 'covers'"));
}

TEST_F(FamilyTest, IsFoundByAddressAndByFile) {
    folder_.Write("cases/t/f.family.toml", kShort);
    folder_.Write("cases/t/c.toml", "");
    folder_.Write("mine/own.toml", kShort);
    const auto by_address = FindFamily(folder_.path(), "t/f");
    ASSERT_TRUE(by_address.ok());
    EXPECT_EQ(by_address->file, folder_.path() / "cases/t/f.family.toml");
    const auto by_file = FindFamily("", by_address->file.string());
    ASSERT_TRUE(by_file.ok());
    EXPECT_TRUE(std::filesystem::equivalent(by_file->root, folder_.path()));
    const auto own = FindFamily("", (folder_.path() / "mine/own.toml").string());
    ASSERT_TRUE(own.ok());
    EXPECT_EQ(own->root, folder_.path() / "mine");
    const auto family = ReadFamily(own->root, own->file);
    ASSERT_TRUE(family.ok()) << family.error().message;
    EXPECT_EQ(family->address, "own");
    EXPECT_EQ(FindFamily(folder_.path(), "t/g").error().message,
              "no family is called 't/g'; did you mean 't/f'?");
    EXPECT_EQ(FindFamily("", "nowhere.toml").error().message, "there is no file nowhere.toml");
    EXPECT_THAT(*ListFamilies(folder_.path()), ElementsAre("t/f"));
    EXPECT_THAT(*ListCases(folder_.path()), ElementsAre("t/c"));
}

}  // namespace
}  // namespace etalon
