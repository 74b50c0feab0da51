// Which devices a choice opens. Null devices only, so no driver is touched.
#include "run/devices.h"

#include <gmock/gmock.h>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

DeviceChoice Choose(std::vector<std::string> patterns) {
    DeviceChoice choice;
    choice.patterns = std::move(patterns);
    return choice;
}

std::vector<std::string> Names(const DeviceSet& set) {
    std::vector<std::string> names;
    for (const auto& runner : set.runners) {
        names.push_back(runner->info().name);
    }
    return names;
}

std::string ErrorOf(const DeviceChoice& choice) {
    const auto devices = OpenDevices(choice);
    return devices ? "" : devices.error().message;
}

TEST(OpenDevices, OpensWhatIsNamed) {
    const auto devices = OpenDevices(Choose({"null:echo", "null:crash"}));
    ASSERT_TRUE(devices) << devices.error().message;
    EXPECT_THAT(Names(*devices), ElementsAre("null:echo", "null:crash"));
    EXPECT_THAT(devices->absent, IsEmpty());
}

TEST(OpenDevices, TakesPatternsAndNamesADeviceOnce) {
    const auto devices = OpenDevices(Choose({"null:crash*", "null:crash", "null:?ost"}));
    ASSERT_TRUE(devices) << devices.error().message;
    EXPECT_THAT(Names(*devices),
                ElementsAre("null:crash", "null:crash-once", "null:crash-load", "null:lost"));
    // One that crashes while it opens is no device here, and the reason is kept.
    ASSERT_EQ(devices->absent.size(), 1u);
    EXPECT_EQ(devices->absent[0].name, "null:crash-open");
    EXPECT_EQ(devices->absent[0].reason, "ended by signal 11 (Segmentation fault)");
}

TEST(OpenDevices, NamesWhatIsNotThere) {
    for (const char* name : {"null:nothing", "nothing:*"}) {
        EXPECT_THAT(ErrorOf(Choose({"null:echo", name})),
                    StartsWith("no device is called '" + std::string(name) + "'"));
        EXPECT_THAT(ErrorOf(Choose({name})),
                    StartsWith("no device is called '" + std::string(name) + "'"));
    }
}

TEST(OpenDevices, SaysWhyADeviceThatWasTriedDoesNotOpen) {
    EXPECT_EQ(ErrorOf(Choose({"null:echo", "null:crash-open"})),
              "null:crash-open: does not open (ended by signal 11 (Segmentation fault))");
}

TEST(OpenDevices, RefusesADriverThatIsNone) {
    const Folder folder;
    DeviceChoice choice = Choose({"null:echo"});
    choice.drivers = {{"mine", folder.path() / "missing"}};
    EXPECT_THAT(ErrorOf(choice), HasSubstr("--driver mine: "));
    EXPECT_THAT(ErrorOf(choice), HasSubstr("is not a folder"));
    choice.drivers = {{"mine", folder.path()}};
    EXPECT_EQ(ErrorOf(choice), "--driver mine: no Vulkan, OSMesa or EGL implementation under '" +
                                   folder.path().string() + "'");
}

}  // namespace
}  // namespace etalon
