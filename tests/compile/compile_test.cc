#include "compile/compile.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "compile/text.h"

namespace etalon {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class CompileTest : public ::testing::Test {
  protected:
    void SetUp() override {
        folder_ =
            std::filesystem::temp_directory_path() / ("etalon-compile-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path Write(const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder_ / name;
        std::filesystem::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    static Call MakeCall(const std::filesystem::path& source, const std::string& expression,
                         std::vector<Argument> arguments = {}) {
        Call call;
        call.source = source;
        call.arguments = std::move(arguments);
        call.wanted = {{"result", expression, "CALL"}};
        return call;
    }
    std::string InspectError(const std::string& text, const std::string& expression) {
        const Result<Signature> signature = Inspect(MakeCall(Write("x.glsl", text), expression));
        return signature.ok() ? "" : signature.error().message;
    }
    // Everything that a call goes through for this recipe and target; the reason of the failure, or
    // "".
    static std::string CompileError(const Call& call, const std::string& recipe_text,
                                    Target target = {}, Program* out = nullptr) {
        const Result<Signature> signature = Inspect(call);
        if (!signature) {
            return signature.error().message;
        }
        Recipe recipe = *ParseRecipe(recipe_text);
        std::vector<std::vector<std::uint32_t>> baked;
        if (recipe.baked) {
            baked = {std::vector<std::uint32_t>(signature->InputWords(call), 0x3f000000u),
                     std::vector<std::uint32_t>(signature->InputWords(call), 0x7fc00000u)};
        }
        Result<Program, CompileFailure> program = Compile(call, *signature, recipe, target, baked);
        if (!program) {
            return program.error().reason;
        }
        if (out != nullptr) {
            *out = *program;
        }
        return "";
    }

    std::filesystem::path folder_;
};

const Argument kX{"x", "float", true, false};

// GLSL has no way to write a quote in a file's name.
TEST_F(CompileTest, KnowsNamesThatGlslCannotTell) {
    Call call = MakeCall(Write("it's \\n.glsl", "float f() { return 1.0; }\n"), "f()");
    call.wanted[0].origin = "cases/\"two\"\nlines.toml:2: call";
    EXPECT_EQ(CompileError(call, "spirv"), "");
    call.source = Write("\"two\".glsl", "float f() { return 1.0; }\n");
    EXPECT_THAT(CompileError(call, "spirv"),
                ::testing::EndsWith("\"two\".glsl' has a quote or a line's end in its name, which "
                                    "GLSL cannot tell"));
}

TEST_F(CompileTest, FindsTypesOfEveryKind) {
    const auto source = Write("types.glsl",
                              "struct Hit { vec3 position; int layer[2]; };\n"
                              "Hit trace(mat2x3 m, float a[3]) {\n"
                              "  return Hit(m[0], int[2](1, 2)); }\n");
    Call call = MakeCall(source, "trace(m, a)",
                         {{"m", "mat2x3", true, false}, {"a", "float[3]", true, false}});
    const Result<Signature> signature = Inspect(call);
    ASSERT_TRUE(signature.ok()) << signature.error().message;
    std::string columns;
    for (const ProbeColumn& column : OutputColumns(call, *signature)) {
        columns += column.name + ":" + std::string(ScalarName(column.scalar)) + " ";
    }
    EXPECT_EQ(columns,
              "result.position.x:float result.position.y:float result.position.z:float "
              "result.layer[0]:int result.layer[1]:int ");
    EXPECT_EQ(InputColumns(call, *signature).size(), 9u);
    EXPECT_EQ(InputColumns(call, *signature).at(5).name, "m[1].z");
}

TEST_F(CompileTest, TypesFollowTheOverloadThatTheCallPicks) {
    const auto source =
        Write("o.glsl", "float f(float x) { return x; }\nivec2 f(int x) { return ivec2(x); }\n");
    const Call call = MakeCall(source, "f(3)");
    const Result<Signature> signature = Inspect(call);
    ASSERT_TRUE(signature.ok()) << signature.error().message;
    EXPECT_EQ(TypeText(signature->wanted[0]), "ivec2");
}

TEST_F(CompileTest, EveryRecipeCompiles) {
    const auto source =
        Write("f.glsl", "float f(float x, out vec2 t) { t = vec2(x); return x * x + 1.0; }\n");
    Call call = MakeCall(source, "f(x, t)", {kX, {"t", "vec2", false, true}});
    for (const char* recipe : {"spirv", "spirv+O", "spirv+Os", "spirv+precise",
                               "spirv+O+precise+baked", "spirv+fragment", "spirv+baked"}) {
        EXPECT_EQ(CompileError(call, recipe), "") << recipe;
        EXPECT_EQ(CompileError(call, recipe, {Target::Client::kOpenGl, 450}), "") << recipe;
    }
    for (const char* recipe : {"glsl", "glsl+baked", "glsl+fragment", "glsl+precise"}) {
        EXPECT_EQ(CompileError(call, recipe, {Target::Client::kOpenGl, 450}), "") << recipe;
    }
    EXPECT_EQ(CompileError(call, "glsl+fragment", {Target::Client::kOpenGl, 330}), "");
    EXPECT_EQ(CompileError(call, "glsl+baked+fragment", {Target::Client::kOpenGl, 330}), "");
}

TEST_F(CompileTest, SourcesOfOtherVersionsAreAccepted) {
    for (const char* text :
         {"#version 330 core\nfloat f(float sample) { float buffer = sample; return buffer; }\n",
          "#version 300 es\nprecision highp float;\nhighp float f(mediump float x) { float precise "
          "= x; return precise; }\n",
          "precision mediump float;\nfloat f(float x) { vec4 sample = vec4(x); return sample.y; "
          "}\n",
          "#version 450\n#extension GL_ARB_gpu_shader5 : enable\nfloat f(float x) { precise float "
          "y = fma(x, x, x); return y; }\n"}) {
        const Call call = MakeCall(Write("v.glsl", text), "f(x)", {kX});
        EXPECT_EQ(CompileError(call, "spirv"), "") << text;
        EXPECT_EQ(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}), "") << text;
    }
}

TEST_F(CompileTest, ErrorsStandAtTheUsersOwnLine) {
    EXPECT_THAT(InspectError("float f(float x) {\n  return y;\n}\n", "f(1.0)"),
                HasSubstr("x.glsl:2: 'y'"));
    EXPECT_THAT(InspectError("#version 330\n\nfloat f(float x) {\n  retrun x;\n}\n", "f(1.0)"),
                HasSubstr("x.glsl:4: "));
    EXPECT_THAT(InspectError("float f(float x) { return x; }\n", "g(1.0)"),
                StartsWith("CALL:1: 'g'"));
    EXPECT_THAT(InspectError("float f(float x) { return x; }\n", "f(vec2(1.0))"),
                StartsWith("CALL:1: 'f'"));
    EXPECT_THAT(InspectError("float f(float x) { return x;\n", "f(1.0)"), HasSubstr("'"));
}

TEST_F(CompileTest, AnErrorInAnIncludedFileNamesThatFile) {
    Write("lib/inner.glsl", "float inner(float x) {\n  return nowhere;\n}\n");
    const auto source =
        Write("main.glsl", "// one\n#include \"lib/inner.glsl\"\nfloat f() { return 1.0; }");
    const Result<Signature> signature = Inspect(MakeCall(source, "f()"));
    ASSERT_FALSE(signature.ok());
    EXPECT_THAT(signature.error().message, HasSubstr("lib/inner.glsl:2: 'nowhere'"));
}

TEST_F(CompileTest, IncludesAreFoundBesideTheFileAndUnderTheRoots) {
    Write("root/common/a.glsl", "#include \"b.glsl\"\nfloat a() { return b(); }\n");
    Write("root/common/b.glsl", "float b() { return 2.0; }\n");
    const auto source =
        Write("main.glsl", "#include \"common/a.glsl\"\nfloat f() { return a(); }\n");
    Call call = MakeCall(source, "f()");
    EXPECT_THAT(CompileError(call, "spirv"),
                HasSubstr("main.glsl:1: 'common/a.glsl' is not found"));
    call.include_roots = {folder_ / "root"};
    EXPECT_EQ(CompileError(call, "spirv"), "");
}

TEST_F(CompileTest, CyclesAndEscapesAreRefused) {
    Write("cycle_a.glsl", "#include \"cycle_b.glsl\"\n");
    Write("cycle_b.glsl", "\n#include \"cycle_a.glsl\"\n");
    const Result<Signature> cycle = Inspect(MakeCall(folder_ / "cycle_a.glsl", "1.0"));
    ASSERT_FALSE(cycle.ok());
    EXPECT_THAT(cycle.error().message, HasSubstr("cycle_b.glsl:2: "));
    EXPECT_THAT(cycle.error().message, HasSubstr("includes itself"));

    Write("secret.glsl", "float secret() { return 1.0; }\n");
    const auto source =
        Write("deep/main.glsl", "#include \"../secret.glsl\"\nfloat f() { return secret(); }\n");
    Call call = MakeCall(source, "f()");
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("deep/main.glsl:1: "));
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("outside the folders"));
    std::filesystem::create_symlink(folder_ / "secret.glsl", folder_ / "deep/link.glsl");
    Write("deep/main.glsl", "#include \"link.glsl\"\nfloat f() { return secret(); }\n");
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("outside the folders"));
    call.include_roots = {folder_};
    EXPECT_EQ(CompileError(call, "spirv"), "");
}

