// VulkanCandidates over a tree of files of its own. No driver is loaded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "base/file.h"
#include "device/vulkan/vulkan_device.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

class Candidates : public testing::Test {
  protected:
    Candidates() {
        std::string name = (fs::path(testing::TempDir()) / "candidates-XXXXXX").string();
        root_ = mkdtemp(name.data());
        for (const char* variable : {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "LD_LIBRARY_PATH"}) {
            unsetenv(variable);
        }
        for (const char* variable :
             {"XDG_CONFIG_HOME", "XDG_CONFIG_DIRS", "XDG_DATA_HOME", "XDG_DATA_DIRS"}) {
            setenv(variable, (root_ / variable).c_str(), 1);
        }
    }
    ~Candidates() override { fs::remove_all(root_); }

    std::string Write(const fs::path& path, const std::string& content) {
        const fs::path file = root_ / path;
        fs::create_directories(file.parent_path());
        EXPECT_TRUE(WriteFile(file, content).ok());
        return file.string();
    }
    std::string WriteManifest(const fs::path& path, const std::string& library) {
        return Write(path, R"({"ICD": {"library_path": ")" + library + "\"}}");
    }
    // A file that begins as this program does is a library that this program could load.
    std::string WriteLibrary(const fs::path& path) {
        const auto program = ReadFile("/proc/self/exe");
        return Write(path, program->substr(0, 64));
    }

    // Hints of the installed candidates of this tree: the machine may have others.
    std::vector<std::string> Installed() const {
        std::vector<std::string> hints;
        for (const Candidate& candidate : VulkanCandidates({})) {
            EXPECT_EQ(candidate.backend, "vulkan");
            EXPECT_EQ(candidate.environment.at("VK_DRIVER_FILES"), candidate.hint);
            EXPECT_EQ(candidate.environment.at("VK_ICD_FILENAMES"), candidate.hint);
            if (candidate.hint.starts_with(root_.string())) {
                hints.push_back(candidate.hint);
            }
        }
        return hints;
    }
    std::vector<Candidate> Prefixed() const { return VulkanCandidates({"mine", root_ / "prefix"}); }

    fs::path root_;
};

TEST_F(Candidates, AreTheManifestsOfTheLoadersFolders) {
    const std::string data = WriteManifest("XDG_DATA_DIRS/vulkan/icd.d/b.json", "libb.so");
    const std::string config = WriteManifest("XDG_CONFIG_HOME/vulkan/icd.d/a.json", "liba.so");
    Write("XDG_DATA_HOME/vulkan/icd.d/readme.txt", "not a manifest");
    WriteManifest("XDG_DATA_HOME/vulkan/other.d/c.json", "libc.so");
    EXPECT_THAT(Installed(), ElementsAre(config, data));
}

TEST_F(Candidates, NameEachLibraryOnce) {
    const std::string first = WriteManifest("XDG_CONFIG_HOME/vulkan/icd.d/a.json", "liba.so");
    WriteManifest("XDG_DATA_DIRS/vulkan/icd.d/copy.json", "liba.so");
    EXPECT_THAT(Installed(), ElementsAre(first));
}

TEST_F(Candidates, LeaveOtherArchitecturesOut) {
    WriteManifest("XDG_DATA_DIRS/vulkan/icd.d/a_icd.s390x.json", "liba.so");
    EXPECT_THAT(Installed(), IsEmpty());
}

TEST_F(Candidates, KeepTheUnreadableForTheUserToHearOf) {
    const std::string file = Write("XDG_DATA_DIRS/vulkan/icd.d/bad.json", "nonsense");
    EXPECT_THAT(Installed(), ElementsAre(file));
}

TEST_F(Candidates, AreOnlyThoseThatTheUserNames) {
    WriteManifest("XDG_DATA_DIRS/vulkan/icd.d/a.json", "liba.so");
    const std::string file = WriteManifest("elsewhere/b.json", "libb.so");
    const std::string in_folder = WriteManifest("folder/c.json", "libc.so");
    setenv("VK_ICD_FILENAMES", "/nowhere/ignored.json", 1);
    setenv("VK_DRIVER_FILES", (file + ":" + (root_ / "folder").string()).c_str(), 1);
    EXPECT_THAT(Installed(), ElementsAre(file, in_folder));
    EXPECT_EQ(VulkanCandidates({}).size(), 2u);
    unsetenv("VK_DRIVER_FILES");
    EXPECT_EQ(VulkanCandidates({}).at(0).hint, "/nowhere/ignored.json");
}

TEST_F(Candidates, OfAPrefixUseItsOwnLibrary) {
    const std::string library = WriteLibrary("prefix/usr/lib/host/libvulkan_one.so");
    WriteLibrary("prefix/usr/lib/deps/libLLVM.so.15");
    WriteManifest("prefix/usr/share/vulkan/icd.d/one.json", "/usr/lib/host/libvulkan_one.so");
    setenv("LD_LIBRARY_PATH", "/before", 1);
    const std::vector<Candidate> candidates = Prefixed();
    ASSERT_EQ(candidates.size(), 1u);
    EXPECT_EQ(candidates[0].hint, library);
    EXPECT_EQ(candidates[0].driver, "mine");
    const std::string lib = (root_ / "prefix/usr/lib").string();
    EXPECT_EQ(candidates[0].environment.at("LD_LIBRARY_PATH"),
              lib + "/host:" + lib + "/deps:/before");
}

TEST_F(Candidates, OfAPrefixAreFoundByManifestOrByName) {
    const std::string by_manifest = WriteLibrary("prefix/out/libvk_swiftshader.so");
    const std::string by_name = WriteLibrary("prefix/src/libvulkan_two.so");
    WriteManifest("prefix/out/vk_swiftshader_icd.json", "./libvk_swiftshader.so");
    WriteLibrary("prefix/out/libEGL_mesa.so.0");
    WriteManifest("prefix/share/glvnd/egl_vendor.d/50_mesa.json", "libEGL_mesa.so.0");
    std::vector<std::string> hints;
    for (const Candidate& candidate : Prefixed()) {
        hints.push_back(candidate.hint);
    }
    EXPECT_THAT(hints, ElementsAre(by_manifest, by_name));
}

TEST_F(Candidates, OfAPrefixNeverLeaveIt) {
    WriteManifest("prefix/share/vulkan/icd.d/lvp.json",
                  "/usr/lib/x86_64-linux-gnu/libvulkan_lvp.so");
    Write("prefix/lib/libvulkan_broken.so", "no library");
    EXPECT_THAT(Prefixed(), IsEmpty());
    fs::remove_all(root_ / "prefix");
    EXPECT_THAT(Prefixed(), IsEmpty());
}

TEST_F(Candidates, OfAPrefixAreNotSoughtTooDeep) {
    WriteLibrary("prefix/1/2/3/4/5/6/7/8/9/10/libvulkan_deep.so");
    EXPECT_THAT(Prefixed(), IsEmpty());
}

}  // namespace
}  // namespace etalon
