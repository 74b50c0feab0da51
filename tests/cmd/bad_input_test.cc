// Whatever a user may get wrong: exit status 2, one line on stderr that says where, nothing on
// stdout. The devices are null devices, so no driver is touched.
#include <gmock/gmock.h>

#include "support/etalon.h"
#include "support/folder.h"

namespace etalon {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class BadInput : public testing::Test {
  protected:
    BadInput() {
        folder_.Write("f.glsl", "float f(float x) { return x; }\n");
        folder_.Write("in.csv", "x:float\n1\n");
    }

    // The one line of a mistake, without "etalon: ".
    std::string Complaint(const std::vector<std::string>& arguments) {
        ProgramOptions options;
        options.folder = folder_.path();
        const Finished finished = RunEtalon(arguments, options);
        EXPECT_EQ(finished.status, 2) << "signal " << finished.signal;
        EXPECT_EQ(finished.out.substr(0, 300), "");
        const std::vector<std::string> lines = Lines(finished.err);
        EXPECT_EQ(lines.size(), 1u) << finished.err;
        EXPECT_THAT(finished.err, StartsWith("etalon: "));
        return lines.empty() || !lines[0].starts_with("etalon: ") ? finished.err
                                                                  : lines[0].substr(8);
    }
    std::string Probe(const std::string& source, const std::string& call,
                      std::vector<std::string> more = {}) {
        std::vector<std::string> words = {"probe", source, call, "--csv", "-d", "null:echo"};
        words.insert(words.end(), more.begin(), more.end());
        return Complaint(words);
    }
    std::string ProbeOf(const std::string& text, const std::string& call = "f(1.0)") {
        folder_.Write("g.glsl", text);
        return Probe("g.glsl", call);
    }
    std::string WithInputs(const std::string& csv, const std::string& call = "f(x)") {
        folder_.Write("t.csv", csv);
        return Probe("f.glsl", call, {"--inputs", "t.csv"});
    }
    std::string RunOf(const std::string& toml, std::vector<std::string> more = {}) {
        folder_.Write("cases/a/c.toml", toml);
        std::vector<std::string> words = {"run", "-d", "null:echo"};
        words.insert(words.end(), more.begin(), more.end());
        return Complaint(words);
    }