TEST_F(CompileTest, AnIncludeInADeadBranchIsNotRead) {
    const auto source =
        Write("main.glsl", "#if 0\n#include \"missing.glsl\"\n#endif\nfloat f() { return 1.0; }\n");
    EXPECT_EQ(CompileError(MakeCall(source, "f()"), "spirv"), "");
}

TEST_F(CompileTest, SceneFunctionsComeFromWith) {
    const auto source =
        Write("scene_user.glsl",
              "float height(vec2 uv);\nfloat f(float x) { return height(vec2(x)); }\n");
    Call call = MakeCall(source, "f(x)", {kX});
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("'height' is declared but not defined"));
    call.with = {Write("scene.glsl", "float height(vec2 uv) { return uv.x; }\n")};
    EXPECT_EQ(CompileError(call, "spirv"), "");
    EXPECT_EQ(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}), "");
}

TEST_F(CompileTest, SamplersNeedImages) {
    const auto source =
        Write("s.glsl",
              "uniform sampler2D tex;\nfloat f(float x) { return texture(tex, vec2(x)).r; }\n"
              "uniform float strength;\nfloat g(float x) { return x * strength; }\n");
    Call call = MakeCall(source, "f(x)", {kX});
    EXPECT_THAT(CompileError(call, "spirv+fragment"), HasSubstr("sampler 'tex' has no image"));
    call.images = {{"tex", std::make_shared<Image>(Image{1, 1, {0, 0, 0, 0}})}};
    for (const Target target : {Target{}, Target{Target::Client::kOpenGl, 450}}) {
        Program program;
        EXPECT_EQ(CompileError(call, "spirv", target, &program), "");
        ASSERT_EQ(program.images.size(), 1u);
        EXPECT_EQ(program.images[0].name, "tex");
    }
    call.wanted[0].text = "g(x)";
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("uniform 'strength' has no value"));
}

