#include "base/file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::size_t EntriesIn(const std::filesystem::path& folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) {
        ++count;
    }
    return count;
}

TEST(ReadFile, ReturnsEveryByte) {
    const Folder folder;
    std::string content(200'000, 'x');
    content[70'000] = '\0';
    content.back() = '\xff';
    const auto read = ReadFile(folder.Write("bytes", content));
    ASSERT_TRUE(read);
    EXPECT_EQ(*read, content);
    EXPECT_EQ(*ReadFile(folder.Write("empty", "")), "");
}

TEST(ReadFile, NamesThePathAndTheReason) {
    const Folder folder;
    const std::string missing = (folder.path() / "missing").string();
    EXPECT_EQ(ReadFile(missing).error().message, missing + ": No such file or directory");
    EXPECT_EQ(ReadFile(folder.path()).error().message,
              folder.path().string() + ": is a folder, not a file");
    const std::string below = folder.Write("file", "") + "/below";
    EXPECT_EQ(ReadFile(below).error().message, below + ": Not a directory");
}

TEST(ReadTextFile, RefusesANulByte) {
    const Folder folder;
    EXPECT_EQ(*ReadTextFile(folder.Write("text", "a\xc3\xa9\n")), "a\xc3\xa9\n");
    const std::string path = folder.Write("binary", std::string("a\0b", 3));
    EXPECT_EQ(ReadTextFile(path).error().message, path + ": is not text (it holds a NUL byte)");
}

TEST(WriteFile, ReplacesTheOldContentByRename) {
    const Folder folder;
    const std::string path = folder.Write("report", "an old and longer content");
    struct stat before = {};
    ASSERT_EQ(stat(path.c_str(), &before), 0);
    // Whoever has the old file open keeps the old content whole.
    std::ifstream reader(path);
    ASSERT_TRUE(WriteFile(path, "new"));
    EXPECT_EQ(folder.Read("report"), "new");
    std::string old;
    std::getline(reader, old);
    EXPECT_EQ(old, "an old and longer content");
    struct stat after = {};
    ASSERT_EQ(stat(path.c_str(), &after), 0);
    EXPECT_NE(before.st_ino, after.st_ino);
    EXPECT_EQ(EntriesIn(folder.path()), 1u);
}

TEST(WriteFile, CreatesWhatIsMissingAndNoFolder) {
    const Folder folder;
    ASSERT_TRUE(WriteFile(folder.path() / "new", std::string("a\0b", 3)));
    EXPECT_EQ(folder.Read("new"), std::string("a\0b", 3));
    const std::string below = (folder.path() / "no/such").string();
    const auto written = WriteFile(below, "x");
    ASSERT_FALSE(written);
    EXPECT_THAT(written.error().message, StartsWith(below + ": "));
    EXPECT_THAT(written.error().message, HasSubstr("No such file or directory"));
}

TEST(WriteFile, LeavesTheOldContentWhereTheNewDoesNotFit) {
    const Folder folder;
    const std::string path = folder.Write("report", "old");
    std::filesystem::permissions(
        folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    const bool may_write_anyway = geteuid() == 0;
    const auto written = WriteFile(path, "new");
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
    if (!may_write_anyway) {
        EXPECT_FALSE(written);
        EXPECT_EQ(folder.Read("report"), "old");
    }
    EXPECT_EQ(EntriesIn(folder.path()), 1u);
}

TEST(WriteFile, TellsOfAFullDisk) {
    const auto written = WriteFile("/dev/full", "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, "/dev/full: No space left on device");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

TEST(WriteFile, WritesADeviceInPlace) {
    EXPECT_TRUE(WriteFile("/dev/null", "x"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WriteFile, RefusesAFolder) {
    const Folder folder;
    EXPECT_EQ(WriteFile(folder.path(), "x").error().message,
              folder.path().string() + ": is a folder, not a file");
}

TEST(WriteFile, FollowsALink) {
    const Folder folder;
    folder.Write("target", "old");
    std::filesystem::create_symlink("target", folder.path() / "link");
    ASSERT_TRUE(WriteFile(folder.path() / "link", "new"));
    EXPECT_EQ(folder.Read("link"), "new");
}

TEST(GlobMatches, KnowsStarsAndQuestionMarks) {
    const struct {
        const char* pattern;
        const char* text;
        bool matches;
    } kRows[] = {
        {"", "", true},
        {"", "a", false},
        {"a", "", false},
        {"*", "", true},
        {"**", "abc", true},
        {"?", "", false},
        {"?", "a", true},
        {"?", "ab", false},
        {"a?c", "abc", true},
        {"a?c", "ac", false},
        {"a*c", "ac", true},
        {"a*c", "abbbc", true},
        {"a*c", "abcd", false},
        {"*ab", "aab", true},
        {"*ab*", "aacaba", true},
        {"a*b*c", "a-b-b-c-c", true},
        {"a*b*c", "a-c-b", false},
        {"vulkan:*", "vulkan:llvmpipe", true},
        {"vulkan:*", "vulkan", false},
        {"*:llvmpipe", "osmesa:llvmpipe@new", false},
        {"a.c", "abc", false},  // a dot is a dot
        {"[a]", "a", false},    // and a bracket a bracket
        {"*", "a*", true},
        {"a*", "*", false},
        {"law 'x*'", "law 'x y'", true},
    };
    for (const auto& row : kRows) {
        EXPECT_EQ(GlobMatches(row.pattern, row.text), row.matches)
            << row.pattern << " " << row.text;
    }
}

TEST(GlobMatches, IsQuickWhereThereAreManyStars) {
    std::string pattern;
    for (int i = 0; i < 50; ++i) {
        pattern += "*a";
    }
    EXPECT_FALSE(GlobMatches(pattern + "b", std::string(5'000, 'a')));
}

TEST(ProgramPath, IsThisProgram) {
    EXPECT_EQ(ProgramPath().filename(), "test_base_file");
}

}  // namespace
}  // namespace etalon
