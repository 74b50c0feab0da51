#include "device/gl/gl_info.h"

#include <gmock/gmock.h>

namespace etalon {
namespace {

TEST(RendererSlug, KeepsTheWordsBeforeDetails) {
    EXPECT_EQ(RendererSlug("NVIDIA H200/PCIe/SSE2"), "nvidia-h200");
    EXPECT_EQ(RendererSlug("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe");
    EXPECT_EQ(RendererSlug("AMD Radeon RX 6800 (radeonsi, navi21, LLVM 15.0.6)"),
              "amd-radeon-rx-6800");
    EXPECT_EQ(RendererSlug("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"),
              "mesa-intel-uhd-graphics-620");
    EXPECT_EQ(RendererSlug(""), "");
}

TEST(RendererCompiler, IsWhatFollowsLlvm) {
    EXPECT_EQ(RendererCompiler("llvmpipe (LLVM 15.0.6, 256 bits)"), "LLVM 15.0.6, 256 bits");
    EXPECT_EQ(RendererCompiler("zink (llvmpipe (LLVM 15.0.6, 256 bits))"), "LLVM 15.0.6, 256 bits");
    EXPECT_EQ(RendererCompiler("softpipe"), "");
}

TEST(ParseDriverVersion, SplitsNameAndVersion) {
    const DriverVersion mesa = ParseDriverVersion("4.5 (Core Profile) Mesa 22.3.6");
    EXPECT_EQ(mesa.driver, "Mesa");
    EXPECT_EQ(mesa.version, "22.3.6");
    const DriverVersion nvidia = ParseDriverVersion("4.6.0 NVIDIA 535.104.05");
    EXPECT_EQ(nvidia.driver, "NVIDIA");
    EXPECT_EQ(nvidia.version, "535.104.05");
    const DriverVersion develop =
        ParseDriverVersion("4.6 (Core Profile) Mesa 25.1.0-devel (git-0123abc)");
    EXPECT_EQ(develop.version, "25.1.0-devel (git-0123abc)");
    EXPECT_EQ(ParseDriverVersion("4.6").driver, "");
    EXPECT_EQ(ParseDriverVersion("").version, "");
}

}  // namespace
}  // namespace etalon
