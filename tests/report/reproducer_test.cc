#include "report/reproducer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <optional>
#include <sstream>

#include "compile/compile.h"
#include "support/folder.h"
#include "support/program.h"

namespace etalon {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

std::uint32_t Bits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

// What piglit makes of the probes at the end of the file.
bool Passes(const std::string& shader_test, std::uint32_t word) {
    std::istringstream lines(shader_test);
    std::string line;
    int probes = 0;
    bool passes = true;
    while (std::getline(lines, line)) {
        std::istringstream words(line);
        std::string probe, ssbo, type, relation, reference;
        unsigned binding = 0, offset = 0;
        if (!(words >> probe >> ssbo >> type >> binding >> offset >> relation >> reference) ||
            probe != "probe") {
            continue;
        }
        ++probes;
        EXPECT_EQ(binding, 1u);
        EXPECT_EQ(offset, 4u);
        const auto against = std::stoll(reference, nullptr, 0);
        const long long seen = type == "int" ? static_cast<std::int32_t>(word) : std::int64_t{word};
        passes = passes && (relation == "=="   ? seen == against
                            : relation == "<=" ? seen <= against
                                               : seen >= against);
    }
    EXPECT_GT(probes, 0);
    return passes;
}

Reproduction Between(float low, float high) {
    Reproduction reproduction;
    reproduction.outputs = 2;
    reproduction.output = 1;
    reproduction.low = Bits(low);
    reproduction.high = Bits(high);
    return reproduction;
}

TEST(ShaderTest, AllowsTheIntervalAndNothingElse) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float ends[] = {-kInfinity, -3.0f, -0x1p-149f, -0.0f, 0.0f, 0x1p-149f, 2.0f, kInfinity};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const float values[] = {-kInfinity, -4.0f, -3.0f, -1.0f, -0x1p-149f, -0.0f,     0.0f, 0x1p-149f,
                            1.0f,       2.0f,  3.0f,  nan,   -nan,       kInfinity, 3e38f};
    for (const float low : ends) {
        for (const float high : ends) {
            if (low > high) {
                continue;
            }
            const std::string text = ShaderTest(Between(low, high), "", 450);
            for (const float value : values) {
                EXPECT_EQ(Passes(text, Bits(value)), low <= value && value <= high)
                    << value << " in " << low << " .. " << high;
            }
        }
    }
}

TEST(ShaderTest, TakesAWordThatIsNoFloatAsItIs) {
    Reproduction reproduction = Between(0, 0);
    reproduction.is_float = false;
    reproduction.low = reproduction.high = 0x80000000u;
    const std::string text = ShaderTest(reproduction, "", 450);
    EXPECT_TRUE(Passes(text, 0x80000000u));
    EXPECT_FALSE(Passes(text, 0));
}

TEST(ShaderTest, BringsTheShaderAndItsInputs) {
    Reproduction reproduction = Between(1, 2);
    reproduction.notes = {"a note", ""};
    reproduction.inputs = {Bits(-1.0f), 7};
    const std::string glsl = "#version 450 core\n#line 1 0\n\nvoid main() {\n}\n";
    const std::string text = ShaderTest(reproduction, glsl, 450);
    EXPECT_THAT(text, StartsWith("# Written by `etalon run --findings`.\n#\n# a note\n#\n"));
    EXPECT_THAT(text, HasSubstr("\nGLSL >= 4.50\n\n[compute shader]\n#version 450 core\n"
                                "void main() {\n}\n\n[test]\nssbo 0 12\n"));
    EXPECT_THAT(text, HasSubstr("ssbo 0 subdata int 0 1\nssbo 0 subdata int 4 -1082130432\n"
                                "ssbo 0 subdata int 8 7\nssbo 1 8\ncompute 1 1 1\n"));
    EXPECT_THAT(text, Not(HasSubstr("ARB_compute_shader")));
    const std::string old = ShaderTest(reproduction, glsl, 330);
    EXPECT_THAT(old, HasSubstr("\nGLSL >= 3.30\nGL_ARB_compute_shader\n"));
    EXPECT_THAT(old, HasSubstr("#version 330 core\n#extension GL_ARB_compute_shader : require\n"));
}

