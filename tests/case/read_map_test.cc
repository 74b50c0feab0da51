#include "case/read_map.h"

#include <gmock/gmock.h>

#include "case/case.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

class ReadMapTest : public testing::Test {
  protected:
    static constexpr const char* kCase =
        "source = \"f.glsl\"\ncall = \"f(a, b, n)\"\noracle = \"a\"\naccept = { ulp = 1 }\n"
        "[domain]\n"
        "a = { range = [0.0, 1.0], count = 3 }\n"
        "b = { range = [1.0, 4.0], sample = \"log\", count = 3 }\n"
        "c = { values = [1.0] }\n"
        "n = { type = \"ivec2\", values = [[1, 2]] }\n"
        "[map]\n";
    static constexpr int kMapLine = 11;  // of the first key

    Result<Case> Read(const std::string& keys) {
        folder_.Write("cases/c.toml", kCase + keys);
        return ReadCase(folder_.path(), "c");
    }
    // The reason, after the file.
    std::string Why(const std::string& keys) {
        const auto read = Read(keys);
        return read ? "" : read.error().message.substr(folder_.path().string().size() + 1);
    }

    Folder folder_;
};

TEST_F(ReadMapTest, ReadsEveryKey) {
    const auto read = Read(R"toml(over = ["a", "c"]
ranges = { c = { range = [1e-3, 2.0], sample = "log" } }
at = "b=2,n=3"
size = [5, 7]
output = "result"
spent = "n > 3"
fails = "a > c"
safe = "a < c"
because = "theory"
)toml");
    ASSERT_TRUE(read) << read.error().message;
    ASSERT_TRUE(read->map);
    const CaseMap& map = *read->map;
    EXPECT_EQ(map.x, "a");
    EXPECT_EQ(map.y, "c");
    EXPECT_EQ(map.ranges.at("c").low, 1e-3);
    EXPECT_EQ(map.ranges.at("c").high, 2.0);
    EXPECT_TRUE(map.ranges.at("c").is_log);
    EXPECT_EQ(map.at, "b=2,n=3");
    EXPECT_EQ(map.width, 5u);
    EXPECT_EQ(map.height, 7u);
    EXPECT_EQ(map.output, "result");
    EXPECT_EQ(map.spent, "n > 3");
    EXPECT_EQ(map.fails->expression.text(), "a > c");
    EXPECT_EQ(map.safe->expression.text(), "a < c");
    EXPECT_EQ(map.safe->place.line, kMapLine + 7);
    EXPECT_EQ(map.because, "theory");
}

TEST_F(ReadMapTest, TakesTheDomainsRanges) {
    const auto read = Read("over = [\"a\", \"b\"]\n");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->map->width, 96u);
    EXPECT_EQ(read->map->height, 64u);
    EXPECT_FALSE(read->map->fails || read->map->safe);
    const auto a = OwnMapRange(read->domains, "a");
    const auto b = OwnMapRange(read->domains, "b");
    EXPECT_FALSE(a->is_log);  // bits count as linear
    EXPECT_TRUE(b->is_log);
    EXPECT_EQ(b->high, 4.0);
    EXPECT_FALSE(OwnMapRange(read->domains, "c"));
}

TEST_F(ReadMapTest, IsNotInherited) {
    ASSERT_TRUE(Read("over = [\"a\", \"b\"]\n"));
    folder_.Write("cases/other.toml", "like = \"c\"\n");
    const auto other = ReadCase(folder_.path(), "other");
    ASSERT_TRUE(other) << other.error().message;
    EXPECT_FALSE(other->map);

    folder_.Write("cases/own.part.toml", "[map]\nover = [\"a\", \"b\"]\n");
    folder_.Write("cases/third.toml", "like = \"own.part.toml\"\n");
    const auto third = ReadCase(folder_.path(), "third");
    ASSERT_FALSE(third);
    EXPECT_THAT(third.error().message,
                EndsWith("own.part.toml:1: 'map' belongs to a case, and this is a part"));
}