    Folder folder_;
};

TEST_F(BadInput, SourceThatIsNone) {
    EXPECT_EQ(Probe("missing.glsl", "f(1.0)"), "missing.glsl: No such file or directory");
    EXPECT_EQ(Probe(".", "f(1.0)"), ".: is a folder, not a file");
    EXPECT_EQ(ProbeOf(std::string("float f\0", 8)), "g.glsl: is not text (it holds a NUL byte)");
    EXPECT_THAT(ProbeOf("\xff\xfe\x01\x02\x90\n"), StartsWith("g.glsl:1: "));
    EXPECT_THAT(ProbeOf(""), StartsWith("CALL:1: 'f' : "));
}

TEST_F(BadInput, SourceThatIsWrong) {
    EXPECT_EQ(ProbeOf("float f(float x) {\n    return y;\n}\n"),
              "g.glsl:2: 'y' : undeclared identifier");
    EXPECT_THAT(ProbeOf("float f(float x) {\n    return x\n}\n"),
                StartsWith("g.glsl:3: '' :  syntax error"));
    EXPECT_THAT(ProbeOf("\n\n#error gone\nfloat f(float x) { return x; }"),
                StartsWith("g.glsl:3: '#error'"));
    EXPECT_THAT(ProbeOf("#if 1\nfloat f(float x) { return x; }\n"), HasSubstr("missing #endif"));
    EXPECT_THAT(ProbeOf("float f(float x) {\n"), StartsWith("g.glsl:"));
    EXPECT_EQ(ProbeOf("float f(float x) { return x > 1.0 ? f(0.5 * x) : x; }\n"),
              "g.glsl: recursion: function 'f' calls itself");
    EXPECT_THAT(ProbeOf("float g(float x);\nfloat f(float x) { return x > 1.0 ? g(x) : x; }\n"
                        "float g(float x) { return f(0.5 * x); }\n"),
                MatchesRegex("g.glsl: recursion: function '[fg]' calls '[fg]', which leads back to "
                             "it"));
    EXPECT_EQ(ProbeOf("float height(vec2 uv);\nfloat f(float x) { return height(vec2(x)); }\n"),
              "g.glsl: function 'height' is declared but not defined; --with FILE adds a source "
              "that defines it");
    EXPECT_THAT(ProbeOf("uniform float u;\nfloat f(float x) { return u; }\n"),
                HasSubstr("g.glsl: uniform 'u' has no value"));
    EXPECT_THAT(
        ProbeOf("uniform sampler2D s;\nfloat f(float x) { return texture(s, vec2(x)).r; }\n"),
        HasSubstr("g.glsl: sampler 's' has no image; --with s=IMAGE gives one"));
}

TEST_F(BadInput, IncludeThatIsWrong) {
    const std::string rest = "float f(float x) { return x; }\n";
    EXPECT_EQ(ProbeOf("\n#include \"no.glsl\"\n" + rest),
              "g.glsl:2: 'no.glsl' is not found beside the file or under --include");
    EXPECT_EQ(ProbeOf("#include <no.glsl>\n" + rest),
              "g.glsl:1: 'no.glsl' is not found under --include");
    EXPECT_EQ(ProbeOf("#include \"g.glsl\"\n" + rest), "g.glsl:1: 'g.glsl' includes itself");
    folder_.Write("h.glsl", "// first\n#include \"g.glsl\"\n");
    EXPECT_EQ(ProbeOf("#include \"h.glsl\"\n" + rest), "h.glsl:2: 'g.glsl' includes itself");
    EXPECT_EQ(ProbeOf("#include \"../../etc/hostname\"\n" + rest),
              "g.glsl:1: '../../etc/hostname' is outside the folders that may be read; "
              "--include DIR adds one");
    EXPECT_THAT(ProbeOf("#include \"/etc/passwd\"\n" + rest), HasSubstr("is outside the folders"));
    std::filesystem::create_symlink("/etc/passwd", folder_.path() / "link.glsl");
    EXPECT_THAT(ProbeOf("#include \"link.glsl\"\n" + rest), HasSubstr("is outside the folders"));
    folder_.Write("bad.glsl", "\n\nfloat k = z;\n");
    EXPECT_EQ(ProbeOf("#include \"bad.glsl\"\n" + rest), "bad.glsl:3: 'z' : undeclared identifier");
}

TEST_F(BadInput, CallThatIsWrong) {
    EXPECT_EQ(Probe("f.glsl", "g(1.0)"), "CALL:1: 'g' : no matching overloaded function found");
    EXPECT_EQ(Probe("f.glsl", "f(1.0, 2.0)"),
              "CALL:1: 'f' : no matching overloaded function found");
    EXPECT_EQ(Probe("f.glsl", "f(vec2(1.0))"),
              "CALL:1: 'f' : no matching overloaded function found");
    EXPECT_EQ(Probe("f.glsl", "f(x)"), "CALL:1: 'x' : undeclared identifier");
    EXPECT_THAT(Probe("f.glsl", "f(1.0); f(2.0)"), StartsWith("CALL"));
    EXPECT_THAT(Probe("f.glsl", "f(1.0)\n"), StartsWith("CALL: "));
}

TEST_F(BadInput, CallThatIsIncompleteIsTheUsersAndNamedSo) {
    EXPECT_THAT(Probe("f.glsl", "f(1.0"), StartsWith("CALL"));
    EXPECT_THAT(Probe("f.glsl", "f(1.0))"), StartsWith("CALL"));
    EXPECT_THAT(Probe("f.glsl", "1.0 +"), StartsWith("CALL"));
}

TEST_F(BadInput, CallThatIsEmpty) {
    EXPECT_THAT(Probe("f.glsl", ""), StartsWith("CALL"));
    EXPECT_THAT(Probe("f.glsl", " "), StartsWith("CALL"));
    EXPECT_THAT(Probe("f.glsl", "// nothing"), StartsWith("CALL"));
}

TEST_F(BadInput, CallWithoutAResult) {
    folder_.Write("f.glsl", "void f(float x) { }\n");
    EXPECT_THAT(Probe("f.glsl", "f(1.0)"), StartsWith("CALL: the call has no result"));
}

TEST_F(BadInput, InputsThatAreWrong) {
    EXPECT_EQ(Probe("f.glsl", "f(x)", {"--inputs", "no.csv"}), "no.csv: No such file or directory");
    EXPECT_EQ(Probe("f.glsl", "f(x)", {"--inputs", "."}), ".: is a folder, not a file");
    EXPECT_EQ(WithInputs(""), "t.csv:1: no header; it reads name:type, as in n1:float,n2:float");
    EXPECT_EQ(WithInputs("1\n2\n"), "t.csv:1: '1' is not a GLSL name");
    EXPECT_EQ(WithInputs("x\n1\n"),
              "t.csv:1: column 'x' has no type; a header reads name:type, as in n1:float");
    EXPECT_EQ(WithInputs("x:float\n"), "t.csv:1: no rows");
    EXPECT_EQ(WithInputs("x:float,y:float\n1,2\n3\n"),
              "t.csv:3: 1 values, the header has 2 columns");
    EXPECT_EQ(WithInputs("x:float\n1\nword\n"), "t.csv:3: column 'x': 'word' is not a float");
    EXPECT_THAT(WithInputs("v.x:float,v.z:float\n1,2\n"),
                StartsWith("t.csv:1: the columns of 'v'"));
    EXPECT_THAT(WithInputs("float:float\n1\n", "f(1.0)"), StartsWith("input 'float':1: "));
    EXPECT_THAT(WithInputs("gl_x:float\n1\n", "f(1.0)"), StartsWith("input 'gl_x'"));
}

TEST_F(BadInput, OptionsOfAProbeThatAreWrong) {
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--include", "no"}), "--include 'no': is not a folder");
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--with", "no.glsl"}),
              "no.glsl: No such file or directory");
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--with", "s=no.png"}),
              "no.png: No such file or directory");
    EXPECT_THAT(Probe("f.glsl", "f(1.0)", {"--with", "s=f.glsl"}),
                StartsWith("f.glsl: is not an image"));
    EXPECT_THAT(Probe("f.glsl", "f(1.0)", {"--image", "s={ expr = 'u + w', size = [4, 4] }"}),
                StartsWith("--image:1:"));
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--image", "s={ expr = 'u', size = [4, 4] }"}),
              "image 's': the call reaches no sampler 's'");
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--image", "s={ file = 'no.png' }"}),
              "--image:1: image 's': no.png: No such file or directory");
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"--out", "x"}),
              "--out 'x': it reads NAME:TYPE, as in hit:vec3");
    EXPECT_THAT(Probe("f.glsl", "f(1.0)", {"--out", "x:nothing"}), StartsWith("out parameter 'x'"));
    EXPECT_EQ(Probe("f.glsl", "f(1.0)", {"-D", "=1"}), "-D '=1': it reads NAME or NAME=VALUE");
    EXPECT_THAT(Probe("f.glsl", "f(1.0)", {"--recipe", "glsl+fast"}),
                StartsWith("unknown recipe 'glsl+fast': "));
    EXPECT_EQ(Probe("f.glsl", "f(x)", {"--at", "x=one"}), "--at: x: 'one' is not a float");
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(1.0)", "-d", "null:nothing"}),
                StartsWith("no device is called 'null:nothing'"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(1.0)", "--driver", "x=no", "-d", "null:echo"}),
                HasSubstr("'no' is not a folder"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(1.0)", "--driver", "x", "-d", "null:echo"}),
                StartsWith("--driver 'x': it reads NAME=DIR"));
}

