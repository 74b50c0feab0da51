// The contract of `etalon probe`: what its tables take and give, to the bit.
#include <gmock/gmock.h>

#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::vector<std::string> Fields(const std::string& line) {
    std::vector<std::string> fields(1);
    for (const char c : line) {
        if (c == ',') {
            fields.emplace_back();
        } else {
            fields.back() += c;
        }
    }
    return fields;
}

// The bits of a float as the C library reads it.
std::uint32_t Bits(const std::string& text) {
    return std::bit_cast<std::uint32_t>(std::strtof(text.c_str(), nullptr));
}

bool IsNan(std::uint32_t bits) {
    return std::isnan(std::bit_cast<float>(bits));
}

// A float of these bits, written in one of three ways.
std::string Written(std::uint32_t bits, int way) {
    const float value = std::bit_cast<float>(bits);
    if (std::isnan(value)) {
        return "nan";
    }
    if (std::isinf(value)) {
        return value > 0 ? "inf" : "-inf";
    }
    char text[200];
    const char* const formats[] = {"%.9g", "%a", "%.150f"};
    std::snprintf(text, sizeof text, formats[way], static_cast<double>(value));
    return text;
}

std::vector<std::uint32_t> Patterns(std::size_t count) {
    std::vector<std::uint32_t> all = {0x00000000u, 0x80000000u, 0x00000001u, 0x80000001u,
                                      0x007fffffu, 0x00800000u, 0x80800000u, 0x3f800000u,
                                      0x3f7fffffu, 0x7f7fffffu, 0xff7fffffu, 0x7f800000u,
                                      0xff800000u, 0x7fc00000u, 0x3dcccccdu};
    std::mt19937 random(1);
    for (int i = 0; i < 100; ++i) {
        all.push_back(static_cast<std::uint32_t>(random()) & 0x807fffffu);  // subnormals
    }
    while (all.size() < count) {
        all.push_back(static_cast<std::uint32_t>(random()));
    }
    return all;
}

bool IsSubnormal(std::uint32_t bits) {
    return (bits & 0x7f800000u) == 0 && (bits & 0x007fffffu) != 0;
}

class Probe : public testing::Test {
  protected:
    Probe() {
        folder_.Write("f.glsl", kSource);
        options_.folder = folder_.path();
    }
    void SetUp() override { ETALON_NEED_DEVICE(); }

    Finished Run(const std::string& call, std::vector<std::string> more = {},
                 const std::string& source = "f.glsl") {
        std::vector<std::string> words = {"probe", source, call, "--csv"};
        if (std::find(more.begin(), more.end(), "-d") == more.end()) {
            words.insert(words.end(), {"-d", SoftwareDevice()});
        }
        words.insert(words.end(), more.begin(), more.end());
        const Finished finished = RunEtalon(words, options_);
        EXPECT_EQ(finished.status, 0) << finished.err;
        EXPECT_EQ(finished.err, "");
        return finished;
    }
    // The lines of the table, without device and recipe.
    std::vector<std::string> Table(const std::string& call, std::vector<std::string> more = {},
                                   const std::string& source = "f.glsl") {
        std::vector<std::string> lines = Lines(Run(call, std::move(more), source).out);
        for (std::string& line : lines) {
            line = line.substr(line.find(',', line.find(',') + 1) + 1);
        }
        return lines;
    }
    std::string Inputs(const std::string& csv) {
        folder_.Write("in.csv", csv);
        return "in.csv";
    }

    static constexpr const char* kSource = R"(
struct Hit { vec3 position; float depth; bool inside; };
float scaled(float x) {
#ifdef SCALE
    return float(SCALE) * x;
#else
    return x;
#endif
}
uint bits(float x) { return floatBitsToUint(x); }
vec3 turned(vec3 v) { return v.yzx; }
void split(float x, out float whole, out int steps, inout float sum) {
    whole = floor(x);
    steps = int(whole);
    sum += x;
}
Hit hit_at(float x) { return Hit(vec3(x, x + 1.0, x + 2.0), -x, x > 0.0); }
float element(mat2x3 m) { return m[1].z; }
float total(float[3] values) { return values[0] + 2.0 * values[1] + 4.0 * values[2]; }
)";
    Folder folder_;
    ProgramOptions options_;
};

