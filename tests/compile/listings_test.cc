// The sources' listings do not compile as printed (D36 of the thesis, D52 of the blog). Each kind
// of mistake in them, in lines of our own, is refused in its version of GLSL and for the reason
// stated, and the same lines without the mistake are taken.
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace etalon {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Mistake {
    const char* name;
    int version;
    const char* wrong;
    const char* reason;
    const char* right;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << mistake.name;
}

std::string NameOf(const ::testing::TestParamInfo<Mistake>& parameter) {
    return parameter.param.name;
}

class Listings : public ::testing::TestWithParam<Mistake> {
  protected:
    static void SetUpTestSuite() { glslang::InitializeProcess(); }
    static void TearDownTestSuite() { glslang::FinalizeProcess(); }

    // The compiler's messages, or "" where it takes the text as a fragment shader.
    static std::string Messages(const std::string& text) {
        const std::string version = std::to_string(GetParam().version);
        const bool embedded = GetParam().version == 300 || GetParam().version == 310;
        const std::string whole =
            "#version " + version + (embedded ? " es\nprecision highp float;\n" : "\n") + text;
        const char* source = whole.c_str();
        glslang::TShader shader(EShLangFragment);
        shader.setStrings(&source, 1);
        const bool taken = shader.parse(GetDefaultResources(), 100, false, EShMsgDefault);
        return taken ? "" : shader.getInfoLog();
    }
};

TEST_P(Listings, AreRefused) {
    EXPECT_EQ(Messages(GetParam().right), "");
    const std::string messages = Messages(GetParam().wrong);
    EXPECT_THAT(messages, StartsWith("ERROR"));
    EXPECT_THAT(messages, HasSubstr(GetParam().reason));
}

// Of the relief shader.
INSTANTIATE_TEST_SUITE_P(
    D36, Listings,
    ::testing::Values(
        Mistake{"StrayBrace", 120, "float f(float x) { return x; } }", "unexpected RIGHT_BRACE",
                "float f(float x) { return x; }"},
        Mistake{"TwoWordsInOne", 120, "void f() { if (notunder (1 > 0)) {} }", "notunder",
                "void f() { bool under = false; if (!under) {} }"},
        Mistake{"Vec4ToFloat", 120,
                "uniform sampler2D heights; float f(vec2 uv) { float h = texture2D(heights, uv); "
                "return h; }",
                "4-component vector of float' to ' temp float'",
                "uniform sampler2D heights; float f(vec2 uv) { float h = texture2D(heights, uv).x; "
                "return h; }"},
        Mistake{"Vec4ToVec3", 120, "vec3 f(vec4 c) { vec3 colour = c; return colour; }",
                "to ' temp 3-component vector of float'",
                "vec3 f(vec4 c) { vec3 colour = c.rgb; return colour; }"},
        Mistake{"FloatToVec3", 120, "vec3 f(float x) { vec3 colour = x; return colour; }",
                "cannot convert from ' in float' to ' temp 3-component vector of float'",
                "vec3 f(float x) { vec3 colour = vec3(x); return colour; }"},
        Mistake{"HalfAsAName", 450, "float f(float x) { float half = 0.5 * x; return half; }",
                "'half' : Reserved word",
                "float f(float x) { float middle = 0.5 * x; return middle; }"},
        Mistake{"BracesForAnArray", 330,
                "float f(float x) { float a[2] = { x, 1.0 }; return a[0]; }", "style initializers",
                "float f(float x) { float a[2] = float[2](x, 1.0); return a[0]; }"},
        Mistake{"NotOfAnInt", 120, "bool f(int found) { return !found; }",
                "'!' :  wrong operand type", "bool f(int found) { return found == 0; }"},
        Mistake{"IntBesideFloat", 110, "float f(float x) { return x * 2; }",
                "'*' :  wrong operand types", "float f(float x) { return x * 2.0; }"},
        Mistake{"InitialiserOfAUniform", 310, "uniform float u; float twice = 2.0 * u;",
                "initializer", "const float u = 3.0; float twice = 2.0 * u;"},
        Mistake{"RemovedVariable", 330, "vec4 f() { return gl_LightSource[0].position; }",
                "'gl_LightSource' : undeclared identifier",
                "uniform vec4 light_position; vec4 f() { return light_position; }"},
        Mistake{"RemovedTextureFunction", 450,
                "uniform sampler2D map; vec4 f(vec2 uv) { return texture2D(map, uv); }",
                "'texture2D' : no matching overloaded function found",
                "uniform sampler2D map; vec4 f(vec2 uv) { return texture(map, uv); }"}),
    NameOf);

// Of the shadow map's passes.
INSTANTIATE_TEST_SUITE_P(
    D52, Listings,
    ::testing::Values(Mistake{"Vec3ToVec4", 120,
                              "vec4 f(mat4 m, vec3 n) { vec4 turned; turned = (m * vec4(n, "
                              "0.0)).xyz; return turned; }",
                              "cannot convert from ' temp 3-component vector of float' to ' temp "
                              "4-component vector of float'",
                              "vec3 f(mat4 m, vec3 n) { vec3 turned; turned = (m * vec4(n, "
                              "0.0)).xyz; return turned; }"},
                      Mistake{
                          "FiveComponents", 120,
                          "varying vec4 normal; vec4 f() { return vec4(normal * .5 + .5, 1.0); }",
                          "'constructor' : too many arguments",
                          "varying vec3 normal; vec4 f() { return vec4(normal * .5 + .5, 1.0); }"},
                      Mistake{"EnDash", 120, "float f(float x) { return \xE2\x80\x93sign(x); }",
                              "unexpected token", "float f(float x) { return -sign(x); }"},
                      Mistake{"Vec4LessVec3", 120,
                              "vec3 f(vec4 p, vec3 light) { return normalize(p - light).xyz; }",
                              "'-' :  wrong operand types",
                              "vec3 f(vec4 p, vec3 light) { return normalize(p.xyz - light); }"}),
    NameOf);

}  // namespace
}  // namespace etalon
