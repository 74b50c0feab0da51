// The backend itself, on every driver of this machine that opens. Drivers are loaded into this
// process: what a crash costs is the worker's to test.
#include "device/vulkan/vulkan_device.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <numeric>

#include "base/file.h"
#include "device/timing.h"

// Drivers keep memory when they are unloaded, which a build with sanitizers would count as leaks.
extern "C" const char* __asan_default_options();   // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() {  // NOLINT(bugprone-reserved-identifier)
    return "detect_leaks=0";
}

namespace etalon {
namespace {

namespace fs = std::filesystem;
using Kind = DeviceFailure::Kind;

std::vector<std::uint32_t> Compile(Stage stage, const std::string& source) {
    static const bool initialized = glslang::InitializeProcess();
    EXPECT_TRUE(initialized);
    const EShLanguage language = stage == Stage::kCompute ? EShLangCompute : EShLangFragment;
    glslang::TShader shader(language);
    const char* const text = source.c_str();
    shader.setStrings(&text, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, language, glslang::EShClientVulkan, 100);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    EXPECT_TRUE(shader.parse(GetDefaultResources(), 450, false, messages)) << shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    EXPECT_TRUE(program.link(messages)) << program.getInfoLog();
    std::vector<std::uint32_t> spirv;
    glslang::GlslangToSpv(*program.getIntermediate(language), spirv);
    return spirv;
}

// A program whose body computes from `row`, `rows`, inputs.words and writes outputs.words.
Program MakeProgram(Stage stage, std::uint32_t input_words, std::uint32_t output_words,
                    const std::string& body, const std::string& declarations = "") {
    const bool compute = stage == Stage::kCompute;
    const std::string layout =
        "layout(set = 0, binding = 0, std430) readonly buffer I { uint rows; uint words[]; } i;\n"
        "layout(set = 0, binding = 1, std430) buffer O { uint words[]; } o;\n";
    const std::string row = compute
                                ? "uint row = gl_GlobalInvocationID.x;\n"
                                : "uint row = uint(gl_FragCoord.y) * " +
                                      std::to_string(kFragmentWidth) + " + uint(gl_FragCoord.x);\n";
    Program program;
    program.stage = stage;
    program.input_words = input_words;
    program.output_words = output_words;
    program.spirv = Compile(
        stage, "#version 450\n" +
                   (compute ? "layout(local_size_x = " + std::to_string(kLocalSize) + ") in;\n"
                            : std::string()) +
                   layout + declarations + "void main() {\n" + row +
                   "uint rows = i.rows;\nif (row >= rows) { return; }\n" + body + "\n}\n");
    return program;
}

// Two inputs, two outputs, exact in binary32: a * 0.5 + b, and the row.
constexpr const char* kBody =
    "float a = uintBitsToFloat(i.words[row]);\n"
    "float b = uintBitsToFloat(i.words[rows + row]);\n"
    "o.words[row] = floatBitsToUint(a * 0.5 + b);\n"
    "o.words[rows + row] = row;\n";

constexpr const char* kLong =
    "uint a = i.words[row];\n"
    "for (int k = 0; k < 100; ++k) { a = a * 1664525u + 1013904223u; }\n"
    "o.words[row] = a;\n";

// As the program started: entering a candidate changes what would be found.
const std::vector<Candidate>& AllCandidates() {
    static const std::vector<Candidate> candidates = VulkanCandidates({});
    return candidates;
}

void Enter(const Candidate& candidate) {
    for (const auto& [name, value] : candidate.environment) {
        setenv(name.c_str(), value.c_str(), 1);
    }
}

// An open device and how the tests use it.
struct Subject {
    std::unique_ptr<Device> device;

    bool HasFragment() const { return device->info().Has("fragment"); }

    std::uint32_t Load(const Program& program) {
        const auto handle = device->Load(program);
        if (!handle) {
            ADD_FAILURE() << handle.error().reason;
            return 0;
        }
        return *handle;
    }

    std::vector<std::uint32_t> Run(std::uint32_t handle, std::uint32_t rows,
                                   const std::vector<std::uint32_t>& inputs,
                                   std::uint32_t output_words) {
        std::vector<std::uint32_t> outputs(std::size_t{output_words} * rows, 0xdeadbeef);
        const auto done = device->Run(handle, rows, inputs, outputs, nullptr);
        EXPECT_TRUE(done.ok()) << done.error().reason;
        return outputs;
    }

