#include "run/read_catalogue.h"

#include <gmock/gmock.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;

class ReadCatalogueTest : public testing::Test {
  protected:
    std::string Complaint(const std::string& text) {
        folder_.Write("shaders/catalogue.toml", text);
        const auto read = ReadCatalogue(folder_.path());
        return read ? "" : read.error().message.substr(folder_.path().string().size() + 1);
    }
    Folder folder_;
};

TEST_F(ReadCatalogueTest, KeepsTheOrder) {
    EXPECT_EQ(Complaint("[F2]\nname = \"two\"\nsource = \"s\"\n[D1]\nname = \"one\"\n"
                        "source = \"t\"\nseen = \"by reading\"\nreason = \"why\"\n"),
              "");
    const auto entries = ReadCatalogue(folder_.path());
    ASSERT_EQ(entries->size(), 2u);
    EXPECT_EQ((*entries)[0].id, "F2");
    EXPECT_EQ((*entries)[0].name, "two");
    EXPECT_EQ((*entries)[0].reason, "");
    EXPECT_EQ((*entries)[1].source, "t");
    EXPECT_EQ((*entries)[1].reason, "why");
}

TEST_F(ReadCatalogueTest, SaysWhatIsWrong) {
    const std::string at = "shaders/catalogue.toml:";
    const std::string head = "[F2]\nname = \"two\"\nsource = \"s\"\n";
    EXPECT_EQ(Complaint("[F2]\nsource = \"s\"\n"), at + "1: 'name' is missing");
    EXPECT_EQ(Complaint("[F2]\nname = \"n\"\n"), at + "1: 'source' is missing");
    EXPECT_EQ(Complaint(head + "sauce = 1\n"),
              at + "4: unknown key 'sauce'; did you mean 'source'?");
    EXPECT_EQ(Complaint(head + "seen = \"by chance\"\n"), at + "4: 'seen' must be \"by reading\"");
    EXPECT_EQ(Complaint(head + "seen = \"by reading\"\n"), at + "1: 'reason' is missing");
    EXPECT_EQ(Complaint(head + "reason = \"r\"\n"),
              at + "4: 'reason' belongs to seen = \"by reading\"");
    EXPECT_EQ(Complaint("F2 = 1\n"), at + "1: 'F2' must be a table");
    EXPECT_THAT(ReadCatalogue(folder_.path() / "no").error().message,
                HasSubstr("catalogue.toml: No such file"));
}

TEST_F(ReadCatalogueTest, RefusesIdsThatItDoesNotHave) {
    Case source;
    source.covers = {"F2", "F3"};
    source.covers_place = {"cases/x.toml", 4};
    EXPECT_TRUE(CheckCovers(source, {{"F2", "", "", ""}, {"F3", "", "", ""}}));
    const auto checked = CheckCovers(source, {{"F2", "", "", ""}});
    ASSERT_FALSE(checked);
    EXPECT_EQ(checked.error().message, "cases/x.toml:4: 'covers': the catalogue has no F3");
}

// The kit's own: every id of the sources.
TEST(Catalogue, ListsEveryId) {
    const auto entries = ReadCatalogue("");
    ASSERT_TRUE(entries) << entries.error().message;
    std::vector<std::string> expected;
    const std::pair<const char*, int> kinds[] = {{"F", 15}, {"G", 23}, {"H", 8},
                                                 {"O", 10}, {"B", 7},  {"D", 53}};
    for (const auto& [letter, count] : kinds) {
        for (int i = 1; i <= count; ++i) {
            expected.push_back(letter + std::to_string(i));
        }
    }
    std::vector<std::string> ids;
    for (const CatalogueEntry& entry : *entries) {
        ids.push_back(entry.id);
    }
    EXPECT_EQ(ids, expected);
}

}  // namespace
}  // namespace etalon
