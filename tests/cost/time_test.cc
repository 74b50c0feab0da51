// The estimator against calls of known relative cost, one device after the other: what takes twice
// and ten times as long must be seen to, within 10 %, however busy the machine is.
#include <gmock/gmock.h>

#include <thread>

#include "cost/cost.h"
#include "cost/subject.h"
#include "run/devices.h"
#include "run/fit.h"

namespace etalon {
namespace {

using testing::DoubleNear;
using testing::HasSubstr;

// Each step needs the one before, and nothing tells a compiler what they come to.
constexpr const char* kChain =
    "float chain(float x, int steps)\n{\n"
    "    for (int i = 0; i < steps; ++i) {\n"
    "        x = fract(x * 1.0001 + 0.0001);\n"
    "    }\n"
    "    return x;\n}\n";

class TimeTest : public testing::Test {
  protected:
    static CostOptions Quick() {
        CostOptions options;
        options.seconds = 0.15;
        options.most_seconds = 1.0;
        return options;
    }

    // Null where there is no such device here.
    Runner* Open(const std::string& name) {
        DeviceChoice choice;
        choice.patterns = {name};
        auto opened = OpenDevices(choice);
        if (!opened) {
            return nullptr;
        }
        devices_ = std::move(*opened);
        return devices_.runners.front().get();
    }

    PreparedCase Chain(unsigned steps, std::size_t rows = 100) {
        SubjectText text{kChain, "chain(x, " + std::to_string(steps) + ")"};
        text.x.clear();
        for (std::size_t i = 0; i < rows; ++i) {
            text.x.push_back(static_cast<float>(i) / static_cast<float>(rows));
        }
        return SubjectOf(folder_, "chain", text);
    }

    void ExpectRatios(const std::string& device, const std::string& recipe,
                      std::size_t rows = 100) {
        Runner* runner = Open(device);
        if (runner == nullptr) {
            GTEST_SKIP() << "no " << device << " here";
        }
        // More than drivers unroll.
        const std::vector<PreparedCase> subjects = {Chain(64, rows), Chain(128, rows),
                                                    Chain(640, rows)};
        const auto times = EstimateTimes(subjects, *runner, *ParseRecipe(recipe), Quick());
        ASSERT_TRUE(times) << times.error().message;
        for (const auto& time : *times) {
            ASSERT_TRUE(time) << time.error().message;
            EXPECT_GT(time->low, 0);
            EXPECT_LE(time->low, time->seconds);
            EXPECT_GE(time->high, time->seconds);
            EXPECT_GE(time->rounds, 4u);
            EXPECT_EQ(time->clock, "processor time");
        }
        const double one = (*times)[0]->seconds;
        EXPECT_THAT((*times)[1]->seconds / one, DoubleNear(2, 0.2));
        EXPECT_THAT((*times)[2]->seconds / one, DoubleNear(10, 1));
    }

    // Seconds of calls of these texts, over the function chain.
    std::vector<double> SecondsOf(const std::vector<SubjectText>& texts, Runner& runner,
                                  const Recipe& recipe) {
        std::vector<PreparedCase> subjects;
        for (const SubjectText& text : texts) {
            subjects.push_back(SubjectOf(folder_, "f" + std::to_string(subjects.size()), text));
        }
        const auto times = EstimateTimes(subjects, runner, recipe, Quick());
        EXPECT_TRUE(times);
        std::vector<double> seconds;
        for (const auto& time : *times) {
            EXPECT_TRUE(time) << time.error().message;
            seconds.push_back(time ? time->seconds : 0);
        }
        return seconds;
    }