    void ExpectBody(std::uint32_t handle, std::uint32_t rows) {
        std::vector<std::uint32_t> inputs(2 * rows);
        std::vector<std::uint32_t> expected(2 * rows);
        for (std::uint32_t row = 0; row < rows; ++row) {
            const auto a = static_cast<float>(row % 4096);
            const auto b = -1.0f - static_cast<float>(row % 7);
            inputs[row] = std::bit_cast<std::uint32_t>(a);
            inputs[rows + row] = std::bit_cast<std::uint32_t>(b);
            expected[row] = std::bit_cast<std::uint32_t>(a * 0.5f + b);
            expected[rows + row] = row;
        }
        EXPECT_TRUE(Run(handle, rows, inputs, 2) == expected) << rows << " rows";
    }
};

void OnEveryDevice(const std::function<void(Subject&)>& test) {
    bool ran = false;
    for (const Candidate& candidate : AllCandidates()) {
        SCOPED_TRACE(candidate.hint);
        Enter(candidate);
        auto opened = OpenVulkanDevice(candidate);
        if (!opened) {
            EXPECT_EQ(opened.error().kind, Kind::kUnsupported) << opened.error().reason;
            continue;
        }
        Subject subject{std::move(*opened)};
        test(subject);
        ran = true;
    }
    if (!ran) {
        GTEST_SKIP() << "no Vulkan device opens";
    }
}

TEST(VulkanDevice, SaysWhatItIs) {
    OnEveryDevice([](Subject& subject) {
        const DeviceInfo& info = subject.device->info();
        EXPECT_TRUE(info.name.starts_with("vulkan:")) << info.name;
        EXPECT_TRUE(info.api.starts_with("Vulkan 1.")) << info.api;
        EXPECT_FALSE(info.description.empty());
        EXPECT_FALSE(info.version.empty());
        EXPECT_TRUE(info.Has("compute"));
        EXPECT_TRUE(info.Has("spirv"));
        EXPECT_EQ(info.glsl_version, 0u);
        EXPECT_GE(info.siblings, 1u);
        EXPECT_GE(info.max_rows, 1u << 16);
        RecordProperty("device", info.name + ", " + info.description + ", " + info.driver + ", " +
                                     info.version + ", " + info.api + ", " + info.compiler);
    });
}

TEST(VulkanDevice, ComputesEveryRow) {
    OnEveryDevice([](Subject& subject) {
        const std::uint32_t handle = subject.Load(MakeProgram(Stage::kCompute, 2, 2, kBody));
        for (const std::uint32_t rows : {1u, 63u, 64u, 65u, 5000u, 100'003u, 3u}) {
            subject.ExpectBody(handle, rows);
        }
    });
}

TEST(VulkanDevice, DrawsEveryRow) {
    OnEveryDevice([](Subject& subject) {
        if (!subject.HasFragment()) {
            return;
        }
        const std::uint32_t handle = subject.Load(MakeProgram(Stage::kFragment, 2, 2, kBody));
        for (const std::uint32_t rows : {1u, 1023u, 1024u, 1025u, 100'003u, 3u}) {
            subject.ExpectBody(handle, rows);
        }
    });
}

TEST(VulkanDevice, RunsAsManyRowsAsItSays) {
    OnEveryDevice([](Subject& subject) {
        for (const Stage stage : {Stage::kCompute, Stage::kFragment}) {
            if (stage == Stage::kCompute || subject.HasFragment()) {
                subject.ExpectBody(subject.Load(MakeProgram(stage, 2, 2, kBody)),
                                   subject.device->info().max_rows);
            }
        }
    });
}

TEST(VulkanDevice, RunsBakedInputs) {
    OnEveryDevice([](Subject& subject) {
        const std::uint32_t handle =
            subject.Load(MakeProgram(Stage::kCompute, 0, 1, "o.words[row] = row * 3u + rows;"));
        const auto outputs = subject.Run(handle, 1000, {}, 1);
        for (std::uint32_t row = 0; row < 1000; ++row) {
            ASSERT_EQ(outputs[row], row * 3 + 1000);
        }
    });
}

TEST(VulkanDevice, TimesRuns) {
    OnEveryDevice([](Subject& subject) {
        for (const Stage stage : {Stage::kCompute, Stage::kFragment}) {
            if (stage == Stage::kCompute || subject.HasFragment()) {
                ExpectTimesToGrow(*subject.device, subject.Load(MakeProgram(stage, 1, 1, kLong)),
                                  1u << 17);
            }
        }
    });
}

TEST(VulkanDevice, KeepsSeveralProgramsAlive) {
    OnEveryDevice([](Subject& subject) {
        std::vector<std::uint32_t> handles;
        for (const char* factor : {"2u", "3u", "5u"}) {
            handles.push_back(subject.Load(
                MakeProgram(Stage::kCompute, 1, 1,
                            std::string("o.words[row] = i.words[row] * ") + factor + ";")));
        }
        // The second round is larger than the buffers of the first.
        for (const std::uint32_t rows : {100u, 200'000u, 7u}) {
            std::vector<std::uint32_t> inputs(rows);
            std::iota(inputs.begin(), inputs.end(), 1u);
            EXPECT_EQ(subject.Run(handles[2], rows, inputs, 1).back(), rows * 5);
            EXPECT_EQ(subject.Run(handles[0], rows, inputs, 1).back(), rows * 2);
            EXPECT_EQ(subject.Run(handles[1], rows, inputs, 1).back(), rows * 3);
        }
    });
}

TEST(VulkanDevice, ShowsNoResultsOfAnEarlierProgram) {
    OnEveryDevice([](Subject& subject) {
        const std::uint32_t first =
            subject.Load(MakeProgram(Stage::kCompute, 0, 1, "o.words[row] = 7u;"));
        const std::uint32_t second = subject.Load(
            MakeProgram(Stage::kCompute, 0, 1, "if (row % 2u == 0u) { o.words[row] = 7u; }"));
        EXPECT_EQ(subject.Run(first, 2, {}, 1), (std::vector<std::uint32_t>{7, 7}));
        const auto outputs = subject.Run(second, 2, {}, 1);
        EXPECT_EQ(outputs[0], 7u);
        EXPECT_TRUE(std::isnan(std::bit_cast<float>(outputs[1]))) << outputs[1];
    });
}

TEST(VulkanDevice, FiltersAndWrapsImages) {
    OnEveryDevice([](Subject& subject) {
        auto first = std::make_shared<Image>(Image{4, 2, std::vector<float>(32)});
        for (std::size_t i = 0; i < 32; ++i) {
            first->rgba[i] = static_cast<float>(i);
        }
        auto second = std::make_shared<Image>(Image{1, 1, {0.25f, 1e30f, -7.0f, 1.0f}});
        const std::string declarations =
            "layout(set = 0, binding = 2) uniform sampler2D first;\n"
            "layout(set = 0, binding = 3) uniform sampler2D second;\n";
        // Texel centres are exact; half way between two columns filters to their mean.
        const std::string body =
            "vec2 uv = vec2(uintBitsToFloat(i.words[row]), uintBitsToFloat(i.words[rows + row]));\n"
            "vec4 a = textureLod(first, uv, 0.0);\n"
            "o.words[row] = floatBitsToUint(a.x);\n"
            "o.words[rows + row] = floatBitsToUint(textureLod(second, uv, 0.0).y);\n";
        const std::vector<std::array<float, 3>> points = {
            {0.125f, 0.25f, 0.0f}, {0.375f, 0.25f, 4.0f},   {0.125f, 0.75f, 16.0f},
            {1.125f, 0.25f, 0.0f}, {-0.125f, 0.25f, 12.0f}, {0.25f, 0.25f, 2.0f},
            {0.0f, 0.25f, 6.0f},  // between the last column and the first
            {0.125f, 0.5f, 8.0f},
        };
        const auto rows = static_cast<std::uint32_t>(points.size());
        std::vector<std::uint32_t> inputs(2 * rows);
        for (std::uint32_t row = 0; row < rows; ++row) {
            inputs[row] = std::bit_cast<std::uint32_t>(points[row][0]);
            inputs[rows + row] = std::bit_cast<std::uint32_t>(points[row][1]);
        }
        for (const Stage stage : {Stage::kCompute, Stage::kFragment}) {
            if (stage == Stage::kFragment && !subject.HasFragment()) {
                continue;
            }
            Program program = MakeProgram(stage, 2, 2, body, declarations);
            program.images = {{"first", first}, {"second", second}};
            const auto outputs = subject.Run(subject.Load(program), rows, inputs, 2);
            for (std::uint32_t row = 0; row < rows; ++row) {
                EXPECT_EQ(std::bit_cast<float>(outputs[row]), points[row][2]) << row;
                EXPECT_EQ(std::bit_cast<float>(outputs[rows + row]), 1e30f) << row;
            }
        }
    });
}

TEST(VulkanDevice, ComputesInBinary64WhereItSaysSo) {
    OnEveryDevice([](Subject& subject) {
        const std::string body =
            "double x = double(uintBitsToFloat(i.words[row])) + 1e-12lf;\n"
            "uvec2 bits = unpackDouble2x32(x);\no.words[row] = bits.x;\no.words[rows + row] = "
            "bits.y;";
        const auto handle = subject.device->Load(MakeProgram(Stage::kCompute, 1, 2, body));
        if (!subject.device->info().Has("float64")) {
            ASSERT_FALSE(handle.ok());
            EXPECT_EQ(handle.error().kind, Kind::kUnsupported);
            EXPECT_EQ(handle.error().reason, "the device has no Float64");
            return;
        }
        ASSERT_TRUE(handle.ok()) << handle.error().reason;
        const auto outputs = subject.Run(*handle, 1, {std::bit_cast<std::uint32_t>(1.0f)}, 2);
        EXPECT_EQ(std::uint64_t{outputs[1]} << 32 | outputs[0],
                  std::bit_cast<std::uint64_t>(1.0 + 1e-12));
    });
}

TEST(VulkanDevice, SkipsWhatItCannotTake) {
    OnEveryDevice([](Subject& subject) {
        Program text = MakeProgram(Stage::kCompute, 0, 1, "o.words[row] = 1u;");
        text.form = Form::kGlsl;
        EXPECT_EQ(subject.device->Load(text).error().kind, Kind::kUnsupported);

        Program nonsense;
        nonsense.output_words = 1;
        nonsense.spirv = {1, 2, 3, 4, 5, 6};
        EXPECT_EQ(subject.device->Load(nonsense).error().reason, "the module is not SPIR-V");

        Program wide = MakeProgram(Stage::kCompute, 0, 1, "o.words[row] = 1u;");
        auto image = std::make_shared<Image>(Image{1u << 20, 1, std::vector<float>(4u << 20)});
        wide.images = {{"wide", image}};
        EXPECT_EQ(subject.device->Load(wide).error().kind, Kind::kUnsupported);
    });
}

// The embedded default must never silently drop out of the tests above.
TEST(VulkanDrivers, LavapipeOpensWhereItIsInstalled) {
    for (const Candidate& candidate : AllCandidates()) {
        if (candidate.hint.find("lvp_icd") == std::string::npos) {
            continue;
        }
        Enter(candidate);
        const auto device = OpenVulkanDevice(candidate);
        ASSERT_TRUE(device.ok()) << device.error().reason;
        const DeviceInfo& info = (*device)->info();
        EXPECT_EQ(info.name, "vulkan:llvmpipe");
        EXPECT_EQ(info.driver, "llvmpipe");
        EXPECT_THAT(info.compiler, testing::StartsWith("LLVM "));
        EXPECT_TRUE(info.Has("fragment"));
        EXPECT_TRUE(info.Has("float64"));

        Candidate second = candidate;
        second.index = info.siblings;
        EXPECT_EQ(OpenVulkanDevice(second).error().kind, Kind::kUnsupported);

        // The same driver as if it lay under a prefix: by its library alone.
        Candidate prefixed = candidate;
        auto text = ReadTextFile(candidate.hint);
        ASSERT_TRUE(text.ok());
        const std::string& json = *text;
        const std::size_t begin = json.find("/usr");
        if (begin != std::string::npos) {
            prefixed.hint = json.substr(begin, json.find('"', begin) - begin);
            prefixed.driver = "mine";
            const auto mine = OpenVulkanDevice(prefixed);
            ASSERT_TRUE(mine.ok()) << mine.error().reason;
            EXPECT_EQ((*mine)->info().name, "vulkan:llvmpipe@mine");
            EXPECT_FALSE(fs::exists(std::getenv("VK_DRIVER_FILES")));
        }
        return;
    }
    GTEST_SKIP() << "lavapipe is not installed";
}

TEST(VulkanDrivers, NonsenseIsUnsupported) {
    const fs::path file = fs::path(testing::TempDir()) / "nonsense_icd.json";
    const auto open = [&](const std::string& json) {
        EXPECT_TRUE(WriteFile(file, json).ok());
        Candidate candidate;
        candidate.hint = file.string();
        candidate.environment = {{"VK_DRIVER_FILES", candidate.hint}};
        Enter(candidate);
        return OpenVulkanDevice(candidate).error();
    };
    const DeviceFailure no_json = open("nonsense");
    EXPECT_EQ(no_json.kind, Kind::kUnsupported);
    EXPECT_EQ(no_json.reason, file.string() + ": names no library_path");
    const DeviceFailure no_library = open(R"({"ICD": {"library_path": "/nowhere/lib.so"}})");
    EXPECT_EQ(no_library.kind, Kind::kUnsupported);
    EXPECT_THAT(no_library.reason, testing::HasSubstr("/nowhere/lib.so"));
    const DeviceFailure no_driver =
        open(R"({"file_format_version": "1.0.0", "ICD": {"library_path": "libm.so.6",)"
             R"( "api_version": "1.1.0"}})");
    EXPECT_EQ(no_driver.kind, Kind::kUnsupported);
    fs::remove(file);
}

}  // namespace
}  // namespace etalon
