// What is offered for a driver under a prefix, against a folder tree of empty files.
#include <gmock/gmock.h>

#include <filesystem>

#include "device/gl/driver_files.h"
#include "device/gl/gl_device.h"
#include "folder.h"

namespace etalon {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

using CandidatesTest = FolderTest;

std::vector<std::string> Hints(const std::vector<Candidate>& candidates) {
    std::vector<std::string> hints;
    hints.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
        hints.push_back(candidate.hint);
    }
    return hints;
}

TEST_F(CandidatesTest, EmptyPrefixFolderOffersNothing) {
    Add("usr/lib/libGL.so.1");
    EXPECT_THAT(OsmesaCandidates({"new", root_}), IsEmpty());
    EXPECT_THAT(EglCandidates({"new", root_}), IsEmpty());
}

TEST_F(CandidatesTest, MissingPrefixOffersNothing) {
    EXPECT_THAT(OsmesaCandidates({"new", root_ / "absent"}), IsEmpty());
    EXPECT_THAT(EglCandidates({"new", root_ / "absent"}), IsEmpty());
}

TEST_F(CandidatesTest, OsmesaOfAPrefix) {
    const fs::path library = Add("usr/lib/x86_64-linux-gnu/libOSMesa.so.8");
    Add("usr/lib/x86_64-linux-gnu/libOSMesa.so.8.0.0");
    const std::vector<Candidate> candidates = OsmesaCandidates({"new", root_});
    ASSERT_THAT(Hints(candidates), ElementsAre("llvmpipe", "softpipe"));
    for (const Candidate& candidate : candidates) {
        EXPECT_EQ(candidate.backend, "osmesa");
        EXPECT_EQ(candidate.driver, "new");
        EXPECT_EQ(candidate.environment.at("GALLIUM_DRIVER"), candidate.hint);
        EXPECT_EQ(candidate.environment.at(kOsmesaLibraryVariable), library);
        EXPECT_THAT(candidate.environment.at("LD_LIBRARY_PATH"),
                    ::testing::StartsWith(library.parent_path().string()));
    }
    EXPECT_THAT(EglCandidates({"new", root_}), IsEmpty());
}

TEST_F(CandidatesTest, LaterOsmesaWins) {
    Add("a/libOSMesa.so.8");
    Add("b/libOSMesa.so.6");
    Add("c/libOSMesa.so");
    EXPECT_EQ(FindDriverFiles(root_).osmesa, root_ / "a/libOSMesa.so.8");
}

TEST_F(CandidatesTest, EglOfAPrefix) {
    const fs::path vendor = Add("usr/lib/libEGL_mesa.so.0");
    const fs::path dri = Add("usr/lib/dri/swrast_dri.so").parent_path();
    std::vector<Candidate> candidates = EglCandidates({"new", root_});
    ASSERT_THAT(Hints(candidates), ElementsAre("llvmpipe", "softpipe", "hardware"));
    for (const Candidate& candidate : candidates) {
        EXPECT_EQ(candidate.environment.at(kEglVendorsVariable), vendor);
        EXPECT_EQ(candidate.environment.at("LIBGL_DRIVERS_PATH"), dri);
        EXPECT_EQ(candidate.environment.contains("LIBGL_ALWAYS_SOFTWARE"),
                  candidate.hint != "hardware");
    }

    // Zink would otherwise run on the installed lavapipe and carry the prefix's name.
    const fs::path lavapipe = Add("usr/lib/libvulkan_lvp.so");
    candidates = EglCandidates({"new", root_});
    ASSERT_THAT(Hints(candidates), ElementsAre("llvmpipe", "softpipe", "zink", "hardware"));
    EXPECT_EQ(candidates[2].environment.at("MESA_LOADER_DRIVER_OVERRIDE"), "zink");
    EXPECT_EQ(candidates[2].environment.at(kVulkanLibraryVariable), lavapipe);
}

TEST_F(CandidatesTest, EglWithoutVendorsIsOfferedUnlessItOnlyLoadsThem) {
    Add("lib/libEGL.so.1");
    EXPECT_THAT(Hints(EglCandidates({"new", root_})),
                ElementsAre("llvmpipe", "softpipe", "hardware"));
    Add("lib/libGLdispatch.so.0");
    EXPECT_THAT(EglCandidates({"new", root_}), IsEmpty());
}

TEST_F(CandidatesTest, LibraryFoldersAreAllThatHoldSharedLibraries) {
    Add("lib/libEGL_mesa.so.0");
    Add("lib/dri/zink_dri.so");
    Add("other/libLLVM-19.so.1");
    Add("doc/readme.so.txt");
    EXPECT_THAT(FindDriverFiles(root_).library_folders,
                UnorderedElementsAre(root_ / "lib", root_ / "lib/dri", root_ / "other"));
}

TEST_F(CandidatesTest, FoldersBeyondTheDepthAreNotSearched) {
    Add("1/2/3/4/5/6/7/libOSMesa.so.8");
    EXPECT_FALSE(FindDriverFiles(root_).osmesa.empty());
    fs::remove_all(root_ / "1");
    Add("1/2/3/4/5/6/7/8/libOSMesa.so.8");
    EXPECT_TRUE(FindDriverFiles(root_).osmesa.empty());
}

TEST_F(CandidatesTest, InstalledLibrariesAreFoundByLdLibraryPath) {
    Add("libEGL.so.1");
    Add("libOSMesa.so.6");
    SetVariable("LD_LIBRARY_PATH", root_.c_str());
    EXPECT_TRUE(HasLibrary(SystemLibraryFolders(), "libOSMesa.so.6"));
    EXPECT_FALSE(HasLibrary(SystemLibraryFolders(), "libOSMesa.so.123"));
    EXPECT_THAT(Hints(OsmesaCandidates({})), ElementsAre("llvmpipe", "softpipe"));
    const std::vector<Candidate> egl = EglCandidates({});
    ASSERT_FALSE(egl.empty());
    EXPECT_EQ(egl.front().environment.count("LD_LIBRARY_PATH"), 0u);
    EXPECT_EQ(egl.back().hint, "hardware");
    EXPECT_THAT(egl.back().environment, IsEmpty());
}

}  // namespace
}  // namespace etalon
