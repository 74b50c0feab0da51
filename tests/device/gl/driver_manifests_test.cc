// A driver under a prefix: the JSON files for the loaders, and what opens with them.
#include "device/gl/driver_manifests.h"

#include <gmock/gmock.h>

#include "device/gl/driver_files.h"
#include "folder.h"
#include "in_child.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class DriverManifestsTest : public FolderTest {
  protected:
    // Links the installed library into the prefix; false where there is none.
    bool Link(const std::string& name) {
        for (const fs::path& folder : SystemLibraryFolders()) {
            if (fs::exists(folder / name)) {
                fs::create_symlink(folder / name, root_ / name);
                return true;
            }
        }
        return false;
    }

    Driver driver() const { return {"linked", root_}; }
};

std::string ReadAll(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST_F(DriverManifestsTest, ManifestsNameThePrefixAndGoAgain) {
    SetVariable("TMPDIR", root_.c_str());
    SetVariable(kEglVendorsVariable, "/a \"b\"/libEGL_mesa.so.0:/c/libEGL_other.so.0");
    SetVariable(kVulkanLibraryVariable, "/a/libvulkan_lvp.so");
    for (const char* name :
         {"__EGL_VENDOR_LIBRARY_FILENAMES", "VK_DRIVER_FILES", "VK_ICD_FILENAMES"}) {
        SetVariable(name, "overwritten");
    }
    {
        const DriverManifests manifests;
        const std::string egl = getenv("__EGL_VENDOR_LIBRARY_FILENAMES");
        const std::size_t colon = egl.find(':');
        ASSERT_NE(colon, std::string::npos);
        EXPECT_THAT(ReadAll(egl.substr(0, colon)),
                    HasSubstr(R"("library_path": "/a \"b\"/libEGL_mesa.so.0")"));
        EXPECT_THAT(ReadAll(egl.substr(colon + 1)), HasSubstr("/c/libEGL_other.so.0"));
        EXPECT_THAT(ReadAll(getenv("VK_DRIVER_FILES")),
                    HasSubstr(R"("library_path": "/a/libvulkan_lvp.so")"));
    }
    EXPECT_TRUE(fs::is_empty(root_));
}

TEST_F(DriverManifestsTest, WithoutAPrefixNoManifestsAreWritten) {
    SetVariable("TMPDIR", root_.c_str());
    const DriverManifests manifests;
    EXPECT_TRUE(fs::is_empty(root_));
    EXPECT_EQ(getenv("__EGL_VENDOR_LIBRARY_FILENAMES"), nullptr);
}

TEST_F(DriverManifestsTest, OsmesaUnderAPrefixCarriesItsName) {
    if (!Link("libOSMesa.so.8")) {
        GTEST_SKIP() << "not installed";
    }
    const ChildEnd end = InChild(OsmesaCandidates(driver()).at(0), [](Device& device) {
        EXPECT_EQ(device.info().name, "osmesa:llvmpipe@linked");
    });
    EXPECT_EQ(end, ChildEnd::kPassed);
}

TEST_F(DriverManifestsTest, BrokenOsmesaDoesNotFallBackToTheInstalledOne) {
    Add("libOSMesa.so.8");
    EXPECT_EQ(InChild(OsmesaCandidates(driver()).at(0), [](Device&) {}), ChildEnd::kNotOpened);
}

TEST_F(DriverManifestsTest, EglUnderAPrefixCarriesItsName) {
    if (!Link("libEGL_mesa.so.0")) {
        GTEST_SKIP() << "not installed";
    }
    const ChildEnd end = InChild(EglCandidates(driver()).at(0), [](Device& device) {
        EXPECT_EQ(device.info().name, "egl:llvmpipe@linked");
    });
    EXPECT_EQ(end, ChildEnd::kPassed);
}

TEST_F(DriverManifestsTest, BrokenEglDoesNotFallBackToTheInstalledOne) {
    Add("libEGL_mesa.so.0");
    EXPECT_EQ(InChild(EglCandidates(driver()).at(0), [](Device&) {}), ChildEnd::kNotOpened);
}

}  // namespace
}  // namespace etalon
