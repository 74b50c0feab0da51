#include "worker/message.h"

#include <gmock/gmock.h>

#include <cmath>

namespace etalon {
namespace {

using testing::ElementsAre;

std::string_view Body(const std::string& frame) {
    EXPECT_EQ(FramedSize(frame), frame.size() - kFrameBytes);
    return std::string_view(frame).substr(kFrameBytes);
}

Program Sample() {
    Program program;
    program.stage = Stage::kFragment;
    program.form = Form::kGlsl;
    program.glsl = "void main() {}  // \xc3\xa4";
    program.spirv = {0x07230203, 0, ~0u};
    program.input_words = 3;
    program.output_words = 4;
    const auto image = std::make_shared<Image>(Image{1, 2, {0, 1, 2, 3, 4, 5, 6, -0.0f}});
    auto sky = std::make_shared<Image>(Image{2, 2, {}, 2, ImageShape::kCube});
    sky->rgba.resize(LevelStart(*sky, 2), 0.5f);
    program.images = {
        {"albedo", image}, {"height", image, {Filter::kNearest, Wrap::kClamp}}, {"sky", sky}};
    return program;
}

TEST(Message, CarriesAProgram) {
    const auto request = DecodeRequest(Body(Encode(Sample())));
    ASSERT_TRUE(request && std::holds_alternative<Program>(*request));
    const auto& program = std::get<Program>(*request);
    EXPECT_EQ(program.stage, Stage::kFragment);
    EXPECT_EQ(program.form, Form::kGlsl);
    EXPECT_EQ(program.glsl, Sample().glsl);
    EXPECT_EQ(program.spirv, Sample().spirv);
    EXPECT_EQ(program.input_words, 3u);
    EXPECT_EQ(program.output_words, 4u);
    ASSERT_EQ(program.images.size(), 3u);
    EXPECT_EQ(program.images[0].sampling, Sampling{});
    EXPECT_EQ(program.images[1].name, "height");
    EXPECT_EQ(program.images[1].sampling, (Sampling{Filter::kNearest, Wrap::kClamp}));
    EXPECT_EQ(program.images[2].name, "sky");
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_TRUE(AreSame(*program.images[i].image, *Sample().images[i].image)) << i;
    }
}

TEST(Message, RefusesAnImageThatIsNotWhole) {
    const auto refused = [](void (*spoil)(Image&, Sampling&)) {
        Program program = Sample();
        Image image = *program.images[2].image;
        spoil(image, program.images[2].sampling);
        program.images[2].image = std::make_shared<Image>(std::move(image));
        return !DecodeRequest(Body(Encode(program)));
    };
    EXPECT_FALSE(refused([](Image&, Sampling&) {}));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.width = 3; }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.width = image.height = ~0u; }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.levels = 1; }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.levels = ~0u; }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.rgba.push_back(0); }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.shape = ImageShape::kFlat; }));
    EXPECT_TRUE(refused([](Image& image, Sampling&) { image.shape = ImageShape{2}; }));
    EXPECT_TRUE(refused([](Image&, Sampling& sampling) { sampling.filter = Filter{2}; }));
    EXPECT_TRUE(refused([](Image&, Sampling& sampling) { sampling.wrap = Wrap{255}; }));
}

TEST(Message, CarriesTheOtherRequests) {
    OpenRequest open{{"vulkan", "lvp.json", 2, 1, "mine", {{"A", "1"}, {"B", ""}}}, 1ull << 40};
    const auto opened = DecodeRequest(Body(Encode(open)));
    ASSERT_TRUE(opened && std::holds_alternative<OpenRequest>(*opened));
    const auto& copy = std::get<OpenRequest>(*opened);
    EXPECT_EQ(copy.memory_bytes, 1ull << 40);
    EXPECT_EQ(copy.candidate.hint, "lvp.json");
    EXPECT_EQ(copy.candidate.index, 2u);
    EXPECT_EQ(copy.candidate.attempt, 1u);
    EXPECT_EQ(copy.candidate.driver, "mine");
    EXPECT_EQ(copy.candidate.environment, open.candidate.environment);

    const auto run = DecodeRequest(Body(Encode(RunRequest{7, {8, 9, 10}, true})));
    ASSERT_TRUE(run && std::holds_alternative<RunRequest>(*run));
    EXPECT_EQ(std::get<RunRequest>(*run).handle, 7u);
    EXPECT_EQ(std::get<RunRequest>(*run).batch.output_words, 10u);
    EXPECT_TRUE(std::get<RunRequest>(*run).is_timed);
}