TEST_F(CompileTest, ASamplerAndItsImageHaveOneShape) {
    const auto source = Write(
        "c.glsl",
        "uniform samplerCube sky;\nfloat f(float x) { return textureLod(sky, vec3(x), 0.0).r; }\n"
        "float g(float x) { return textureLod(sea, vec3(x), 0.0).r; }\n");
    Call call = MakeCall(source, "f(x)", {kX});
    const auto flat = std::make_shared<Image>(Image{1, 1, {0, 0, 0, 0}});
    const auto cube =
        std::make_shared<Image>(Image{1, 1, std::vector<float>(24), 1, ImageShape::kCube});
    call.images = {{"sea", cube}};
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("--image 'sky={ cube = true, ... }'"));
    call.images = {{"sky", flat}, {"sea", cube}};
    EXPECT_THAT(CompileError(call, "spirv"),
                HasSubstr("'sky' is a samplerCube, its image is flat"));
    call.images[0].image = cube;
    EXPECT_EQ(CompileError(call, "spirv"), "");
    EXPECT_EQ(CompileError(call, "glsl+fragment", {Target::Client::kOpenGl, 330}), "");
}

TEST_F(CompileTest, WhatNeedsANewerLanguageIsUnsupportedNotWrong) {
    const auto source = Write("n.glsl", "float f(float x) { return fma(x, x, x); }\n");
    const Call call = MakeCall(source, "f(x)", {kX});
    const Signature signature = *Inspect(call);
    const auto program =
        Compile(call, signature, *ParseRecipe("glsl+fragment"), {Target::Client::kOpenGl, 330}, {});
    ASSERT_FALSE(program.ok());
    EXPECT_EQ(program.error().kind, CompileFailure::Kind::kUnsupported);
}

