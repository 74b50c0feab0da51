// What the text must hold to keep the user's places and bits; that it compiles and computes is
// proven with the compiler (tests/compile) and the devices (tests/cmd/probe_test.cc).
#include "probe/generate.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdlib>

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::Not;

Call OneFloat() {
    Call call;
    call.source = "user.glsl";
    call.with = {"scene.glsl"};
    call.defines = {{"STEPS", "4"}};
    call.arguments = {{"x", "float", true, false}};
    call.wanted = {{"result", "f(x)", "CALL"}};
    return call;
}

Dialect DialectOf(std::uint32_t version, bool es = false) {
    Dialect dialect;
    dialect.version = version;
    dialect.es = es;
    return dialect;
}

Signature FloatOfFloat(std::uint32_t version = 450, bool es = false) {
    Signature signature;
    signature.dialect = DialectOf(version, es);
    signature.arguments = {*BasicType("float")};
    signature.wanted = {*BasicType("float")};
    return signature;
}

std::string Whole(const std::vector<Piece>& pieces) {
    std::string text;
    for (const Piece& piece : pieces) {
        text += piece.text;
    }
    return text;
}

std::string Probe(const std::string& recipe, std::vector<std::vector<std::uint32_t>> baked = {},
                  const Signature& signature = FloatOfFloat()) {
    return Whole(ProbeShader(OneFloat(), signature, *ParseRecipe(recipe), baked));
}

TEST(Generate, KeepsTheUsersTextInPiecesOfItsOwn) {
    for (const auto& pieces : {InspectionShader(OneFloat(), DialectOf(450)),
                               ProbeShader(OneFloat(), FloatOfFloat(), Recipe{}, {})}) {
        int calls = 0;
        for (const Piece& piece : pieces) {
            if (piece.name == "CALL") {
                EXPECT_THAT(piece.text, ::testing::StartsWith("f(x)"));
                ++calls;
            } else if (piece.name == kGenerated) {
                EXPECT_THAT(piece.text, Not(HasSubstr("f(x)")));
            } else {
                EXPECT_EQ(piece.name, "input 'x'");
            }
        }
        EXPECT_EQ(calls, 1);
        const std::string text = Whole(pieces);
        EXPECT_THAT(text, HasSubstr("#define STEPS 4\n"));
        EXPECT_LT(text.find("#define STEPS"), text.find("etalon-source:0"));
        EXPECT_LT(text.find("etalon-source:0"), text.find("etalon-source:1"));
    }
}

TEST(Generate, BakesTheRowsAndReadsNone) {
    const std::string at_run_time = Probe("spirv");
    EXPECT_THAT(at_run_time, HasSubstr("etalon_in[0u * etalon_rows"));
    const std::string baked = Probe("spirv+baked", {{0x3f800000u}, {0x40000000u}});
    EXPECT_THAT(baked, Not(HasSubstr("etalon_in[0u * etalon_rows")));
    EXPECT_THAT(baked, HasSubstr("etalon_row == 0u"));
    EXPECT_THAT(baked, HasSubstr("etalon_row == 1u"));
    EXPECT_THAT(baked, Not(HasSubstr("etalon_row == 2u")));
}

TEST(Generate, WritesLiteralsThatReadBackToTheSameBits) {
    for (const std::uint32_t word :
         {0x00000000u, 0x80000000u, 0x3f800000u, 0x3dcccccdu, 0xbeaaaaabu, 0x7f7fffffu, 0x00000001u,
          0x807fffffu, 0x00800000u, 0x4b7fffffu}) {
        const std::string text = Probe("spirv+baked", {{word}});
        const std::size_t at = text.find("etalon_a0 = ");
        ASSERT_NE(at, std::string::npos);
        std::string literal = text.substr(at + 12, text.find(';', at) - at - 12);
        ASSERT_TRUE(literal.starts_with("(") && literal.ends_with(")")) << literal;
        literal = literal.substr(1, literal.size() - 2);
        EXPECT_EQ(std::bit_cast<std::uint32_t>(std::strtof(literal.c_str(), nullptr)), word)
            << literal;
    }
    for (const std::uint32_t word : {0x7f800000u, 0xff800000u, 0x7fc00001u}) {
        EXPECT_THAT(Probe("spirv+baked", {{word}}), HasSubstr("(" + std::to_string(word) + "u)"));
    }
}

TEST(Generate, UsesTheInterfaceOfItsStage) {
    EXPECT_THAT(Probe("spirv"), HasSubstr("local_size_x = 64"));
    EXPECT_THAT(Probe("spirv+fragment"), HasSubstr("gl_FragCoord"));
    EXPECT_THAT(Probe("glsl+fragment"), HasSubstr("texelFetch(etalon_inputs"));
    EXPECT_THAT(Probe("glsl+fragment"), HasSubstr("out uvec4 etalon_target0"));
}

TEST(Generate, DeclaresPreciseInTextOnly) {
    EXPECT_THAT(Probe("glsl+precise"), HasSubstr("precise out float etalon_r0"));
    EXPECT_THAT(Probe("spirv+precise"), Not(HasSubstr("precise out")));
    EXPECT_THAT(Probe("glsl"), Not(HasSubstr("precise out")));
}

TEST(Generate, RenamesLaterKeywordsWhileAnOldSourceIsRead) {
    const std::string old = Probe("spirv", {}, FloatOfFloat(330, false));
    EXPECT_LT(old.find("#define sample "), old.find("etalon-source:0"));
    EXPECT_GT(old.find("#undef sample"), old.find("etalon-source:1"));
    EXPECT_THAT(Probe("spirv", {}, FloatOfFloat(450, false)), Not(HasSubstr("#define sample ")));
    EXPECT_THAT(Probe("spirv", {}, FloatOfFloat(110, false)),
                HasSubstr("#define texture2D texture\n"));
    EXPECT_THAT(Probe("spirv", {}, FloatOfFloat(300, true)), Not(HasSubstr("#define texture2D")));
}

}  // namespace
}  // namespace etalon