TEST(Message, CarriesAnswers) {
    DeviceInfo info;
    info.name = "vulkan:x";
    info.compiler = "LLVM";
    info.features = {"compute", "float64"};
    info.float_controls = {"RoundingModeRTE"};
    info.glsl_version = 450;
    info.siblings = 3;
    info.on_host = true;
    info.slow = true;
    const auto answer = DecodeAnswer<DeviceInfo>(Body(EncodeAnswer<DeviceInfo>(info)));
    ASSERT_TRUE(answer && answer->ok());
    EXPECT_EQ((*answer)->name, "vulkan:x");
    EXPECT_EQ((*answer)->compiler, "LLVM");
    EXPECT_THAT((*answer)->features, ElementsAre("compute", "float64"));
    EXPECT_THAT((*answer)->float_controls, ElementsAre("RoundingModeRTE"));
    EXPECT_EQ((*answer)->siblings, 3u);
    EXPECT_TRUE((*answer)->on_host);
    EXPECT_TRUE((*answer)->slow);

    const auto time = DecodeAnswer<RunTime>(
        Body(EncodeAnswer<RunTime>(RunTime{0.25, RunTime::Clock::kDevice, 0.5})));
    ASSERT_TRUE(time && time->ok());
    EXPECT_EQ((*time)->seconds, 0.25);
    EXPECT_EQ((*time)->clock, RunTime::Clock::kDevice);
    EXPECT_EQ((*time)->processor_seconds, 0.5);

    const auto refusal = DecodeAnswer<RunTime>(Body(EncodeAnswer<RunTime>(
        DeviceFailure{DeviceFailure::Kind::kRejected, "0:1: no\n\x1b[31m\xff"})));
    ASSERT_TRUE(refusal && !refusal->ok());
    EXPECT_EQ(refusal->error().kind, DeviceFailure::Kind::kRejected);
    EXPECT_EQ(refusal->error().reason, "0:1: no\n?[31m?");
}

TEST(Message, RefusesATimeThatIsNone) {
    const auto refused = [](RunTime time) {
        return !DecodeAnswer<RunTime>(Body(EncodeAnswer<RunTime>(time)));
    };
    EXPECT_FALSE(refused({}));
    EXPECT_TRUE(refused({-1e-9}));
    EXPECT_TRUE(refused({std::nan("")}));
    EXPECT_TRUE(refused({1, RunTime::Clock{2}}));
    EXPECT_TRUE(refused({1, RunTime::Clock::kHost, HUGE_VAL}));
}

TEST(Message, CutsALongReason) {
    const auto refusal = DecodeAnswer<RunTime>(Body(EncodeAnswer<RunTime>(
        DeviceFailure{DeviceFailure::Kind::kRejected, std::string(1u << 24, 'x')})));
    ASSERT_TRUE(refusal && !refusal->ok());
    EXPECT_EQ(refusal->error().reason.size(), kLongestReason);
}

TEST(Message, RefusesEveryShorterOrLongerMessage) {
    const std::string request = Encode(Sample());
    DeviceInfo info;
    info.features = {"compute"};
    const std::string answer = EncodeAnswer<DeviceInfo>(info);
    for (std::size_t size = 0; size < Body(request).size(); ++size) {
        EXPECT_FALSE(DecodeRequest(Body(request).substr(0, size))) << size;
    }
    for (std::size_t size = 0; size < Body(answer).size(); ++size) {
        EXPECT_FALSE(DecodeAnswer<DeviceInfo>(Body(answer).substr(0, size))) << size;
    }
    EXPECT_FALSE(DecodeRequest(std::string(Body(request)) + '\0'));
    EXPECT_FALSE(DecodeAnswer<DeviceInfo>(std::string(Body(answer)) + '\0'));
}

TEST(Message, SurvivesAnyBytes) {
    DeviceInfo info;
    info.features = {"compute", "glsl"};
    const std::string good(Body(EncodeAnswer<DeviceInfo>(info)));
    for (std::size_t at = 0; at < good.size(); ++at) {
        for (const char value : {'\x7f', '\xff', '\x02'}) {
            std::string bad = good;
            bad[at] = value;
            (void)DecodeAnswer<DeviceInfo>(bad);  // no crash, no huge allocation
        }
    }
    std::string slow = good;
    slow.back() = 2;
    EXPECT_FALSE(DecodeAnswer<DeviceInfo>(slow)) << "no bool";
    std::string kind(Body(EncodeAnswer<RunTime>(DeviceFailure{})));
    kind[1] = 4;
    EXPECT_FALSE(DecodeAnswer<RunTime>(kind));
    kind[1] = 3;
    EXPECT_TRUE(DecodeAnswer<RunTime>(kind));
    kind[0] = 2;
    EXPECT_FALSE(DecodeAnswer<RunTime>(kind));
}

}  // namespace
}  // namespace etalon