    Folder folder_;
    DeviceSet devices_;
};

TEST_F(TimeTest, SeesRatiosOnTheEvaluator) {
    ExpectRatios("cpu", "spirv");
}

TEST_F(TimeTest, SeesRatiosOnLavapipe) {
    ExpectRatios("vulkan:llvmpipe", "spirv");
}

TEST_F(TimeTest, SeesRatiosOfFragments) {
    ExpectRatios("vulkan:llvmpipe", "spirv+fragment");
}

TEST_F(TimeTest, SeesRatiosOnOpenGl) {
    ExpectRatios("osmesa:llvmpipe", "glsl");
}

TEST_F(TimeTest, SeesRatiosOverManyRows) {
    // More than one dispatch takes.
    ExpectRatios("vulkan:llvmpipe", "spirv+fragment", 300'000);
}

TEST_F(TimeTest, SeesRatiosOnABusyMachine) {
    std::atomic<bool> stop = false;
    std::vector<std::thread> burning;
    for (unsigned i = 0; i < std::max(2u, std::thread::hardware_concurrency()); ++i) {
        burning.emplace_back([&] {
            while (!stop) {
            }
        });
    }
    ExpectRatios("vulkan:llvmpipe", "spirv");
    stop = true;
    for (std::thread& thread : burning) {
        thread.join();
    }
}

TEST_F(TimeTest, SeesRatiosOfShortCalls) {
    Runner* runner = Open("vulkan:llvmpipe");
    if (runner == nullptr) {
        GTEST_SKIP() << "no lavapipe here";
    }
    const auto roots = [](int count) {
        std::string body = "x";
        for (int i = 1; i <= count; ++i) {
            body = "sqrt(" + body + " + " + std::to_string(i) + ".0)";
        }
        return SubjectText{"float f(float x) { return " + body + "; }\n", "f(x)"};
    };
    // In a call with a loop they are no shorter.
    const SubjectText looped{
        "float f(float x) { for (int i = 0; i < 2; ++i) { x = sqrt(x + 1.0); } return x; }\n",
        "f(x)"};
    const std::vector<double> seconds =
        SecondsOf({roots(2), roots(4), roots(20), {"", "x + 1.0"}, looped}, *runner,
                  DefaultRecipe(runner->info()));
    EXPECT_THAT(seconds[1] / seconds[0], DoubleNear(2, 0.2));
    EXPECT_THAT(seconds[2] / seconds[0], DoubleNear(10, 1));
    EXPECT_LT(seconds[3], 0.2 * seconds[0]);
    EXPECT_THAT(seconds[4] / seconds[0], DoubleNear(1, 0.5));
}

TEST_F(TimeTest, TimesCallsWithImages) {
    Runner* runner = Open("vulkan:llvmpipe");
    if (runner == nullptr) {
        GTEST_SKIP() << "no lavapipe here";
    }
    SubjectText one{
        "uniform sampler2D height;\n"
        "float f(float x, int n)\n{\n"
        "    for (int i = 0; i < n; ++i) {\n"
        "        x = fract(x + 0.1 + textureLod(height, vec2(x, 0.5), 0.0).x);\n"
        "    }\n"
        "    return x;\n}\n",
        "f(x, 40)"};
    one.images = {{"height", std::make_shared<Image>(Image{2, 1, {0, 1, 2, 3, 4, 5, 6, 7}})}};
    SubjectText two = one;
    two.call = "f(x, 80)";
    const std::vector<double> seconds =
        SecondsOf({one, two}, *runner, DefaultRecipe(runner->info()));
    EXPECT_THAT(seconds[1] / seconds[0], DoubleNear(2, 0.2));
}

TEST_F(TimeTest, KeepsWithinWhatADriverLetsALoopTake) {
    Runner* runner = Open("vulkan:llvmpipe");
    if (runner == nullptr) {
        GTEST_SKIP() << "no lavapipe here";
    }
    // llvmpipe ends all loops of a program after 65536 turns together: 16 evaluations.
    const std::vector<PreparedCase> subjects = {Chain(400, 1), Chain(4000, 1)};
    const auto times = EstimateTimes(subjects, *runner, DefaultRecipe(runner->info()), Quick());
    ASSERT_TRUE(times && (*times)[0] && (*times)[1]);
    EXPECT_THAT((*times)[1]->seconds / (*times)[0]->seconds, DoubleNear(10, 1));
}

TEST_F(TimeTest, ACallThatTakesNoTimeKeepsNoOtherWaiting) {
    Runner* runner = Open("vulkan:llvmpipe");
    if (runner == nullptr) {
        GTEST_SKIP() << "no lavapipe here";
    }
    CostOptions options = Quick();
    options.spread = 100;
    options.most_seconds = 20;
    const std::vector<PreparedCase> subjects = {Chain(64), SubjectOf(folder_, "x", {"", "x"})};
    const auto times = EstimateTimes(subjects, *runner, DefaultRecipe(runner->info()), options);
    ASSERT_TRUE(times && (*times)[0] && (*times)[1]);
    EXPECT_LT((*times)[1]->seconds, 1e-10);
    EXPECT_LT((*times)[0]->rounds, 500u) << "what 0.3 s hold, not what 40 s hold";
}

TEST_F(TimeTest, SaysWhichHasNoTime) {
    Runner* runner = Open("cpu");
    ASSERT_NE(runner, nullptr);
    const std::vector<PreparedCase> subjects = {
        Chain(40), SubjectOf(folder_, "g", {"float f(float x) { return dFdx(x); }", "f(x)"})};
    const auto times = EstimateTimes(subjects, *runner, Recipe{}, Quick());
    ASSERT_TRUE(times);
    EXPECT_TRUE((*times)[0]);
    EXPECT_FALSE((*times)[1]);
    EXPECT_FALSE(EstimateTimes(subjects, *runner, *ParseRecipe("glsl"), Quick()));
    const auto baked = EstimateTimes(subjects, *runner, *ParseRecipe("spirv+baked"), Quick());
    ASSERT_FALSE(baked);
    EXPECT_THAT(baked.error().message, HasSubstr("baked"));
}

TEST_F(TimeTest, SurvivesADeviceThatCrashes) {
    Runner* runner = Open("null:crash");
    ASSERT_NE(runner, nullptr);
    const auto times = EstimateTimes(std::vector{Chain(40)}, *runner, Recipe{}, Quick());
    ASSERT_TRUE(times);
    ASSERT_FALSE((*times)[0]);
    EXPECT_THAT((*times)[0].error().message, HasSubstr("signal"));
}

TEST_F(TimeTest, TellsHowFarItIs) {
    Runner* runner = Open("cpu");
    ASSERT_NE(runner, nullptr);
    std::vector<double> shares;
    ASSERT_TRUE(EstimateTimes(std::vector{Chain(40)}, *runner, Recipe{}, Quick(),
                              [&](double share) { shares.push_back(share); }));
    ASSERT_FALSE(shares.empty());
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1);
}

}  // namespace
}  // namespace etalon
