#include "device/cpu/cpu_device.h"

#include <gmock/gmock.h>

#include "device/timing.h"
#include "evaluate/probed.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::unique_ptr<Device> Open() {
    return std::move(*OpenCpuDevice(Candidate{}));
}

TEST(CpuDevice, IsOneOfNoDriver) {
    EXPECT_EQ(CpuCandidates(Driver{}).size(), 1u);
    EXPECT_TRUE(CpuCandidates(Driver{"other", "/usr"}).empty());
    EXPECT_EQ(Open()->info().name, "cpu");
}

TEST(CpuDevice, RunsProbes) {
    const Probed probed("uint f(uint x) { return x * 3u; }\n", "f(x)", {"uint x"});
    const auto device = Open();
    const auto handle = device->Load(probed.program());
    ASSERT_TRUE(handle.ok()) << handle.error().reason;
    const std::vector<std::uint32_t> inputs = {1, 2, 0xffffffffu};
    std::vector<std::uint32_t> outputs(3);
    ASSERT_TRUE(device->Run(*handle, 3, inputs, outputs, nullptr).ok());
    EXPECT_THAT(outputs, ElementsAre(3u, 6u, 0xfffffffdu));
}

TEST(CpuDevice, TimesRuns) {
    const Probed probed(
        "uint f(uint x) { for (int i = 0; i < 100; ++i) { x = x * 3u + 1u; } return x; }", "f(x)",
        {"uint x"});
    const auto device = Open();
    ExpectTimesToGrow(*device, *device->Load(probed.program()), 1u << 14);
}

TEST(CpuDevice, TellsWhatItCannotDo) {
    const auto device = Open();
    Program text;
    text.form = Form::kGlsl;
    const auto none = device->Load(text);
    ASSERT_FALSE(none.ok());
    EXPECT_EQ(none.error().kind, DeviceFailure::Kind::kUnsupported);
    Program broken;
    broken.spirv = {1, 2, 3};
    const auto wrong = device->Load(broken);
    ASSERT_FALSE(wrong.ok());
    EXPECT_THAT(wrong.error().reason, HasSubstr("SPIR-V"));
}

TEST(CpuDevice, TellsOfALoopWithoutEnd) {
    const Probed probed("uint f(uint x) { while (x != 3u) { x |= 4u; } return x; }\n", "f(x)",
                        {"uint x"});
    const auto device = Open();
    const auto handle = device->Load(probed.program());
    ASSERT_TRUE(handle.ok());
    std::vector<std::uint32_t> outputs(1);
    const std::vector<std::uint32_t> inputs = {2};
    const auto ran = device->Run(*handle, 1, inputs, outputs, nullptr);
    ASSERT_FALSE(ran.ok());
    EXPECT_THAT(ran.error().reason, HasSubstr("a loop does not end"));
}

}  // namespace
}  // namespace etalon
