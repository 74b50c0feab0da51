#include "case/like.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "case/case.h"

namespace etalon {
namespace {

using testing::ElementsAre;

class LikeTest : public testing::Test {
  protected:
    void SetUp() override {
        root_ = std::filesystem::path(testing::TempDir()) /
                ("like_test_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(root_ / "cases/deep");
        Write("hardened", R"toml(description = "the hardened one"
source = "shaders/f.glsl"
call = "f(x)"
oracle = "x"
accept = { ulp = 2 }
covers = ["F1"]
like = "deep/inputs.part.toml"
[[expected_failure]]
device = "*"
status = "bug"
cause = "why"
)toml");
        Write("deep/inputs.part", R"toml(seed = 7
description = "never seen"
with = ["cases/scene.glsl"]
[domain]
x = { range = [0.0, 1.0], count = 8 }
y = { values = [1.0] }
)toml");
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    void Write(const std::string& path, const std::string& text) {
        EXPECT_TRUE(WriteFile(root_ / "cases" / (path + ".toml"), text));
    }
    std::string Complaint(const std::string& path) const {
        const auto read = ReadCase(root_, path);
        if (read) {
            return "";
        }
        std::string message = read.error().message;
        const std::string root = root_.string() + "/";
        for (std::size_t at = message.find(root); at != std::string::npos;
             at = message.find(root, at)) {
            message.erase(at, root.size());
        }
        return message;
    }

    std::filesystem::path root_;
};

TEST_F(LikeTest, TakesKeysFromFileToFile) {
    const auto hardened = ReadCase(root_, "hardened");
    ASSERT_TRUE(hardened) << hardened.error().message;
    EXPECT_EQ(hardened->seed, 7u);
    EXPECT_EQ(hardened->like, "") << "a part is no case";
    EXPECT_EQ(hardened->description, "the hardened one");
    EXPECT_THAT(hardened->covers, ElementsAre("F1"));

    Write("deep/published", R"toml(like = "../hardened.toml"
source = "shaders/published.glsl"
covers = ["D1"]
accept = { absolute = 0.5 }
)toml");
    const auto published = ReadCase(root_, "deep/published");
    ASSERT_TRUE(published) << published.error().message;
    EXPECT_EQ(published->path, "deep/published");
    EXPECT_EQ(published->like, "hardened");
    EXPECT_EQ(published->source, "shaders/published.glsl");
    EXPECT_EQ(published->call, "f(x)");
    EXPECT_EQ(published->seed, 7u);
    EXPECT_THAT(published->with, ElementsAre("cases/scene.glsl"));
    EXPECT_THAT(published->covers, ElementsAre("D1"));
    EXPECT_TRUE(published->expected_failures.empty());
    ASSERT_EQ(published->domains.size(), 1u);
    EXPECT_EQ(published->domains[0].inputs.size(), 2u);
    EXPECT_EQ(published->expectations[0].accept.Text(), "absolute 0.5");
}

TEST_F(LikeTest, TakesAnAddressToo) {
    Write("deep/same", "like = \"hardened\"\n");
    EXPECT_EQ(Complaint("deep/same"), "");
    Write("deep/judged",
          "like = \"deep/inputs.part\"\nsource = \"s\"\ncall = \"f(x)\"\n"
          "[[law]]\nname = \"l\"\nholds = \"f(x) < 1\"\n");
    EXPECT_EQ(Complaint("deep/judged"), "");
}

TEST_F(LikeTest, ReplacesAWholeDomain) {
    Write("one", "like = \"hardened.toml\"\n[domain]\nx = { values = [3.0] }\n");
    const auto one = ReadCase(root_, "one");
    ASSERT_TRUE(one) << one.error().message;
    ASSERT_EQ(one->domains.size(), 1u);
    EXPECT_EQ(one->domains[0].inputs.size(), 1u);
}

TEST_F(LikeTest, NamesTheFileOfWhatIsWrong) {
    Write("wrong.part", "\n[domain]\nx = { values = [] }\n");
    Write("takes", "like = \"wrong.part.toml\"\nsource = \"s\"\ncall = \"f(x)\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/wrong.part.toml:3: input 'x': 'values' is empty: the domain has no rows");
    Write("wrong.part", "call = \"f(x)\"\noracle = \"x + y\"\naccept = { ulp = 1 }\n");
    Write("takes", "like = \"wrong.part.toml\"\nsource = \"s\"\n[domain]\nx = { values = [1] }\n");
    EXPECT_EQ(Complaint("takes"), "cases/wrong.part.toml:2:15: 'y' is no input");
    Write("wrong.part", "\ncal = \"f(x)\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/wrong.part.toml:2: unknown key 'cal'; did you mean 'call'?");
    Write("wrong.part", "call = \n");
    EXPECT_THAT(Complaint("takes"), testing::StartsWith("cases/wrong.part.toml:1:"));
    Write("wrong.part", "\ncovers = [\"F1\"]\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/wrong.part.toml:2: 'covers' belongs to a case, and this is a part");

    Write("takes",
          "like = \"deep/inputs.part.toml\"\nsource = \"s\"\ncall = \"f(x)\"\n"
          "oracle = \"x\"\naccept = { absolute = 9 }\n");
    const auto takes = ReadCase(root_, "takes");
    ASSERT_TRUE(takes) << takes.error().message;
    const auto table = Expand(takes->domains, 1);
    ASSERT_TRUE(table) << table.error().message;
    const auto blind = CheckAcceptance(*takes, *table);
    ASSERT_FALSE(blind);
    EXPECT_THAT(blind.error().message,
                testing::HasSubstr("cases/takes.toml:5: nothing could fail"));
}

TEST_F(LikeTest, RefusesWhatIsMissingAndCircles) {
    Write("takes", "source = \"s\"\nlike = \"nowhere.toml\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/takes.toml:2: 'like': there is no file cases/nowhere.toml");
    Write("takes", "like = \"no/where\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/takes.toml:1: 'like': there is no file cases/no/where.toml");
    Write("takes", "like = 3\n");
    EXPECT_EQ(Complaint("takes"), "cases/takes.toml:1: 'like' must be a text in quotes");
    Write("takes", "like = \"deep/back.toml\"\n");
    Write("deep/back", "like = \"../takes.toml\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/deep/back.toml:1: 'like' leads in a circle: cases/takes.toml is like "
              "cases/deep/back.toml is like cases/takes.toml");
    Write("takes", "like = \"takes.toml\"\n");
    EXPECT_EQ(Complaint("takes"),
              "cases/takes.toml:1: 'like' leads in a circle: cases/takes.toml is like "
              "cases/takes.toml");
}

}  // namespace
}  // namespace etalon