TEST(Reproducer, IsKnownByItsFirstLine) {
    EXPECT_TRUE(IsReproducer(ShaderTest(Between(1, 2), "", 450)));
    EXPECT_TRUE(IsReproducer(VulkanProgram(Between(1, 2), {}, "llvmpipe")));
    EXPECT_FALSE(IsReproducer(""));
    EXPECT_FALSE(IsReproducer("int main;\n// Written by `etalon run --findings`.\n"));
}

// x + 1 at 1, which is 2 everywhere, run by the tools themselves.
class ReproducerRun : public ::testing::Test {
  protected:
    void SetUp() override {
        call_.source = folder_.Write("f.glsl", "\n");
        call_.arguments = {{"x", "float", true, false}};
        call_.wanted = {{"result", "vec2(x, x + 1.0)", "CALL"}};
        const Result<Signature> signature = Inspect(call_);
        ASSERT_TRUE(signature.ok()) << signature.error().message;
        signature_ = *signature;
    }
    Program Compiled(Form form, Target target) {
        Recipe recipe;
        recipe.form = form;
        const auto program = Compile(call_, signature_, recipe, target, {});
        EXPECT_TRUE(program.ok());
        return *program;
    }
    static Reproduction At1(float low, float high) {
        Reproduction reproduction = Between(low, high);
        reproduction.inputs = {Bits(1)};
        return reproduction;
    }
    std::string Vulkan(float low, float high) {
        const Program program = Compiled(Form::kSpirv, {});
        return VulkanProgram(At1(low, high), program.spirv, "llvmpipe");
    }
    std::string Piglit(float low, float high, std::uint32_t version) {
        const Program program = Compiled(Form::kGlsl, {Target::Client::kOpenGl, 450});
        return ShaderTest(At1(low, high), program.glsl, version);
    }
    // By ci/reproduce.sh; nothing where that cannot run it here.
    std::optional<bool> Shows(const std::string& name, const std::string& text) {
        const Finished finished = RunProgram({"ci/reproduce.sh", folder_.Write(name, text)});
        if (finished.status == 2) {
            EXPECT_THAT(finished.out, ::testing::AnyOf(HasSubstr("there is no shader_runner"),
                                                       HasSubstr("no device's name contains"),
                                                       HasSubstr("vkCreateInstance")));
            return std::nullopt;
        }
        EXPECT_THAT(finished.out,
                    HasSubstr(finished.status == 0 ? ": shows it\n" : ": does not show it\n"));
        return finished.status == 0;
    }

    Folder folder_;
    Call call_;
    Signature signature_;
};

TEST_F(ReproducerRun, TheCompilersProgramTellsWhatIsAllowed) {
    const std::optional<bool> outside = Shows("vulkan-llvmpipe-add.c", Vulkan(2.5f, 3));
    if (!outside) {
        GTEST_SKIP() << "no llvmpipe behind the Vulkan loader";
    }
    EXPECT_TRUE(*outside);
    EXPECT_EQ(Shows("vulkan-llvmpipe-add.c", Vulkan(-1, 2)), false);
    EXPECT_EQ(Shows("vulkan-llvmpipe-add.c", Vulkan(2, 2)), false);
    EXPECT_EQ(Shows("vulkan-llvmpipe-add.c", Vulkan(-3, -2)), true);
}

TEST_F(ReproducerRun, ShaderRunnerTellsWhatIsAllowed) {
    for (const std::uint32_t version : {450u, 330u}) {
        const std::string name =
            version == 450 ? "egl-llvmpipe-add.shader_test" : "egl-softpipe-add.shader_test";
        const std::optional<bool> outside = Shows(name, Piglit(2.5f, 3, version));
        if (!outside) {
            GTEST_SKIP() << "no shader_runner of piglit's";
        }
        EXPECT_TRUE(*outside);
        EXPECT_EQ(Shows(name, Piglit(-1, 2, version)), false);
        EXPECT_EQ(Shows(name, Piglit(2, 2, version)), false);
        EXPECT_EQ(Shows(name, Piglit(-3, -2, version)), true);
    }
}

}  // namespace
}  // namespace etalon