TEST_F(Probe, ColumnsStandInTheOrderOfTheContract) {
    const std::vector<std::string> lines =
        Lines(Run("split(x, whole, steps, sum)",
                  {"--inputs", Inputs("sum:float,x:float\n10,2.5\n20,-0.25\n"), "--out",
                   "whole:float", "--out", "steps:int", "--out", "sum:float", "--recipe", "glsl"})
                  .out);
    const std::string start = SoftwareDevice() + ",";
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0], "device,recipe,sum,x,sum,whole,steps");
    EXPECT_THAT(lines[1], AllOf(StartsWith(start), HasSubstr(",10,2.5,12.5,2,2")));
    EXPECT_THAT(lines[2], AllOf(StartsWith(start), HasSubstr(",20,-0.25,19.75,-1,-1")));
}

TEST_F(Probe, TakesVectorsIntegersAndBools) {
    EXPECT_THAT(Table("turned(v)", {"--inputs", Inputs("v.x:float,v.y:float,v.z:float\n1,2,3\n")}),
                ElementsAre("v.x,v.y,v.z,result.x,result.y,result.z", "1,2,3,2,3,1"));
    EXPECT_THAT(Table("turned(v)", {"--inputs", Inputs("v.z:float,v.x:float,v.y:float\n3,1,2\n")}),
                ElementsAre("v.x,v.y,v.z,result.x,result.y,result.z", "1,2,3,2,3,1"));
    EXPECT_THAT(
        Table("b ? i : -i", {"--inputs", Inputs("i:int,b:bool\n-7,true\n-2147483648,0\n8,0\n")}),
        ElementsAre("i,b,result", "-7,true,-7", "-2147483648,false,-2147483648", "8,false,-8"));
    EXPECT_THAT(Table("u + 1u", {"--inputs", Inputs("u:uint\n4294967295\n0xff\n")}),
                ElementsAre("u,result", "4294967295,0", "255,256"));
    EXPECT_THAT(Table("ivec2(w.y, -w.x)", {"--at", "w.x:int=1,w.y:int=2"}),
                ElementsAre("w.x,w.y,result.x,result.y", "1,2,2,-1"));
    EXPECT_THAT(Table("x > 1.0", {"--inputs", Inputs("x:float\n1\n1.0000001\n")}),
                ElementsAre("x,result", "1,false", "1.0000001,true"));
}

TEST_F(Probe, TakesMatricesArraysAndStructures) {
    EXPECT_THAT(Table("hit_at(x)", {"--at", "x=2"}),
                ElementsAre("x,result.position.x,result.position.y,result.position.z,result.depth,"
                            "result.inside",
                            "2,2,3,4,-2,true"));
    EXPECT_THAT(Table("element(m)", {"--in", "m:mat2x3", "--at",
                                     "m[0].x=1,m[0].y=2,m[0].z=3,m[1].x=4,m[1].y=5,m[1].z=6"}),
                ElementsAre("m[0].x,m[0].y,m[0].z,m[1].x,m[1].y,m[1].z,result", "1,2,3,4,5,6,6"));
    EXPECT_THAT(Table("total(a)", {"--in", "a:float[3]", "--at", "a[0]=1,a[1]=1,a[2]=1"}),
                ElementsAre("a[0],a[1],a[2],result", "1,1,1,7"));
    EXPECT_THAT(Table("h.position.y + h.depth",
                      {"--in", "h:Hit", "--at",
                       "h.position.x=1,h.position.y=2,h.position.z=3,h.depth=4,h.inside:bool=1"}),
                ElementsAre("h.position.x,h.position.y,h.position.z,h.depth,h.inside,result",
                            "1,2,3,4,true,6"));
}

TEST_F(Probe, TakesNoInputs) {
    EXPECT_THAT(Table("scaled(1.5)"), ElementsAre("result", "1.5"));
}

TEST_F(Probe, TakesEveryWayToWriteANumber) {
    EXPECT_THAT(Table("bits(x)", {"--inputs", Inputs("x:float\r\n0x1.8p-3\r\n1e-45\r\n-0\r\ninf\r\n"
                                                     "-inf\r\n.5\r\n+2\r\n")}),
                ElementsAre("x,result", "0.1875,1044381696", "1e-45,1", "-0,2147483648",
                            "inf,2139095040", "-inf,4286578688", "0.5,1056964608", "2,1073741824"));
}