TEST_F(CompileTest, DerivativesMoveTheProbeToTheFragmentStage) {
    const auto source = Write("d.glsl", "float f(float x) { return dFdx(x); }\n");
    const Result<Signature> signature = Inspect(MakeCall(source, "f(x)", {kX}));
    ASSERT_TRUE(signature.ok()) << signature.error().message;
    EXPECT_EQ(signature->stage, Stage::kFragment);
}

TEST_F(CompileTest, BadSourcesAreNamed) {
    EXPECT_THAT(Inspect(MakeCall(folder_ / "none.glsl", "f()")).error().message,
                HasSubstr("none.glsl: No such file"));
    EXPECT_THAT(Inspect(MakeCall(folder_, "f()")).error().message, HasSubstr("is a folder"));
    EXPECT_THAT(InspectError(std::string("float f()\0;", 11), "f()"), HasSubstr("is not text"));
    EXPECT_THAT(InspectError("void f() {}\n", "f()"), HasSubstr("nothing to see"));
    EXPECT_THAT(InspectError("double f() { return 1.0LF; }\n", "f()"), HasSubstr("cannot carry"));
}

TEST_F(CompileTest, NamesOfTheSourcesDoNotReachTheGeneratedPart) {
    const auto source = Write("macros.glsl",
                              "#define r g\n#define uint vec4\n#define rows 7\n#define if while\n"
                              "float uintBitsToFloat(int x) { return float(x); }\n"
                              "float f(float x) { return x; }\nvoid main() {}\n");
    const Call call = MakeCall(source, "f(x)", {kX});
    for (const char* recipe : {"spirv", "spirv+baked", "spirv+fragment"}) {
        EXPECT_EQ(CompileError(call, recipe), "") << recipe;
    }
    EXPECT_EQ(CompileError(call, "glsl+fragment", {Target::Client::kOpenGl, 330}), "");
    EXPECT_THAT(InspectError("float etalon_in(float x) { return x; }\n", "1.0"),
                HasSubstr("x.glsl:1: 'etalon_in'"));
}

TEST_F(CompileTest, ASourceMayHaveItsOwnVersionOfABuiltInFunction) {
    Write("own/inverse.glsl", "mat3 inverse(mat3 m) { return 2.0 * m; }\n");
    const auto source = Write("own.glsl",
                              "#include \"own/inverse.glsl\"\n"
                              "float round(float x) { return 7.0; }\n"
                              "float f(float x) { return round(x) + inverse(mat3(x))[0].x; }\n");
    const Call call = MakeCall(source, "f(x) + round(x)", {kX});
    EXPECT_EQ(CompileError(call, "spirv"), "");
    EXPECT_EQ(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}), "");
}

