// Shaders that never end or are too much, on real drivers.
#include <gmock/gmock.h>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::AnyOf;
using testing::StartsWith;

constexpr const char* kShader = R"(
// Ends for no x.
uint never_ends(uint x)
{
    uint y = x;
    while (y != 0u) {
        y = y * 1664525u + (y >> 3) | 1u;
    }
    return y;
}

// 64 MiB a row, of which each element depends on the one before.
float big(float x, int n)
{
    float all[16777216];
    all[0] = x;
    for (int i = 1; i < n; ++i) {
        all[i] = all[i - 1] + 1.0;
    }
    return all[n / 2] + all[n - 1];
}
)";

class DriverFaults : public testing::Test {
  protected:
    DriverFaults() {
        folder_.Write("f.glsl", kShader);
        options_.folder = folder_.path();
    }
    // Whatever the driver does, it costs neither the program nor a second line.
    void ExpectVerdict(const Finished& finished) {
        EXPECT_EQ(finished.status, 1) << finished.err << finished.out;
        EXPECT_EQ(finished.out, "");
        EXPECT_EQ(Lines(finished.err).size(), 1u) << finished.err;
    }

    Folder folder_;
    ProgramOptions options_;
};

TEST_F(DriverFaults, AShaderThatNeverEndsIsATimeout) {
    // Llvmpipe ends every loop after 2^16 rounds; these two do not.
    int ran = 0;
    for (const std::string device : {"osmesa:softpipe", "vulkan:swiftshader"}) {
        if (RunEtalon({"devices", "-d", device}).status != 0) {
            continue;
        }
        ++ran;
        const auto start = std::chrono::steady_clock::now();
        const Finished finished = RunEtalon({"probe", "f.glsl", "never_ends(x)", "--at", "x:uint=7",
                                             "--timeout", "1.5", "-d", device},
                                            options_);
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(20));
        ExpectVerdict(finished);
        EXPECT_THAT(finished.err, StartsWith("timeout: " + device));
    }
    if (ran == 0) {
        GTEST_SKIP() << "no device here lets a shader run for ever";
    }
}

TEST_F(DriverFaults, AShaderTooLargeForTheDriverIsAVerdict) {
    ETALON_NEED_DEVICE();
    const Finished finished =
        RunEtalon({"probe", "f.glsl", "big(x, 1000)", "--at", "x=1", "--memory", "512", "--timeout",
                   "2", "-d", SoftwareDevice()},
                  options_);
    if (finished.status != 0) {
        ExpectVerdict(finished);
        EXPECT_THAT(finished.err,
                    AnyOf(StartsWith("crash: "), StartsWith("timeout: "), StartsWith("fail: ")));
    }
}

}  // namespace
}  // namespace etalon
