#include "device/vulkan/capability.h"

#include <gtest/gtest.h>

#include <vector>

namespace etalon {
namespace {

constexpr std::uint32_t kVersion = 0x10300;

std::vector<std::uint32_t> Module(std::vector<std::uint32_t> capabilities,
                                  std::uint32_t version = kVersion) {
    std::vector<std::uint32_t> words = {0x07230203, version, 0, 1, 0};
    for (const std::uint32_t capability : capabilities) {
        words.insert(words.end(), {2u << 16 | 17u, capability});
    }
    words.insert(words.end(), {3u << 16 | 14u, 0, 1});  // OpMemoryModel Logical GLSL450
    return words;
}

std::string Reason(const std::vector<std::uint32_t>& module, const DeviceInfo& info = {}) {
    return Unsuitable(module, kVersion, info).value_or("suits");
}

TEST(Capability, ShadersSuitEveryDevice) {
    EXPECT_EQ(Reason(Module({1, 50})), "suits");
}

TEST(Capability, FollowsTheFeatures) {
    DeviceInfo info;
    EXPECT_EQ(Reason(Module({1, 10}), info), "the device has no Float64");
    info.features = {"float64"};
    EXPECT_EQ(Reason(Module({1, 10}), info), "suits");
    EXPECT_EQ(Reason(Module({1, 10, 11}), info), "the device has no Int64");
}

TEST(Capability, FollowsTheFloatControls) {
    DeviceInfo info;
    info.float_controls = {"SignedZeroInfNanPreserve"};
    EXPECT_EQ(Reason(Module({1, 4466}), info), "suits");
    EXPECT_EQ(Reason(Module({1, 4464}), info), "the device has no DenormPreserve");
}

TEST(Capability, RefusesWhatNobodyTurnedOn) {
    EXPECT_EQ(Reason(Module({1, 5345})),
              "the module needs SPIR-V capability 5345, which this backend never offers");
}

TEST(Capability, RefusesNewerVersions) {
    EXPECT_EQ(Reason(Module({1}, 0x10600)),
              "the module is SPIR-V 1.6, the device takes 1.3 at most");
}

TEST(Capability, RefusesWhatIsNoModule) {
    EXPECT_EQ(Reason({}), "the module is not SPIR-V");
    EXPECT_EQ(Reason({1, 2, 3, 4, 5, 6}), "the module is not SPIR-V");
}

TEST(Capability, EndsAtAZeroLength) {
    EXPECT_EQ(Reason({0x07230203, kVersion, 0, 1, 0, 17, 10}), "suits");
}

}  // namespace
}  // namespace etalon