TEST_F(BadInput, NoDeviceThatCanRunIt) {
    ProgramOptions options;
    options.folder = folder_.path();
    const Finished finished =
        RunEtalon({"probe", "f.glsl", "f(1.0)", "--csv", "-d", "null:unsupported"}, options);
    EXPECT_EQ(finished.status, 2);
    EXPECT_EQ(finished.out, "");
    EXPECT_EQ(finished.err,
              "skipped: null:unsupported (glsl): the null device supports no program\n"
              "etalon: no device can run this probe\n");
}

TEST_F(BadInput, CommandLineThatIsWrong) {
    const std::string more = "; --help tells more";
    EXPECT_EQ(Complaint({}), "A subcommand is required" + more);
    EXPECT_THAT(Complaint({"dance"}), MatchesRegex(".*" + more));
    EXPECT_EQ(Complaint({"probe"}), "SOURCE is required" + more);
    EXPECT_EQ(Complaint({"probe", "f.glsl"}), "CALL is required" + more);
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(1.0)", "--bogus"}), HasSubstr("--bogus"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(x)", "--timeout", "0"}), HasSubstr("--timeout"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(x)", "--timeout", "soon"}),
                HasSubstr("--timeout"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(x)", "--memory", "-1"}), HasSubstr("--memory"));
    EXPECT_THAT(Complaint({"probe", "f.glsl", "f(x)", "--inputs", "in.csv", "--at", "x=1"}),
                HasSubstr("excludes"));
    EXPECT_THAT(Complaint({"run", "--json"}), HasSubstr("--json"));
}

constexpr const char* kCase = R"toml(source = "f.glsl"
call = "f(x)"
oracle = "x"
accept = { ulp = 1 }
[domain]
x = { values = [1] }
)toml";