TEST_F(Probe, ReadsAndWritesEveryPatternToTheSameBits) {
    const std::vector<std::uint32_t> patterns = Patterns(3'000);
    std::string csv = "x:float\n";
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        csv += Written(patterns[i], static_cast<int>(i % 3)) + "\n";
    }
    const std::vector<std::string> lines = Table("bits(x)", {"--inputs", Inputs(csv)});
    ASSERT_EQ(lines.size(), patterns.size() + 1);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const std::vector<std::string> fields = Fields(lines[i + 1]);
        ASSERT_EQ(fields.size(), 2u);
        const auto result = static_cast<std::uint32_t>(std::stoul(fields[1]));
        if (IsNan(patterns[i])) {
            EXPECT_EQ(fields[0], "nan");
            EXPECT_TRUE(IsNan(result)) << lines[i + 1];
        } else {
            EXPECT_EQ(Bits(fields[0]), patterns[i]) << lines[i + 1];
            EXPECT_EQ(result, patterns[i]) << lines[i + 1];
        }
    }
}

TEST_F(Probe, WritesResultsToTheSameBits) {
    const std::vector<std::uint32_t> patterns = Patterns(3'000);
    std::string csv = "u:uint\n";
    for (const std::uint32_t pattern : patterns) {
        csv += std::to_string(pattern) + "\n";
    }
    const std::vector<std::string> lines = Table("uintBitsToFloat(u)", {"--inputs", Inputs(csv)});
    ASSERT_EQ(lines.size(), patterns.size() + 1);
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const std::string result = Fields(lines[i + 1]).at(1);
        const std::uint32_t bits = Bits(result);
        // A device may flush what passes through a float.
        EXPECT_TRUE(bits == patterns[i] || (IsNan(patterns[i]) && result == "nan") ||
                    (IsSubnormal(patterns[i]) && bits == (patterns[i] & 0x80000000u)))
            << patterns[i] << " " << result;
    }
}

TEST_F(Probe, BakesEveryPatternToTheSameBits) {
    const std::vector<std::uint32_t> patterns = Patterns(240);
    std::string csv = "x:float,i:int,u:uint,b:bool\n";
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        csv += Written(patterns[i], static_cast<int>(i % 3)) + "," +
               std::to_string(static_cast<std::int32_t>(patterns[i])) + "," +
               std::to_string(patterns[i]) + "," + (i % 2 == 0 ? "true" : "false") + "\n";
    }
    const std::string inputs = Inputs(csv);
    for (const std::string recipe : {"glsl+baked", "spirv+baked"}) {
        const Finished finished =
            RunEtalon({"probe", "f.glsl", "uvec4(bits(x), uint(i), u, uint(b))", "--csv",
                       "--inputs", inputs, "--recipe", recipe, "-d", SoftwareDevice()},
                      options_);
        if (finished.status == 2 && finished.err.starts_with("skipped: ")) {
            continue;  // the device takes no such program
        }
        ASSERT_EQ(finished.status, 0) << finished.err;
        const std::vector<std::string> lines = Lines(finished.out);
        ASSERT_EQ(lines.size(), patterns.size() + 1);
        for (std::size_t i = 0; i < patterns.size(); ++i) {
            const std::vector<std::string> fields = Fields(lines[i + 1]);
            ASSERT_EQ(fields.size(), 10u);
            const auto bits = static_cast<std::uint32_t>(std::stoul(fields[6]));
            EXPECT_TRUE(bits == patterns[i] || (IsNan(patterns[i]) && IsNan(bits)) ||
                        (IsSubnormal(patterns[i]) && bits == (patterns[i] & 0x80000000u)))
                << recipe << " " << lines[i + 1];
            EXPECT_EQ(fields[7], std::to_string(patterns[i]));
            EXPECT_EQ(fields[8], std::to_string(patterns[i]));
            EXPECT_EQ(fields[9], i % 2 == 0 ? "1" : "0");
        }
    }
}

TEST_F(Probe, DefinesMacros) {
    EXPECT_THAT(Table("scaled(x)", {"--at", "x=1.5", "-D", "SCALE=4"}),
                ElementsAre("x,result", "1.5,6"));
    EXPECT_THAT(Table("scaled(x)", {"--at", "x=1.5", "-D", "SCALE"}),
                ElementsAre("x,result", "1.5,1.5"));
    EXPECT_THAT(Table("scaled(x)", {"--at", "x=1.5", "-DSCALE=(1 + 2)"}),
                ElementsAre("x,result", "1.5,4.5"));
}

TEST_F(Probe, IncludesFromBesideAndFromTheRoots) {
    folder_.Write("lib/deep/a.glsl", "#include \"b.glsl\"\nfloat a() { return b() + 1.0; }\n");
    folder_.Write("lib/deep/b.glsl", "float b() { return 10.0; }\n");
    folder_.Write("beside.glsl", "float beside() { return 100.0; }\n");
    folder_.Write("g.glsl",
                  "#include \"beside.glsl\"\n#include \"deep/a.glsl\"\n#include <deep/b.glsl>\n"
                  "float g() { return a() + beside(); }\n");
    folder_.Write("lib/deep/b.glsl", "#ifndef B\n#define B\nfloat b() { return 10.0; }\n#endif\n");
    EXPECT_THAT(Table("g()", {"--include", "lib"}, "g.glsl"), ElementsAre("result", "111"));
}

