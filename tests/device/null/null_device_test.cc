#include "device/null/null_device.h"

#include <gmock/gmock.h>

#include <csignal>

namespace etalon {
namespace {

using testing::ElementsAre;

Candidate Named(const std::string& hint, std::uint32_t attempt = 0) {
    Candidate candidate;
    candidate.backend = "null";
    candidate.hint = hint;
    candidate.attempt = attempt;
    return candidate;
}

std::unique_ptr<Device> Open(const Candidate& candidate) {
    auto device = OpenNullDevice(candidate);
    return device ? std::move(*device) : nullptr;
}

Program Shape(std::uint32_t input_words, std::uint32_t output_words) {
    Program program;
    program.input_words = input_words;
    program.output_words = output_words;
    return program;
}

TEST(NullDevice, OffersEachBehaviourOnce) {
    const auto candidates = NullCandidates(Driver{});
    EXPECT_GE(candidates.size(), 11u);
    for (const Candidate& candidate : candidates) {
        EXPECT_EQ(candidate.backend, "null");
        if (candidate.hint != "crash-open") {
            const auto device = Open(candidate);
            ASSERT_NE(device, nullptr) << candidate.hint;
            EXPECT_EQ(device->info().name, "null:" + candidate.hint);
        }
    }
    EXPECT_TRUE(NullCandidates(Driver{"mesa25", "/opt/mesa"}).empty());
}

TEST(NullDevice, TheFlawIsInOneFloat) {
    const auto device = Open(Named("flaw"));
    ASSERT_NE(device, nullptr);
    const auto one = device->Load(Shape(1, 1));
    ASSERT_TRUE(one);
    const std::vector<std::uint32_t> inputs = {0x3f333332u, 0x3f333333u, 0x3f333334u};
    std::vector<std::uint32_t> outputs(3);
    ASSERT_TRUE(device->Run(*one, 3, inputs, outputs, nullptr));
    EXPECT_THAT(outputs, ElementsAre(0x3f333332u, 0x3f333335u, 0x3f333334u));
}

TEST(NullDevice, EchoesByColumns) {
    const auto device = Open(Named("echo"));
    ASSERT_NE(device, nullptr);
    const auto none = device->Load(Shape(0, 1));
    const auto two = device->Load(Shape(2, 3));
    ASSERT_TRUE(none && two);
    const std::vector<std::uint32_t> inputs = {1, 2, 3, 11, 12, 13};
    std::vector<std::uint32_t> outputs(9, 99);
    ASSERT_TRUE(device->Run(*two, 3, inputs, outputs, nullptr));
    EXPECT_THAT(outputs, ElementsAre(1, 2, 3, 11, 12, 13, 1, 2, 3));
    outputs.assign(2, 99);
    ASSERT_TRUE(device->Run(*none, 2, {}, outputs, nullptr));
    EXPECT_THAT(outputs, ElementsAre(0, 0));
}

TEST(NullDevice, RefusesInItsWays) {
    const auto load = [](const std::string& hint) { return Open(Named(hint))->Load(Shape(1, 1)); };
    EXPECT_EQ(load("rejects").error().kind, DeviceFailure::Kind::kRejected);
    EXPECT_EQ(load("unsupported").error().kind, DeviceFailure::Kind::kUnsupported);
    const auto lost = Open(Named("lost"));
    const auto handle = lost->Load(Shape(1, 1));
    ASSERT_TRUE(handle);
    std::uint32_t word = 5;
    EXPECT_EQ(lost->Run(*handle, 1, {&word, 1}, {&word, 1}, nullptr).error().kind,
              DeviceFailure::Kind::kLost);
    EXPECT_EQ(OpenNullDevice(Named("sleeps")).error().reason, "the null device knows no 'sleeps'");
}

TEST(NullDevice, NamesItsDriver) {
    Candidate candidate = Named("echo");
    candidate.driver = "mine";
    EXPECT_EQ(Open(candidate)->info().name, "null:echo@mine");
}

void RunOnce(const Candidate& candidate) {
    const auto device = Open(candidate);
    const auto handle = device->Load(Shape(1, 1));
    const std::uint32_t in = 7;
    std::uint32_t out = 0;
    EXPECT_TRUE(device->Run(*handle, 1, {&in, 1}, {&out, 1}, nullptr));
    EXPECT_EQ(out, 7u);
}

TEST(NullDeviceDeathTest, CrashesWhereTold) {
    EXPECT_EXIT(Open(Named("crash-open")), testing::KilledBySignal(SIGSEGV), "");
    EXPECT_EXIT((void)Open(Named("crash-load"))->Load(Shape(1, 1)),
                testing::KilledBySignal(SIGSEGV), "");
    EXPECT_EXIT(RunOnce(Named("crash")), testing::KilledBySignal(SIGSEGV), "");
    EXPECT_EXIT(RunOnce(Named("crash-once")), testing::KilledBySignal(SIGSEGV), "");
}

TEST(NullDevice, BehavesAtTheSecondAttemptWhereTold) {
    RunOnce(Named("crash-once", 1));
    RunOnce(Named("hang-once", 1));
}

}  // namespace
}  // namespace etalon