TEST_F(CompileTest, FurtherSourcesMayDefineWhatTheFirstOneUsesUndeclared) {
    Call call =
        MakeCall(Write("user.glsl", "float f(float x) { return helper(x); }\n"), "f(x)", {kX});
    call.with = {Write("helper.glsl", "float helper(float x) { return x; }\n")};
    EXPECT_EQ(CompileError(call, "spirv"), "");
}

TEST_F(CompileTest, ASamplerThatNoSourceDeclaresIsDeclared) {
    Call call =
        MakeCall(Write("look.glsl",
                       "float look(sampler2D t, vec2 uv) { return textureLod(t, uv, 0.0).r; }\n"),
                 "look(tex, vec2(x))", {kX});
    call.images = {{"tex", std::make_shared<Image>(Image{1, 1, {0, 0, 0, 0}})}};
    EXPECT_EQ(CompileError(call, "spirv"), "");
    EXPECT_EQ(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}), "");
}

TEST_F(CompileTest, ADriverGetsABodyForWhatTheCallDoesNotReach) {
    const auto source =
        Write("unreached.glsl",
              "float height(vec2 uv);\nfloat use(float x) { return height(vec2(x)); }\n"
              "float f(float x) { return x; }\n");
    Program program;
    Call call = MakeCall(source, "f(x)", {kX});
    ASSERT_EQ(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}, &program), "");
    EXPECT_THAT(program.glsl, HasSubstr("float height(vec2 etalon_p0) {"));
    call.wanted[0].text = "use(x)";
    EXPECT_THAT(CompileError(call, "glsl", {Target::Client::kOpenGl, 450}),
                HasSubstr("'height' is declared but not"));
}

TEST_F(CompileTest, InputsSetUniformsOfTheirNames) {
    Write("light/uniforms.glsl", "uniform float gain;\n");
    const auto source =
        Write("uniforms.glsl",
              "#include \"light/uniforms.glsl\"\n"
              "uniform highp vec2 size;\nuniform vec2 other[2];\nuniform float half_gain = 0.5;\n"
              "float f(float x) { return x * gain * half_gain + size.y; }\n"
              "float g(float x) { return other[1].x; }\n");
    Call call = MakeCall(source, "f(x)",
                         {kX, {"gain", "float", true, false}, {"size", "vec2", true, false}});
    for (const char* recipe : {"spirv", "spirv+baked", "spirv+fragment"}) {
        EXPECT_EQ(CompileError(call, recipe), "") << recipe;
    }
    EXPECT_EQ(CompileError(call, "glsl+fragment", {Target::Client::kOpenGl, 330}), "");
    call.wanted[0].text = "g(x)";
    EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("uniform 'other"));
    Write("uniforms.glsl", "uniform float gain, other;\nfloat f(float x) { return gain; }\n");
    call.wanted[0].text = "f(x)";
    EXPECT_THAT(CompileError(call, "spirv"),
                HasSubstr("uniforms.glsl:1: uniform 'other' has no value"));
}

TEST_F(CompileTest, AUniformMayBeNamedAfterATexture) {
    const auto source =
        Write("named.glsl",
              "uniform float texture_per_height, image_gain;\nuniform vec2 sampler_size[2];\n"
              "float f(float x) { return x * texture_per_height * image_gain; }\n");
    const Call call = MakeCall(
        source, "f(x)",
        {kX, {"texture_per_height", "float", true, false}, {"image_gain", "float", true, false}});
    EXPECT_EQ(CompileError(call, "spirv"), "");
}

TEST_F(CompileTest, OnlyAPlainSamplerTakesAnImage) {
    for (const char* kind :
         {"sampler3D", "isamplerCube", "isampler2D", "sampler2DArray", "sampler2DShadow"}) {
        const std::string text = std::string("uniform ") + kind +
                                 " tex;\nfloat f() { return float(textureSize(tex, 0).x); }\n";
        Call call = MakeCall(Write("kind.glsl", text), "f()");
        call.images = {{"tex", std::make_shared<Image>(Image{1, 1, {0, 0, 0, 0}})}};
        EXPECT_THAT(CompileError(call, "spirv"), HasSubstr("is no plain sampler2D or samplerCube"))
            << kind;
    }
}

