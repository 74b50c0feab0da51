#include "device/vulkan/icd.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "base/file.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;

class Icd : public testing::Test {
  protected:
    Icd() {
        std::string name = (fs::path(testing::TempDir()) / "icd-XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    ~Icd() override { fs::remove_all(folder_); }

    Result<IcdManifest> Read(const std::string& name, const std::string& json) {
        EXPECT_TRUE(WriteFile(folder_ / name, json).ok());
        return ReadIcdManifest(folder_ / name);
    }

    fs::path folder_;
};

TEST_F(Icd, KeepsAbsolutePathsAndBareNames) {
    const auto absolute = Read("a.json", R"({"ICD": {"library_path" : "/lib/liba.so"}})");
    ASSERT_TRUE(absolute.ok());
    EXPECT_EQ(absolute->library, "/lib/liba.so");
    EXPECT_FALSE(absolute->foreign);
    const auto bare = Read("b.json", R"({"ICD":{"library_path":"libGLX_nvidia.so.0"}})");
    ASSERT_TRUE(bare.ok());
    EXPECT_EQ(bare->library, "libGLX_nvidia.so.0");
}

TEST_F(Icd, ReadsRelativePathsFromItsOwnFolder) {
    const auto manifest = Read("c.json", R"({"ICD": {"library_path": "./sub/../libc.so"}})");
    ASSERT_TRUE(manifest.ok());
    EXPECT_EQ(manifest->library, (folder_ / "libc.so").string());
}

TEST_F(Icd, ReadsEscapes) {
    const auto manifest = Read("d.json", R"({"ICD": {"library_path": "\/a \"b\"\\c.so"}})");
    ASSERT_TRUE(manifest.ok());
    EXPECT_EQ(manifest->library, "/a \"b\"\\c.so");
}

TEST_F(Icd, KnowsOtherArchitectures) {
    const std::string json = R"({"ICD": {"library_path": "liba.so"}})";
    EXPECT_TRUE(Read("x_icd.s390x.json", json)->foreign);
    EXPECT_FALSE(Read("x_icd.json", json)->foreign);
    EXPECT_FALSE(Read("x_icd.v2.json", json)->foreign);
    EXPECT_TRUE(
        Read("e.json", R"({"ICD": {"library_path": "liba.so", "library_arch": "16"}})")->foreign);
}

TEST_F(Icd, RefusesWhatNamesNoLibrary) {
    for (const char* json :
         {"", "{}", "nonsense", R"({"ICD": {"library_path": 7}})", R"({"library_path": "cut)",
          R"({"library_path": ""})", R"("library_path")", R"({"library_path")"}) {
        const auto manifest = Read("f.json", json);
        ASSERT_FALSE(manifest.ok()) << json;
        EXPECT_EQ(manifest.error().message,
                  (folder_ / "f.json").string() + ": names no library_path");
    }
    EXPECT_FALSE(ReadIcdManifest(folder_ / "missing.json").ok());
}

TEST_F(Icd, TemporaryManifestNamesTheLibraryAndGoes) {
    const std::string library = R"(/a "b"\c.so)";
    fs::path file;
    {
        auto manifest = TemporaryManifest::Write(library);
        ASSERT_TRUE(manifest.ok());
        file = manifest->file();
        const auto read = ReadIcdManifest(file);
        ASSERT_TRUE(read.ok());
        EXPECT_EQ(read->library, library);
        EXPECT_FALSE(read->foreign);
    }
    EXPECT_FALSE(fs::exists(file));
    EXPECT_FALSE(fs::exists(file.parent_path()));
}

}  // namespace
}  // namespace etalon