TEST_F(BadInput, CasesThatAreNotThere) {
    EXPECT_EQ(Complaint({"run", "-d", "null:echo", "--root", "."}),
              "--root '.': holds no folder 'cases'");
    EXPECT_EQ(Complaint({"run", "-d", "null:echo"}),
              "no folder 'cases' here or above; --root DIR names the folder that holds it");
    EXPECT_EQ(Complaint({"list"}),
              "no folder 'cases' here or above; --root DIR names the folder that holds it");
    std::filesystem::create_directories(folder_.path() / "cases");
    EXPECT_THAT(Complaint({"run", "-d", "null:echo"}), HasSubstr("cases: holds no case"));
    folder_.Write("cases/a/c.toml", kCase);
    EXPECT_EQ(Complaint({"run", "b", "-d", "null:echo"}),
              "no case is called 'b'; `etalon list` shows them");
    EXPECT_EQ(Complaint({"list", "a/d"}), "no case is called 'a/d'; `etalon list` shows them");
}

TEST_F(BadInput, CaseThatIsWrong) {
    EXPECT_THAT(RunOf(std::string(kCase) + "y = 1\n"),
                StartsWith("cases/a/c.toml:7: input 'y' must be a table"));
    EXPECT_THAT(RunOf("sauce = \"f.glsl\"\n" + std::string(kCase)),
                StartsWith("cases/a/c.toml:1: unknown key 'sauce'"));
    EXPECT_THAT(RunOf("source = f.glsl\n"), StartsWith("cases/a/c.toml:1:"));
    EXPECT_THAT(RunOf(std::string("a\0", 2)), StartsWith("cases/a/c.toml: is not text"));
    EXPECT_THAT(RunOf("source = \"no.glsl\"\n" + std::string(kCase).substr(18)),
                HasSubstr("cases/a/c.toml:1: 'source': there is no file no.glsl"));
    EXPECT_THAT(RunOf(std::string(kCase) + "[images]\ns = { file = \"no.png\" }\n"),
                StartsWith("cases/a/c.toml:8: image 's': "));
    std::string blind = kCase;
    blind.replace(blind.find("ulp = 1"), 7, "absolute = 10");
    EXPECT_THAT(RunOf(blind), StartsWith("cases/a/c.toml:4: nothing could fail"));
    std::string later = kCase;
    later.replace(later.find("ulp = 1"), 7, "spec = \"vulkan-9\"");
    EXPECT_EQ(RunOf(later),
              "cases/a/c.toml:4: 'spec': there is no 'vulkan-9'; there are glsl-4.60, vulkan-1.3, "
              "and 'device' for the device's own");
    EXPECT_THAT(RunOf(std::string("recipes = [\"fast\"]\n") + kCase),
                StartsWith("cases/a/c.toml: unknown recipe 'fast'"));
}

