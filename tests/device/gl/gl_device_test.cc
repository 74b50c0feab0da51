// Every GL device that opens here gives back exactly the bits that its program makes.
//
// Each test runs in a process of its own for each device: OSMesa and EGL clash in one, and Mesa
// reads its environment once.
#include "device/gl/gl_device.h"

#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <functional>
#include <iostream>
#include <numeric>

#include "device/timing.h"
#include "in_child.h"
#include "source.h"

namespace etalon {
namespace {

using ::testing::HasSubstr;

struct Door {
    std::string backend;
    std::string hint;
};

void PrintTo(const Door& door, std::ostream* out) {
    *out << door.backend << ":" << door.hint;
}

class GlDeviceTest : public ::testing::TestWithParam<Door> {
  protected:
    // Runs `body` with the device in a child; skips where there is no such device here.
    void WithDevice(const std::function<void(Device&)>& body) {
        const std::vector<Candidate> candidates =
            GetParam().backend == "osmesa" ? OsmesaCandidates({}) : EglCandidates({});
        for (const Candidate& candidate : candidates) {
            if (candidate.hint == GetParam().hint) {
                const ChildEnd end = InChild(candidate, body);
                // What is installed for OSMesa must open; EGL may lack the driver asked for.
                if (end == ChildEnd::kNotOpened && GetParam().backend == "egl") {
                    GTEST_SKIP() << "not available";
                }
                EXPECT_EQ(end, ChildEnd::kPassed) << "see the child's output above";
                return;
            }
        }
        GTEST_SKIP() << "not installed";
    }
};

INSTANTIATE_TEST_SUITE_P(Doors, GlDeviceTest,
                         ::testing::Values(Door{"osmesa", "llvmpipe"}, Door{"osmesa", "softpipe"},
                                           Door{"egl", "llvmpipe"}, Door{"egl", "softpipe"},
                                           Door{"egl", "zink"}, Door{"egl", "hardware"}),
                         [](const auto& test) {
                             return test.param.backend + "_" + test.param.hint;
                         });

using Words = std::vector<std::uint32_t>;
using Expectation = std::function<std::uint32_t(std::uint32_t row, std::uint32_t column)>;

constexpr std::uint32_t kNoProgram = ~0u;

void ExpectOutputs(Device& device, std::uint32_t handle, std::uint32_t rows, const Words& inputs,
                   std::uint32_t output_words, const Expectation& expected) {
    if (handle == kNoProgram) {
        return;
    }
    Words outputs(std::size_t{rows} * output_words, 0xdeadbeef);
    auto done = device.Run(handle, rows, inputs, outputs, nullptr);
    ASSERT_TRUE(done.ok()) << done.error().reason;
    for (std::uint32_t column = 0; column < output_words; ++column) {
        for (std::uint32_t row = 0; row < rows; ++row) {
            ASSERT_EQ(outputs[std::size_t{column} * rows + row], expected(row, column))
                << "row " << row << " of " << rows << ", column " << column;
        }
    }
}

// Bits that software likes to lose: NaN payloads, denormals, signed zeros, infinities.
std::uint32_t Pattern(std::uint32_t i) {
    constexpr std::uint32_t kSpecial[] = {0x7fc00000, 0x7f800001, 0xffc12345, 0xff800001,
                                          0x00000001, 0x807fffff, 0x80000000, 0x00000000,
                                          0x7f800000, 0xff800000, 0xffffffff, 0x00800000};
    constexpr std::uint32_t kCount = std::size(kSpecial);
    return i % 16 < kCount ? kSpecial[i % 16] : i * 2654435761u;
}

Words Patterns(std::size_t count) {
    Words words(count);
    for (std::size_t i = 0; i < count; ++i) {
        words[i] = Pattern(static_cast<std::uint32_t>(i));
    }
    return words;
}

std::uint32_t MustLoad(Device& device, const Program& program) {
    auto handle = device.Load(program);
    if (!handle.ok()) {
        ADD_FAILURE() << handle.error().reason;
        return kNoProgram;
    }
    return *handle;
}

TEST_P(GlDeviceTest, Describes) {
    WithDevice([](Device& device) {
        const DeviceInfo& info = device.info();
        std::cout << info.name << ": " << info.description << "; " << info.api << ", "
                  << info.driver << " " << info.version << ", " << info.compiler << "; GLSL "
                  << info.glsl_version << ", " << info.max_rows << " rows;";
        for (const std::string& feature : info.features) {
            std::cout << " " << feature;
        }
        std::cout << std::endl;
        if (GetParam().hint != "hardware") {
            EXPECT_EQ(info.name, GetParam().backend + ":" + GetParam().hint);
            EXPECT_EQ(info.driver, "Mesa");
        }
        EXPECT_GE(info.glsl_version, 330u);
        EXPECT_LE(info.glsl_version, 450u);
        EXPECT_TRUE(info.Has("glsl") && info.Has("fragment"));
        EXPECT_EQ(info.Has("compute"), info.glsl_version >= 430);
        EXPECT_FALSE(info.version.empty());
        EXPECT_GE(info.siblings, 1u);
    });
}

TEST_P(GlDeviceTest, WordsPassUnchanged) {
    WithDevice([](Device& device) {
        const Source source{"", "    result[0] = word[1];\n    result[1] = word[0];\n", 2, 2};
        for (const Way& way : Ways(device.info(), source)) {
            SCOPED_TRACE(way.name);
            const std::uint32_t handle = MustLoad(device, way.program);
            // Growing, shrinking and growing again: buffers are kept between runs.
            for (std::uint32_t rows : {1u, 63u, 64u, 65u, 1023u, 1024u, 1025u, 5000u, 7u, 20011u}) {
                const Words inputs = Patterns(std::size_t{2} * rows);
                ExpectOutputs(device, handle, rows, inputs, 2,
                              [&](std::uint32_t row, std::uint32_t column) {
                                  return inputs[(1 - column) * rows + row];
                              });
            }
        }
    });
}

TEST_P(GlDeviceTest, FloatsAreComputed) {
    WithDevice([](Device& device) {
        const Source source{
            "", "    result[0] = floatBitsToUint(uintBitsToFloat(word[0]) * 0.5 + 1.0);\n", 1, 1};
        const std::uint32_t rows = 4099;
        Words inputs(rows);
        for (std::uint32_t i = 0; i < rows; ++i) {
            inputs[i] = std::bit_cast<std::uint32_t>(static_cast<float>(i) * 0.25f);
        }
        for (const Way& way : Ways(device.info(), source)) {
            SCOPED_TRACE(way.name);
            ExpectOutputs(
                device, MustLoad(device, way.program), rows, inputs, 1,
                [](std::uint32_t row, std::uint32_t) {
                    return std::bit_cast<std::uint32_t>(static_cast<float>(row) * 0.125f + 1.0f);
                });
        }
    });
}

TEST_P(GlDeviceTest, TimesRuns) {
    WithDevice([](Device& device) {
        const Source source{"",
                            "    uint a = word[0];\n"
                            "    for (int k = 0; k < 100; ++k) {\n"
                            "        a = a * 1664525u + 1013904223u;\n    }\n"
                            "    result[0] = a;\n",
                            1, 1};
        for (const Way& way : Ways(device.info(), source)) {
            SCOPED_TRACE(way.name);
            ExpectTimesToGrow(device, MustLoad(device, way.program),
                              device.info().slow ? 1u << 13 : 1u << 17);
        }
    });
}

TEST_P(GlDeviceTest, ManyOutputsAreDrawnInSeveralPasses) {
    WithDevice([](Device& device) {
        std::string body;
        for (std::uint32_t i = 0; i < 70; ++i) {
            body += "    result[" + std::to_string(i) + "] = word[0] * " + std::to_string(i + 1) +
                    "u;\n";
        }
        const Source source{"", body, 1, 70};
        const std::uint32_t rows = 1100;
        Words inputs(rows);
        std::iota(inputs.begin(), inputs.end(), 3);
        for (const Way& way : Ways(device.info(), source)) {
            SCOPED_TRACE(way.name);
            ExpectOutputs(
                device, MustLoad(device, way.program), rows, inputs, 70,
                [](std::uint32_t row, std::uint32_t column) { return (row + 3) * (column + 1); });
        }
    });
}

// Rows of so many columns that the device's limits do not take them at once.
void ExpectSplit(Device& device, const Program& program, std::uint32_t rows) {
    const std::uint32_t last = program.input_words - 1;
    Words inputs(std::size_t{rows} * program.input_words);
    std::iota(inputs.begin(), inputs.end(), 0);
    ExpectOutputs(device, MustLoad(device, program), rows, inputs, 2,
                  [&](std::uint32_t row, std::uint32_t column) {
                      return column == 0 ? last * rows + row : row * 3u;
                  });
}

Source LastAndFirst(std::uint32_t columns) {
    return {"",
            "    result[0] = word[" + std::to_string(columns - 1) +
                "];\n    result[1] = word[0] * 3u;\n",
            columns, 2};
}

TEST_P(GlDeviceTest, TexturesOfManyColumnsAreSplit) {
    WithDevice([](Device& device) {
        // 16,384 lines at most: 54 for each column, which is 55,296 rows.
        ExpectSplit(device,
                    TextProgram(LastAndFirst(300), Stage::kFragment, device.info().glsl_version),
                    60001);
    });
}

TEST_P(GlDeviceTest, BuffersOfManyColumnsAreSplit) {
    WithDevice([](Device& device) {
        if (device.info().Has("compute")) {
            // Beyond the 128 MiB that a storage block may have in Mesa.
            ExpectSplit(device,
                        TextProgram(LastAndFirst(40), Stage::kCompute, device.info().glsl_version),
                        900001);
        }
    });
}

TEST_P(GlDeviceTest, BakedInputsNeedNoInputWords) {
    WithDevice([](Device& device) {
        const Source source{"", "    result[0] = row * 7u + 1u;\n", 0, 1};
        for (const Way& way : Ways(device.info(), source)) {
            SCOPED_TRACE(way.name);
            ExpectOutputs(device, MustLoad(device, way.program), 3001, {}, 1,
                          [](std::uint32_t row, std::uint32_t) { return row * 7u + 1u; });
        }
    });
}

TEST_P(GlDeviceTest, ImagesAreFilteredAndWrapped) {
    WithDevice([](Device& device) {
        const auto small = std::make_shared<Image>();
        small->width = 2;
        small->height = 2;
        // Red 0 1 / 2 3; green and others say which image it is.
        small->rgba = {0, 10, 0, 0, 1, 10, 0, 0, 2, 10, 0, 0, 3, 10, 0, 0};
        const auto other = std::make_shared<Image>();
        other->width = 1;
        other->height = 1;
        other->rgba = {5, 20, 0, -1e30f};
        const std::vector<BoundImage> images = {{"first", small}, {"second", other}};
        const std::string fetch =
            "    vec2 uv = vec2(uintBitsToFloat(word[0]), uintBitsToFloat(word[1]));\n"
            "    vec4 a = textureLod(first, uv, 0.0);\n"
            "    vec4 b = textureLod(second, uv, 0.0);\n"
            "    result[0] = floatBitsToUint(a.r);\n    result[1] = floatBitsToUint(a.g);\n"
            "    result[2] = floatBitsToUint(b.g);\n    result[3] = floatBitsToUint(b.a);\n";
        const Source bound{
            "layout(binding = 2) uniform sampler2D first;\n"
            "layout(binding = 3) uniform sampler2D second;\n",
            fetch, 2, 4};
        const Source named{"uniform sampler2D second;\nuniform sampler2D first;\n", fetch, 2, 4};

        struct Sample {
            float u, v, red;
        };
        // Texel centres, half way, and beyond the edges: all sums of halves, so exact.
        const Sample samples[] = {{0.25f, 0.25f, 0.0f}, {0.75f, 0.25f, 1.0f},  {0.25f, 0.75f, 2.0f},
                                  {0.5f, 0.25f, 0.5f},  {0.5f, 0.5f, 1.5f},    {0.0f, 0.25f, 0.5f},
                                  {1.25f, 0.25f, 0.0f}, {-0.25f, 0.75f, 3.0f}, {0.25f, 1.0f, 1.0f}};
        const auto rows = static_cast<std::uint32_t>(std::size(samples));
        Words inputs(std::size_t{2} * rows);
        for (std::uint32_t i = 0; i < rows; ++i) {
            inputs[i] = std::bit_cast<std::uint32_t>(samples[i].u);
            inputs[rows + i] = std::bit_cast<std::uint32_t>(samples[i].v);
        }
        std::vector<Way> ways = {
            {"fragment text", TextProgram(named, Stage::kFragment, device.info().glsl_version)}};
        if (device.info().Has("compute")) {
            ways.push_back({"compute text, samplers by name",
                            TextProgram(named, Stage::kCompute, device.info().glsl_version)});
            for (const Way& way : Ways(device.info(), bound)) {
                ways.push_back(way);
            }
        }
        for (Way& way : ways) {
            way.program.images = images;
        }
        for (const Way& way : ways) {
            SCOPED_TRACE(way.name);
            ExpectOutputs(device, MustLoad(device, way.program), rows, inputs, 4,
                          [&](std::uint32_t row, std::uint32_t column) {
                              const float values[] = {samples[row].red, 10.0f, 20.0f, -1e30f};
                              return std::bit_cast<std::uint32_t>(values[column]);
                          });
        }
    });
}

TEST_P(GlDeviceTest, ProgramsLiveSideBySide) {
    WithDevice([](Device& device) {
        struct Loaded {
            std::uint32_t handle;
            std::uint32_t factor;
        };
        std::vector<Loaded> loaded;
        for (std::uint32_t factor : {2u, 3u, 5u}) {
            const Source source{"", "    result[0] = word[0] * " + std::to_string(factor) + "u;\n",
                                1, 1};
            for (const Way& way : Ways(device.info(), source)) {
                loaded.push_back({MustLoad(device, way.program), factor});
            }
        }
        const std::uint32_t rows = 130;
        Words inputs(rows);
        std::iota(inputs.begin(), inputs.end(), 0);
        for (int round = 0; round < 2; ++round) {
            for (const Loaded& program : loaded) {
                ExpectOutputs(
                    device, program.handle, rows, inputs, 1,
                    [&](std::uint32_t row, std::uint32_t) { return row * program.factor; });
            }
        }
    });
}

TEST_P(GlDeviceTest, RefusedTextIsRejectedWithTheLog) {
    WithDevice([](Device& device) {
        const Source wrong{"", "    result[0] = not_declared_anywhere;\n", 1, 1};
        const Source right{"", "    result[0] = word[0];\n", 1, 1};
        const std::uint32_t version = device.info().glsl_version;
        std::vector<Program> programs = {TextProgram(wrong, Stage::kFragment, version)};
        if (device.info().Has("compute")) {
            programs.push_back(TextProgram(wrong, Stage::kCompute, version));
        }
        for (const Program& program : programs) {
            auto handle = device.Load(program);
            ASSERT_FALSE(handle.ok());
            EXPECT_EQ(handle.error().kind, DeviceFailure::Kind::kRejected);
            EXPECT_THAT(handle.error().reason,
                        ::testing::StartsWith("the driver's compiler refused the program\n"));
            EXPECT_THAT(handle.error().reason, HasSubstr("not_declared_anywhere"));
        }
        // And the device goes on.
        const Words inputs = {41};
        ExpectOutputs(device, MustLoad(device, Ways(device.info(), right).front().program), 1,
                      inputs, 1, [](std::uint32_t, std::uint32_t) { return 41u; });
    });
}

TEST_P(GlDeviceTest, WhatIsMissingIsUnsupported) {
    WithDevice([](Device& device) {
        const Source source{"", "    result[0] = word[0];\n", 1, 1};
        if (!device.info().Has("compute")) {
            auto handle = device.Load(TextProgram(source, Stage::kCompute, 430));
            ASSERT_FALSE(handle.ok());
            EXPECT_EQ(handle.error().kind, DeviceFailure::Kind::kUnsupported);
        }
        Program many = Ways(device.info(), source).front().program;
        const auto image = std::make_shared<Image>();
        image->width = 1;
        image->height = 1;
        image->rgba = {0, 0, 0, 0};
        many.images.assign(1000, {"image", image});
        auto handle = device.Load(many);
        ASSERT_FALSE(handle.ok());
        EXPECT_EQ(handle.error().kind, DeviceFailure::Kind::kUnsupported);
    });
}

}  // namespace
}  // namespace etalon