TEST_F(CompileTest, WhatIsNoExpressionIsRefusedAsAWhole) {
    for (const char* call :
         {"", " ", ";", "{}", "(x", "x)", "f(x];", "1.0; } void g() {", "a\\", "#if"}) {
        EXPECT_THAT(InspectError("float f(float x) { return x; }\n", call),
                    HasSubstr("is not one GLSL expression"))
            << call;
    }
    EXPECT_THAT(InspectError("float f(float x) { return x; }\n", "float y = 1.0"),
                StartsWith("CALL:1: "));
}

TEST_F(CompileTest, TextOddities) {
    for (const char* text :
         {"\xef\xbb\xbf"
          "float f(float x) { return x; }\n",
          "float f(float x) {\r\n  return \\\r\n x;\r\n}\r\n",
          "#version 100\n#extension GL_OES_standard_derivatives : enable\nvarying vec2 uv;\n"
          "float f(float x) { return x; }\n"}) {
        const Call call = MakeCall(Write("odd.glsl", text), "f(x)", {kX});
        EXPECT_EQ(CompileError(call, "spirv"), "") << text;
        EXPECT_EQ(CompileError(call, "glsl+fragment", {Target::Client::kOpenGl, 330}), "") << text;
    }
    EXPECT_THAT(InspectError("float f() {\\\n return 1.0;\n}\nnonsense\n", "f()"),
                HasSubstr("x.glsl:4: "));
}

TEST_F(CompileTest, WhatGrowsWithoutEndIsRefused) {
    Write("level0.glsl", "\n");
    for (int level = 1; level < 4; ++level) {
        std::string text;
        for (int i = 0; i < 20; ++i) {
            text += "#include \"level" + std::to_string(level - 1) + ".glsl\"\n";
        }
        Write("level" + std::to_string(level) + ".glsl", text);
    }
    EXPECT_THAT(CompileError(MakeCall(folder_ / "level3.glsl", "1.0"), "spirv"),
                HasSubstr("files are included"));
    Call wide = MakeCall(Write("wide.glsl", "void f(out float y[5000]) { y[0] = 1.0; }\n"), "f(y)",
                         {{"y", "float[5000]", false, true}});
    EXPECT_THAT(CompileError(wide, "spirv"), HasSubstr("5000 values a row"));
}

TEST_F(CompileTest, PreciseDecoratesOperations) {
    const auto source = Write("p.glsl", "float f(float x) { return x * x + 1.0; }\n");
    const Call call = MakeCall(source, "f(x)", {kX});
    Program plain;
    Program precise;
    ASSERT_EQ(CompileError(call, "spirv", {}, &plain), "");
    ASSERT_EQ(CompileError(call, "spirv+precise", {}, &precise), "");
    EXPECT_EQ(precise.spirv.size(), plain.spirv.size() + 2 * 3);
}

TEST(TextTest, DriversLogsAreReadBackToTheUsersFile) {
    std::vector<std::string> names;
    const std::string text = DriverText(
        "#line 7 \"a.glsl\"\nfloat x;\n#line 3 \"etalon\"\n#extension GL_ARB_y : enable\n", 450,
        names);
    EXPECT_EQ(text,
              "#version 450 core\n#extension GL_ARB_y : enable\n#line 1 0\n#line 7 1\nfloat "
              "x;\n#line 3 0\n\n");
    EXPECT_EQ(DriverError("0:3(1): warning: w\n1:7(2): error: no\n", names), "a.glsl:7: no");
    EXPECT_EQ(DriverError("1(7) : error C1: no\n", names), "a.glsl:7: no");
    EXPECT_EQ(DriverError("\nlost\n", names), "lost");
}

}  // namespace
}  // namespace etalon