TEST_F(BadInput, CaseThatIsLikeNothing) {
    EXPECT_EQ(RunOf(std::string("like = \"no.toml\"\n") + kCase),
              "cases/a/c.toml:1: 'like': there is no file cases/a/no.toml");
    EXPECT_EQ(RunOf(std::string("like = \"c.toml\"\n") + kCase),
              "cases/a/c.toml:1: 'like' leads in a circle: cases/a/c.toml is like cases/a/c.toml");
    folder_.Write("cases/a/shared.part.toml", "\noracle = \"x +\"\n");
    std::string like = kCase;
    like.replace(like.find("oracle"), std::string("oracle = \"x\"\n").size(),
                 "like = \"shared.part.toml\"\n");
    EXPECT_THAT(RunOf(like), StartsWith("cases/a/shared.part.toml:2:14: "));
}

TEST_F(BadInput, OptionsOfARunThatAreWrong) {
    EXPECT_EQ(RunOf(kCase, {"--at", "x=one"}), "--at: x: 'one' is not a float");
    EXPECT_EQ(RunOf(kCase, {"--at", "y=1"}), "--at: the case has no input 'y'");
    folder_.Write("cases/a/d.toml", kCase);
    EXPECT_EQ(RunOf(kCase, {"--at", "x=1"}), "--at needs exactly one case, the pattern names 2");
    EXPECT_THAT(RunOf(kCase, {"--recipe", "fast"}), StartsWith("unknown recipe 'fast'"));
    EXPECT_THAT(RunOf(kCase, {"--gtest_filter=nothing"}), StartsWith("no test was selected"));
}

TEST_F(BadInput, ExplanationsOfWhatIsNotThere) {
    folder_.Write("cases/a/c.toml", kCase);
    folder_.Write("cases/a/d.toml", kCase);
    const auto explain = [&](std::vector<std::string> more) {
        std::vector<std::string> words = {"explain", "-d", "cpu"};
        words.insert(words.end(), more.begin(), more.end());
        return Complaint(words);
    };
    EXPECT_THAT(explain({}), HasSubstr("CASE is required"));
    EXPECT_THAT(explain({"b", "--at", "x=1"}), StartsWith("no case is called 'b'"));
    EXPECT_THAT(explain({"a", "--at", "x=1"}), StartsWith("'a' names 2 cases, and one"));
    EXPECT_EQ(explain({"a/c", "--at", "y=1"}), "--at: the case has no input 'y'");
    EXPECT_EQ(explain({"a/c", "--at", "x=1", "--output", "y"}),
              "--output: the case judges no 'y'; it judges 'result'");
    EXPECT_THAT(explain({"a/c", "--at", "x=1", "--recipe", "fast"}),
                StartsWith("unknown recipe 'fast'"));
}

TEST_F(BadInput, FlagThatGoogleTestDoesNotKnow) {
    EXPECT_THAT(RunOf(kCase, {"--gtest_filtr=x"}), HasSubstr("--gtest_filtr"));
}

}  // namespace
}  // namespace etalon
