#include "device/vulkan/names.h"

#include <gtest/gtest.h>

namespace etalon {
namespace {

TEST(Slug, IsTheDevicesNameInOneWord) {
    EXPECT_EQ(Slug("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe");
    EXPECT_EQ(Slug("SwiftShader Device (Subzero)"), "swiftshader");
    EXPECT_EQ(Slug("NVIDIA H200"), "nvidia-h200");
    EXPECT_EQ(Slug("AMD Radeon RX 6800 (RADV NAVI21)"), "amd-radeon-rx-6800");
}

TEST(Slug, ReadsPastTrademarks) {
    EXPECT_EQ(Slug("Intel(R) UHD Graphics 620 (KBL GT2)"), "intel-uhd-graphics-620");
    EXPECT_EQ(Slug("Adreno (TM) 740"), "adreno-740");
}

TEST(Slug, IsNeverEmpty) {
    EXPECT_EQ(Slug(""), "unknown");
    EXPECT_EQ(Slug("Device (LLVM)"), "unknown");
}

TEST(Slug, HasNothingThatAPatternWouldRead) {
    EXPECT_EQ(Slug("  a*b?c@d:e\xc3\xa4#2 "), "a-b-c-d-e-2");
}

TEST(CompilerOf, IsTheParenthesisThatNamesOne) {
    EXPECT_EQ(CompilerOf("llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6 (LLVM 15.0.6)"),
              "LLVM 15.0.6, 256 bits");
    EXPECT_EQ(CompilerOf("SwiftShader Device (Subzero)", ""), "Subzero");
    EXPECT_EQ(CompilerOf("AMD Radeon (RADV NAVI21)", "Mesa 25.0.7 (LLVM 19.1.7)"), "LLVM 19.1.7");
}

TEST(CompilerOf, IsEmptyWhereNobodySays) {
    EXPECT_EQ(CompilerOf("Intel(R) UHD Graphics 620 (KBL GT2)", "Mesa 22.3.6"), "");
    EXPECT_EQ(CompilerOf("NVIDIA H200", "550.54.14"), "");
    EXPECT_EQ(CompilerOf("broken (LLVM", "broken LLVM)"), "");
}

}  // namespace
}  // namespace etalon