TEST_F(Probe, TakesSceneFunctionsFromFurtherSources) {
    folder_.Write("g.glsl",
                  "float height(vec2 uv);\nfloat g(float x) { return height(vec2(x, 2.0)); }\n");
    folder_.Write("scene.glsl", "float height(vec2 uv) { return uv.x * uv.y; }\n");
    EXPECT_THAT(Table("g(x)", {"--at", "x=3", "--with", "scene.glsl"}, "g.glsl"),
                ElementsAre("x,result", "3,6"));
}

TEST_F(Probe, NamesDeviceAndRecipeOfEachRow) {
    const std::vector<std::string> lines =
        Lines(Run("scaled(x)", {"--at", "x=1", "-d", "null:echo", "-d", SoftwareDevice(),
                                "--recipe", "spirv", "--recipe", "spirv+O+precise"})
                  .out);
    std::vector<std::string> rows(lines.begin() + 1, lines.end());
    EXPECT_EQ(lines[0], "device,recipe,x,result");
    EXPECT_THAT(
        rows, testing::UnorderedElementsAre("null:echo,spirv,1,1", "null:echo,spirv+O+precise,1,1",
                                            SoftwareDevice() + ",spirv,1,1",
                                            SoftwareDevice() + ",spirv+O+precise,1,1"));
}

TEST_F(Probe, AlignsItsTableForPeople) {
    const Finished finished = RunEtalon({"probe", "f.glsl", "scaled(x)", "--inputs",
                                         Inputs("x:float\n1\n123456\n"), "-d", "null:echo"},
                                        options_);
    EXPECT_EQ(finished.out,
              "device     recipe  x       result\n"
              "null:echo  glsl    1       1\n"
              "null:echo  glsl    123456  123456\n");
}

TEST_F(Probe, CallsFunctionsOfWholeShaders) {
    folder_.Write("whole.frag", R"(#version 330
layout(location = 0) in vec3 normal;
flat in int id;
smooth centroid in vec2 uv, unused;
layout(location = 0) out vec4 color;
float shade(float x) { return x * normal.z + float(id); }
float plain(float x) { color = vec4(x); return color.y; }
void main() { color = vec4(shade(uv.x)); }
)");
    folder_.Write("whole.vert", R"(
attribute vec3 place;
varying vec3 passed;
float moved(float x) { passed = place; return x * passed.y; }
void main() { gl_Position = vec4(place, moved(1.0)); }
)");
    for (const char* recipe : {"glsl", "glsl+fragment", "spirv"}) {
        EXPECT_THAT(
            Table("shade(x)",
                  {"--at", "x=2,normal.x=0,normal.y=0,normal.z=3,id:int=7", "--recipe", recipe},
                  "whole.frag"),
            testing::Contains("2,0,0,3,7,13"));
        EXPECT_THAT(Table("plain(x)", {"--at", "x=2", "--recipe", recipe}, "whole.frag"),
                    testing::Contains("2,2"));
        EXPECT_THAT(
            Table("moved(x)", {"--at", "x=2,place.x=0,place.y=4,place.z=0", "--recipe", recipe},
                  "whole.vert"),
            testing::Contains("2,0,4,0,8"));
    }
    const Finished unset = RunEtalon(
        {"probe", "whole.frag", "shade(x)", "--at", "x=2", "-d", SoftwareDevice()}, options_);
    EXPECT_EQ(unset.status, 2);
    EXPECT_THAT(unset.err, HasSubstr("'normal' has no value; an input of its name gives it one"));
}

TEST_F(Probe, TakesManyRows) {
    constexpr int kRows = 300'000;  // more than one dispatch
    std::string csv = "u:uint\n";
    for (int i = 0; i < kRows; ++i) {
        csv += std::to_string(i) + "\n";
    }
    const std::vector<std::string> lines = Table("u * 3u", {"--inputs", Inputs(csv)});
    ASSERT_EQ(lines.size(), kRows + 1u);
    for (int i = 0; i < kRows; i += 997) {
        EXPECT_EQ(lines[static_cast<std::size_t>(i) + 1],
                  std::to_string(i) + "," + std::to_string(3 * i));
    }
    EXPECT_EQ(lines.back(), "299999,899997");
}

}  // namespace
}  // namespace etalon