TEST_F(ReadMapTest, SaysWhatIsWrongAndWhere) {
    const std::string over = "over = [\"a\", \"b\"]\n";
    EXPECT_EQ(Why(""), "cases/c.toml:10: 'over' is missing: it names the two inputs of the map");
    EXPECT_EQ(Why("over = [\"a\"]\n"), "cases/c.toml:11: 'over' must name two inputs");
    EXPECT_EQ(Why("over = [\"a\", \"a\"]\n"), "cases/c.toml:11: 'over' names 'a' twice");
    EXPECT_THAT(Why("over = [\"a\", \"bb\"]\n"),
                HasSubstr("cases/c.toml:11: 'over': the case has no input 'bb'"));
    EXPECT_EQ(
        Why("over = [\"a\", \"n\"]\n"),
        "cases/c.toml:11: 'over': 'n' is of type ivec2, and a map is over floats or integers");
    EXPECT_EQ(Why("over = [\"a\", \"c\"]\n"),
              "cases/c.toml:11: 'over': 'c' has no range in the domain; 'ranges' gives one");
    EXPECT_THAT(Why(over + "rangs = {}\n"), HasSubstr("cases/c.toml:12: unknown key 'rangs'"));
    EXPECT_EQ(Why(over + "ranges = { a = { range = [1.0, 0.0] } }\n"),
              "cases/c.toml:12: 'ranges': 'a': the range's ends are not in order");
    EXPECT_EQ(Why(over + "ranges = { a = { range = [0.0, 1.0], sample = \"log\" } }\n"),
              "cases/c.toml:12: 'ranges': 'a': a logarithmic range must be positive");
    EXPECT_EQ(Why(over + "ranges = { a = { range = [0.0, 1e40] } }\n"),
              "cases/c.toml:12: 'ranges': 'a': the ends of the range must be finite floats");
    EXPECT_EQ(Why(over + "ranges = { a = { range = [0.0] } }\n"),
              "cases/c.toml:12: 'ranges': 'a': 'range' must be [low, high]");
    EXPECT_EQ(Why(over + "ranges = { a = { sample = \"log\" } }\n"),
              "cases/c.toml:12: 'ranges': 'a': 'range' is missing");
    EXPECT_EQ(Why(over + "ranges = { a = { range = [0.0, 1.0], sample = \"sphere\" } }\n"),
              "cases/c.toml:12: 'ranges': 'a': 'sample' must be linear or log");
    EXPECT_EQ(Why(over + "ranges = { c = { range = [0.0, 1.0] } }\n"),
              "cases/c.toml:12: 'ranges': 'c' is not what the map is over");
    EXPECT_THAT(Why(over + "size = [0, 4]\n"), HasSubstr("cases/c.toml:12: 'size' must be"));
    EXPECT_THAT(Why(over + "size = [4, 1025]\n"), HasSubstr("cases/c.toml:12: 'size' must be"));
    EXPECT_THAT(Why(over + "size = [4]\n"), HasSubstr("cases/c.toml:12: 'size' must be"));
    EXPECT_THAT(Why(over + "because = \"b\"\nfails = \"a > d\"\n"),
                HasSubstr("cases/c.toml:13:14: 'd' is no input"));
    EXPECT_THAT(Why(over + "because = \"b\"\nsafe = \"vec2(a, b)\"\n"),
                HasSubstr("cases/c.toml:13: 'vec2(a, b)' has 2 components, not 1"));
    EXPECT_THAT(Why(over + "safe = \"a > b\"\n"),
                HasSubstr("cases/c.toml:10: 'because' is missing"));
    EXPECT_THAT(Why(over + "because = \"b\"\n"),
                HasSubstr("cases/c.toml:12: 'because' belongs to 'fails' or 'safe'"));
    EXPECT_EQ(Why(over + "at = \"\"\n"), "cases/c.toml:12: 'at' is empty");
}

}  // namespace
}  // namespace etalon
