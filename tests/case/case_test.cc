#include "case/case.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/file.h"
#include "case/read_judgement.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class CaseTest : public testing::Test {
  protected:
    void SetUp() override {
        root_ = std::filesystem::path(testing::TempDir()) /
                ("case_test_" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
        std::filesystem::create_directories(root_ / "cases/deep");
    }
    void TearDown() override { std::filesystem::remove_all(root_); }

    Result<Case> Read(const std::string& text) {
        EXPECT_TRUE(WriteFile(root_ / "cases/x.toml", text));
        return ReadCase(root_, "x");
    }
    // The complaint about the case, which begins with its file; the folder is left out.
    std::string Complaint(const std::string& text) {
        const auto read = Read(text);
        return read ? "" : BelowRoot(read.error().message);
    }
    std::string BelowRoot(const std::string& message) const {
        const std::string root = root_.string() + "/";
        EXPECT_EQ(message.substr(0, root.size()), root);
        return message.substr(std::min(root.size(), message.size()));
    }

    std::filesystem::path root_;
};

// Five lines; what is wrong in a test stands from line 6 on.
const std::string kHead = R"toml(source = "shaders/f.glsl"
call = "f(x, v)"
oracle = "x * v.x"
accept = { ulp = 2 }

)toml";
const std::string kDomain = R"toml([domain]
x = { values = [1.0, 2] }
v = { sample = "sphere", count = 3 }
)toml";

TEST_F(CaseTest, ReadsEverything) {
    const auto read = Read(R"toml(
description = "all keys"
source = "shaders/optics/fresnel.glsl"
call = "f(b, a, t)"
oracle = { result = "a * 2", t = "vec2(a, b)" }
accept = { result = { ulp = 16, absolute = 1e-9 }, t = { exact = true, flush = false } }
family = "fresnel"
seed = 7
combine = "zip"
where = "a < 3"
recipes = ["spirv", "glsl"]
with = ["cases/scene.glsl"]
include = ["shaders"]
define = { STEPS = "8" }
out = { t = "vec2" }
[domain]
b = { values = [1.0, "nan", "0x1.8p-3", -inf] }
a = { values = [1, 2, 3, 4] }
where = "a > 1"
[[law]]
name = "first"
holds = "f(b, a, t) + g(a == b ? 1 : 0) <= 1"
within = { relative = 0.5 }
[[law]]
name = "second"
holds = "f(a) == g[1]"
[[expected_failure]]
device = "osmesa:softpipe*"
recipe = "glsl"
law = "fir*"
status = "bug"
cause = "a reason"
link = "https://example.org"
)toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->path, "x");
    EXPECT_EQ(read->root, root_);
    EXPECT_EQ(read->description, "all keys");
    EXPECT_EQ(read->family, "fresnel");
    EXPECT_EQ(read->seed, 7u);
    EXPECT_THAT(read->recipes, ElementsAre("spirv", "glsl"));
    EXPECT_THAT(read->with, ElementsAre("cases/scene.glsl"));
    EXPECT_THAT(read->include, ElementsAre("shaders"));
    EXPECT_EQ(read->define.at("STEPS"), "8");
    EXPECT_EQ(read->out.at("t"), "vec2");
    ASSERT_EQ(read->expectations.size(), 2u);
    EXPECT_EQ(read->expectations[0].output, "result");
    EXPECT_EQ(read->expectations[0].accept.Text(), "ulp 16 or absolute 1e-09");
    EXPECT_EQ(read->expectations[1].accept.Text(), "exact, no flush");
    EXPECT_EQ(read->expectations[1].place.line, 6);
    ASSERT_EQ(read->laws.size(), 2u);
    EXPECT_EQ(read->laws[0].left, "f(b, a, t) + g(a == b ? 1 : 0)");
    EXPECT_EQ(read->laws[0].relation, Relation::kLessEqual);
    EXPECT_EQ(read->laws[0].right, "1");
    EXPECT_EQ(read->laws[0].within.Text(), "relative 0.5");
    EXPECT_EQ(read->laws[1].within.Text(), "exact");
    ASSERT_EQ(read->expected_failures.size(), 1u);
    EXPECT_EQ(read->expected_failures[0].law, "fir*");
    EXPECT_EQ(read->expected_failures[0].status, "bug");

    ASSERT_EQ(read->domains.size(), 1u);
    EXPECT_TRUE(read->domains[0].zip);
    EXPECT_EQ(read->domains[0].inputs[0].name, "b") << "in the order of the file";
    EXPECT_EQ(read->domains[0].inputs[0].line, 17);
    const auto table = Expand(read->domains, read->seed);
    ASSERT_TRUE(table) << table.error().message;
    ASSERT_EQ(table->rows, 1u) << "only a = 2 passes both conditions";
    EXPECT_TRUE(std::isnan(FromBits(table->At(0, 0))));
}

TEST_F(CaseTest, KnowsTheInputsDefaults) {
    const auto read = Read(kHead + R"toml([[domain]]
x = { range = [0, 1], count = 4, edges = ["length(v)", 0.5] }
v = { sample = "hemisphere", against = "w", count = 2 }
w = { type = "vec3", values = [[1, 0, 0], [0, 1, 0]] }
[[domain]]
x = { expr = "v.x" }
v = { type = "vec3", range = [-1, 1], count = 5, sample = "linear" }
w = { sample = "sphere", count = 1 }
)toml");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->seed, 1u);
    EXPECT_EQ(read->domains[0].inputs[1].type, "vec3");
    EXPECT_EQ(read->domains[0].inputs[0].edges.size(), 2u);
    EXPECT_FALSE(read->domains[0].zip);
    EXPECT_TRUE(Expand(read->domains, 1));
}

TEST_F(CaseTest, SaysWhereWhatIsWrong) {
    EXPECT_EQ(Complaint("sorce = \"a\"\n"),
              "cases/x.toml:1: unknown key 'sorce'; did you mean 'source'?");
    EXPECT_EQ(Complaint("\n\nxyzzy = 1\n"), "cases/x.toml:3: unknown key 'xyzzy'");
    EXPECT_THAT(Complaint("source = \n"), StartsWith("cases/x.toml:1:10: "));
    EXPECT_THAT(Complaint("a = 1\na = 2\n"), StartsWith("cases/x.toml:2:"));
    EXPECT_EQ(Complaint("a = \"\n\"").find('\n'), std::string::npos);
    EXPECT_EQ(Complaint("call = \"f()\"\n"), "cases/x.toml:1: 'source' is missing");
    EXPECT_EQ(Complaint("source = \"s\"\n"), "cases/x.toml:1: 'call' is missing");
    EXPECT_EQ(Complaint("source = \"s\"\ncall = \" \"\n"), "cases/x.toml:2: 'call' is empty");
    EXPECT_EQ(Complaint("source = \"s\"\ncall = 3\n"),
              "cases/x.toml:2: 'call' must be a text in quotes");
    EXPECT_EQ(Complaint(kHead), "cases/x.toml:1: [domain] is missing");
    EXPECT_EQ(
        Complaint("source = \"s\"\ncall = \"f(x)\"\n" + kDomain),
        "cases/x.toml:1: nothing is judged: give an oracle, a law, or accept = { spec = ... }");
    EXPECT_EQ(Complaint(kHead + "seed = -1\n" + kDomain),
              "cases/x.toml:6: 'seed' must be an integer, 0 or more");
    EXPECT_EQ(Complaint(kHead + "recipes = [1]\n" + kDomain),
              "cases/x.toml:6: an entry of 'recipes' must be a text in quotes");
    EXPECT_EQ(Complaint(kHead + "define = { A = 1 }\n" + kDomain),
              "cases/x.toml:6: 'define' of 'A' must be a text in quotes");
    EXPECT_EQ(Complaint(kHead + "combine = \"zap\"\n" + kDomain),
              "cases/x.toml:6: 'combine' must be product or zip");
    EXPECT_EQ(Complaint(kHead + "out = { t = \"sampler2D\" }\n" + kDomain),
              "cases/x.toml:6: 'out': 'sampler2D' is not a scalar, vector or matrix type");
    EXPECT_EQ(Complaint(kHead + kDomain), "");
    const auto missing = ReadCase(root_, "absent");
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().message, HasSubstr("absent.toml: No such file"));
}

TEST_F(CaseTest, RefusesWrongInputs) {
    const auto input = [this](const std::string& text) {
        return Complaint(kHead + "[domain]\nv = { sample = \"sphere\", count = 1 }\nx = " + text +
                         "\n");
    };
    const std::string at = "cases/x.toml:8: input 'x'";
    EXPECT_EQ(input("{ values = [1] }"), "");
    EXPECT_EQ(input("{ values = [] }"), at + ": 'values' is empty: the domain has no rows");
    EXPECT_EQ(input("{ range = [0, 1], count = 0 }"),
              at + ": 'count' is 0: the domain has no rows");
    EXPECT_EQ(input("{ range = [0, 1] }"), at + ": 'count' is missing");
    EXPECT_EQ(input("{ range = [0, 1], edges = [0.5] }"), "");
    EXPECT_EQ(input("{ range = [1, 0], count = 1 }"), at + ": the range [1, 0] is empty");
    EXPECT_EQ(input("{ range = [1], count = 1 }"), at + ": 'range' must be [low, high]");
    EXPECT_EQ(input("{ range = 1, count = 1 }"), at + ": 'range' must be a list");
    EXPECT_EQ(input("{ values = [\"abc\"] }"), at + ": 'values': 'abc' is not a float");
    EXPECT_EQ(input("{ values = [[1]] }"), "");
    EXPECT_EQ(input("{ values = [[1, 2]] }"),
              at + ": a value of type float has 1 components, not 2");
    EXPECT_EQ(input("{ type = \"vec2\", values = [1] }"),
              at + ": 'values' must be lists of 2 numbers");
    EXPECT_EQ(input("{ type = \"int\", values = [1.5] }"), at + ": 1.5 is not an int");
    EXPECT_EQ(input("{ type = \"double\", values = [1] }"),
              at + ": 'double' is not a scalar, vector or matrix type");
    EXPECT_EQ(input("{ }"), at + ": needs exactly one of values, range, sample = \"sphere\", "
                                 "\"hemisphere\" or \"any\", and expr");
    EXPECT_THAT(input("{ values = [1], expr = \"1\" }"), HasSubstr("exactly one of"));
    EXPECT_THAT(input("{ values = [1], count = 3 }"),
                HasSubstr("'count', 'full' and 'sample' belong to"));
    EXPECT_EQ(input("{ range = [0, 1], count = 2, full = 1 }"),
              at + ": 'full' must be from 'count' to 2^24");
    EXPECT_THAT(input("{ values = [1], full = 3 }"), HasSubstr("'count', 'full' and 'sample'"));
    EXPECT_THAT(input("{ expr = \"1\", edges = [1] }"), HasSubstr("'edges' belong to"));
    EXPECT_EQ(input("{ range = [0, 1], count = 1, sample = \"cubic\" }"),
              at + ": 'sample' must be bits, linear, log, sphere, hemisphere or any");
    EXPECT_THAT(input("{ range = [0, 1], count = 1, sample = \"log\" }"),
                HasSubstr("must not hold zero"));
    EXPECT_EQ(input("{ sample = \"any\", type = \"mat2\", count = 1, full = 2 }"), "");
    EXPECT_EQ(input("{ sample = \"any\" }"), at + ": 'count' is missing");
    EXPECT_THAT(input("{ sample = \"any\", count = 1, range = [0, 1] }"),
                HasSubstr("exactly one of"));
    EXPECT_THAT(input("{ sample = \"any\", count = 1, edges = [1] }"),
                HasSubstr("'edges' belong to"));
    EXPECT_EQ(input("{ valeus = [1] }"),
              "cases/x.toml:8: unknown key 'valeus'; did you mean 'values'?");
    EXPECT_EQ(input("3"), "cases/x.toml:8: input 'x' must be a table, such as { values = [1] }");
    EXPECT_EQ(input("{ expr = \"v.x + zz\" }"), "cases/x.toml:8:21: 'zz' is no input");
    EXPECT_EQ(input("{ expr = \"v\" }"), "cases/x.toml:8: 'v' has 3 components, not 1");
    EXPECT_EQ(input("{ range = [0, 1], edges = [\"1 +\"] }"),
              "cases/x.toml:8:36: a value is missing at the end");
    EXPECT_EQ(input("{ type = \"int\", range = [0, 1], count = 2, edges = [1] }"),
              at + ": 'edges' need type float");
    EXPECT_EQ(
        input("{ values = [1] }\nn = { sample = \"hemisphere\", against = \"x\", count = 1 }"),
        "cases/x.toml:9: there is no input 'x' of type vec3");
    EXPECT_THAT(input("{ values = [1] }\nn = { sample = \"hemisphere\", count = 1 }"),
                HasSubstr("'against' belongs to"));
    EXPECT_THAT(input("{ values = [1] }\npi = { values = [1] }"), HasSubstr("a constant of"));
    EXPECT_THAT(input("{ values = [1] }\n\"a b\" = { values = [1] }"),
                HasSubstr("not a GLSL name"));
    EXPECT_EQ(input("{ values = [1] }\nwhere = \"x <\""),
              "cases/x.toml:9:13: a value is missing at the end");
    EXPECT_EQ(input("{ values = [1] }\nwhere = \"v\""),
              "cases/x.toml:9: 'v' has 3 components, not 1");
    EXPECT_EQ(Complaint(kHead + "[domain]\n"), "cases/x.toml:6: the domain has no inputs");
}

TEST_F(CaseTest, RefusesWrongExpectations) {
    const auto judged = [this](const std::string& text) {
        return Complaint("source = \"s\"\ncall = \"f(x, v)\"\n" + text + "\n" + kDomain);
    };
    EXPECT_EQ(judged("oracle = \"x\""), "cases/x.toml:3: 'accept' is missing: an oracle needs it");
    EXPECT_EQ(judged("accept = { ulp = 1 }"), "cases/x.toml:3: 'accept' needs an 'oracle'");
    EXPECT_EQ(judged("oracle = \"x + (2\"\naccept = { ulp = 1 }"),
              "cases/x.toml:3:17: ')' is missing");
    EXPECT_EQ(judged("oracle = \"x + y\"\naccept = { ulp = 1 }"),
              "cases/x.toml:3:15: 'y' is no input");
    EXPECT_THAT(judged("oracle = \"fresnel.no_such_thing(x)\"\naccept = { ulp = 1 }"),
                StartsWith("cases/x.toml:3:11: there is no oracle 'fresnel.no_such_thing'"));
    EXPECT_EQ(judged("oracle = { t = \"x\" }\naccept = { ulp = 1 }"),
              "cases/x.toml:3: 'oracle': there is no output 't'; 'out' names the out parameters");
    EXPECT_EQ(judged("out = { t = \"vec2\" }\noracle = { t = \"x\" }\naccept = { ulp = 1 }"),
              "cases/x.toml:4: 'oracle' for 't' has 1 components, not 2");
    EXPECT_EQ(judged("oracle = \"x\"\naccept = { t = { ulp = 1 } }"),
              "cases/x.toml:4: 'accept' for 'result' is missing");
    EXPECT_EQ(judged("oracle = \"x\"\naccept = { result = { ulp = 1 }, t = { ulp = 1 } }"),
              "cases/x.toml:4: 'accept' for 't' needs an 'oracle' for it");
    EXPECT_EQ(judged("oracle = { }\naccept = { ulp = 1 }"), "cases/x.toml:3: 'oracle' is empty");

    const auto accept = [&](const std::string& text) {
        return judged("oracle = \"x\"\naccept = { " + text + " }");
    };
    EXPECT_EQ(accept("exact = true"), "");
    EXPECT_EQ(accept("ulp = 0.5, flush = false"), "");
    for (const char* tolerance : {"ulp = -1", "ulp = 0", "ulp = nan", "ulp = inf"}) {
        EXPECT_EQ(accept(tolerance),
                  "cases/x.toml:4: 'ulp' must be a positive number (exact = true grants none)");
    }
    EXPECT_THAT(accept("absolute = -1e-9"), HasSubstr("'absolute' must be a positive number"));
    EXPECT_EQ(accept("ulp = 8388608"),
              "cases/x.toml:4: nothing could fail: 2^23 ulp reach to zero");
    EXPECT_EQ(accept("relative = 1"),
              "cases/x.toml:4: nothing could fail: relative 1 reaches to zero");
    EXPECT_EQ(accept("ulp = \"2\""), "cases/x.toml:4: 'ulp' must be a number");
    EXPECT_EQ(accept("flush = 1, ulp = 1"), "cases/x.toml:4: 'flush' must be true or false");
    EXPECT_EQ(accept("exact = true, ulp = 1"),
              "cases/x.toml:4: 'exact' and a tolerance contradict each other");
    EXPECT_THAT(accept(""), HasSubstr("the acceptance grants nothing"));
    EXPECT_THAT(accept("flush = false"), HasSubstr("the acceptance grants nothing"));
    EXPECT_EQ(accept("upl = 1"), "cases/x.toml:4: unknown key 'upl'; did you mean 'ulp'?");
    EXPECT_EQ(accept("spec = \"vulkan-1.3\""), "");
    EXPECT_EQ(accept("spec = 1.3"), "cases/x.toml:4: 'spec' must be a text in quotes");
    EXPECT_EQ(accept("spec = \"vulkan-1.3\", ulp = 2"),
              "cases/x.toml:4: 'spec' and 'ulp' contradict each other: what the specification "
              "allows is accepted, no more and no less");
    EXPECT_EQ(accept("absolute = 0.1, spec = \"vulkan-1.3\""),
              "cases/x.toml:4: 'spec' and 'absolute' contradict each other: what the specification "
              "allows is accepted, no more and no less");
    EXPECT_EQ(accept("spec = \"vulkan-1.3\", abslute = 2"),
              "cases/x.toml:4: unknown key 'abslute'; did you mean 'absolute'?");
    EXPECT_EQ(judged("accept = { spec = \"vulkan-1.3\" }"), "");
    EXPECT_EQ(judged("out = { t = \"float\" }\naccept = { t = { spec = \"vulkan-1.3\" } }"), "");
    EXPECT_EQ(judged("accept = { t = { spec = \"vulkan-1.3\" } }"),
              "cases/x.toml:3: 'accept': there is no output 't'; 'out' names the out parameters");
    EXPECT_EQ(judged("oracle = \"x\"\naccept = { result = { ulp = 1 }, result2 = { ulp = 1 } }"),
              "cases/x.toml:4: 'accept' for 'result2' needs an 'oracle' for it");
    EXPECT_EQ(accept("absolute = 0.1, missed = 0.001, wrong = 0.01, beyond = 2"), "");
    EXPECT_EQ(accept("ulp = 4, beyond = 2"), "");
    EXPECT_EQ(accept("exact = true, wrong = 0.01"), "");
    EXPECT_EQ(accept("absolute = 0.1, missed = 0.001"),
              "cases/x.toml:4: 'missed' and 'wrong' need 'beyond': how far from the truth a hit is "
              "another one");
    EXPECT_EQ(accept("exact = true, wrong = 0.1, missed = 0"),
              "cases/x.toml:4: 'missed' and 'beyond' need a tolerance (ulp, absolute or relative)");
    EXPECT_EQ(accept("exact = true, beyond = 1"),
              "cases/x.toml:4: 'missed' and 'beyond' need a tolerance (ulp, absolute or relative)");
    EXPECT_EQ(accept("absolute = 0.1, wrong = 0.5, beyond = 1"),
              "cases/x.toml:4: 'wrong' must be less than 0.5: a rule that half of the values may "
              "break is none");
    EXPECT_EQ(accept("absolute = 0.1, missed = -0.1, beyond = 1"),
              "cases/x.toml:4: 'missed' must be a share, from 0 to less than 0.5");
    EXPECT_EQ(accept("absolute = 0.1, missed = nan, beyond = 1"),
              "cases/x.toml:4: 'missed' must be a share, from 0 to less than 0.5");
    EXPECT_EQ(accept("absolute = 0.1, beyond = 0"),
              "cases/x.toml:4: 'beyond' must be a positive number");
    EXPECT_EQ(accept("absolute = 2, beyond = 2"),
              "cases/x.toml:4: 'beyond' must be greater than 'absolute': no right hit could be "
              "refused");
}

TEST_F(CaseTest, RefusesWrongLawsAndFailures) {
    const auto law = [this](const std::string& text) {
        return Complaint(kHead + kDomain + "[[law]]\n" + text + "\n");
    };
    const auto holds = [&](const std::string& text) {
        return law("name = \"l\"\nholds = \"" + text + "\"");
    };
    const std::string at = "cases/x.toml:11: 'holds': ";
    EXPECT_EQ(holds("f(x) <= g(x < 1)"), "");
    EXPECT_EQ(holds("f(x)"), at + "a comparison (==, <=, >=, < or >) is missing");
    EXPECT_EQ(holds("(f(x) == 1)"), at + "a comparison (==, <=, >=, < or >) is missing");
    EXPECT_EQ(holds("1 < f(x) < 2"), at + "more than one comparison stands outside brackets");
    EXPECT_EQ(holds("f(x) == "), at + "a side of the comparison is missing");
    EXPECT_EQ(holds("f(x == 1"), at + "a bracket is not closed");
    EXPECT_EQ(holds("f(x)) == 1"), at + "a bracket is closed that was not opened");
    EXPECT_EQ(holds("f(x) != 1"), at + "'!=' must stand in brackets; a law is one comparison");
    EXPECT_EQ(holds("f(x) == 1 && x > 0"),
              at + "'&&' must stand in brackets; a law is one comparison");
    EXPECT_EQ(law("name = \"l\""), "cases/x.toml:9: 'holds' is missing");
    EXPECT_EQ(law("holds = \"f(x) == 1\""), "cases/x.toml:9: 'name' is missing");
    EXPECT_EQ(law("name = \"l\"\nholds = \"f(x) == 1\"\nwithin = { ulp = 8388608 }"),
              "cases/x.toml:12: nothing could fail: 2^23 ulp reach to zero");
    EXPECT_EQ(law("name = \"l\"\nholds = \"f(x) == 1\"\nwithin = { spec = \"vulkan-1.3\" }"),
              "cases/x.toml:12: unknown key 'spec'");
    EXPECT_EQ(law("name = \"l\"\nholds = \"f(x) == 1\"\nwithin = { exact = true, wrong = 0.1 }"),
              "cases/x.toml:12: 'within' grants no shares: a law holds at every row");
    EXPECT_EQ(law("name = \"l\"\nholds = \"f(x) == 1\"\n[[law]]\nname = \"l\"\nholds = \"1 < 2\""),
              "cases/x.toml:12: two laws are called 'l'");

    const auto failure = [this](const std::string& text) {
        return Complaint(kHead + kDomain + "[[expected_failure]]\n" + text + "\n");
    };
    const std::string device = "device = \"*\"\n";
    EXPECT_EQ(failure(device + "status = \"bug\"\ncause = \"why\""), "");
    EXPECT_EQ(failure(device + "status = \"bug\""), "cases/x.toml:9: 'cause' is missing");
    EXPECT_EQ(failure(device + "status = \"bug\"\ncause = \"\""),
              "cases/x.toml:12: 'cause' is empty");
    EXPECT_EQ(failure(device + "cause = \"why\""), "cases/x.toml:9: 'status' is missing");
    EXPECT_EQ(
        failure(device + "status = \"bad\"\ncause = \"why\""),
        "cases/x.toml:11: 'status' must be bug, method, rounding, unimplemented or undefined");
    EXPECT_EQ(failure("status = \"bug\"\ncause = \"why\""), "");
    EXPECT_EQ(failure(device + "law = \"l\"\nstatus = \"bug\"\ncause = \"why\""),
              "cases/x.toml:11: no law is called 'l'");
    const std::string known = device + "status = \"undefined\"\ncause = \"why\"\n";
    const auto figure = [&](const std::string& text) {
        return failure(known + "figure = { " + text + " }");
    };
    EXPECT_EQ(figure("absolute = 2.5"), "");
    EXPECT_EQ(figure("value = -inf, within = 0"), "");
    EXPECT_EQ(figure("value = \"nan\""), "");
    EXPECT_EQ(figure("refused = 1"), "");
    const std::string here = "cases/x.toml:13: ";
    EXPECT_EQ(figure("absolute = 1, ulp = 2"),
              here + "'figure' needs exactly one of absolute, relative, ulp, value and refused");
    EXPECT_EQ(figure("within = 0.1"),
              here + "'figure' needs exactly one of absolute, relative, ulp, value and refused");
    EXPECT_EQ(figure("ulp = -2"), here + "'ulp' must be a positive number");
    EXPECT_EQ(figure("refused = 1.5"), here + "'refused' is a share, at most 1");
    EXPECT_EQ(figure("ulp = 2, within = 1"), here + "'within' must be a number from 0 to below 1");
    EXPECT_EQ(figure("upl = 2"), here + "unknown key 'upl'; did you mean 'ulp'?");
    EXPECT_EQ(failure(known + "figure = 3"), here + "'figure' must be a table");
    EXPECT_EQ(failure(known + "verdict = \"crash\"\nfigure = { ulp = 2 }"),
              "cases/x.toml:14: 'figure' is of a failure by numbers, not of a crash");
    const auto verdict = [&](const std::string& name, const std::string& status) {
        return failure("cause = \"why\"\nverdict = \"" + name + "\"\nstatus = \"" + status + "\"");
    };
    EXPECT_EQ(verdict("nonconforming", "bug"), "");
    EXPECT_EQ(verdict("nonconforming", "method"),
              "cases/x.toml:12: 'status' must be bug: what the specification does not allow is "
              "one");
    EXPECT_EQ(verdict("skip", "bug"),
              "cases/x.toml:11: 'verdict' must be fail, nonconforming, crash or timeout");
    EXPECT_EQ(failure(device + "statsu = \"bug\""),
              "cases/x.toml:11: unknown key 'statsu'; did you mean 'status'?");
}

TEST_F(CaseTest, TakesFullCountsWhereTheyAreGiven) {
    auto read = Read(
        "source = \"s\"\ncall = \"f(x)\"\noracle = \"x\"\naccept = { ulp = 1 }\n"
        "[domain]\nx = { range = [1, 2], count = 5, full = 90 }\n"
        "y = { range = [1, 2], count = 7 }\n");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->domains[0].inputs[0].count, 5u);
    TakeFullCounts(*read);
    EXPECT_EQ(read->domains[0].inputs[0].count, 90u);
    EXPECT_EQ(read->domains[0].inputs[1].count, 7u);
}

TEST_F(CaseTest, ReadsCovers) {
    const auto read = Read(kHead + "covers = [\"F4\", \"D14\"]\n" + kDomain);
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_THAT(read->covers, ElementsAre("F4", "D14"));
    for (const char* wrong : {"f4", "F", "4", "F4a", "FF4", ""}) {
        EXPECT_EQ(Complaint(kHead + "covers = [\"" + wrong + "\"]\n" + kDomain),
                  "cases/x.toml:6: 'covers': '" + std::string(wrong) +
                      "' is no id, which reads as F4 does: a letter and a number");
    }
    EXPECT_EQ(Complaint(kHead + "covers = [\"F4\", \"F4\"]\n" + kDomain),
              "cases/x.toml:6: 'covers' names F4 twice");
    EXPECT_EQ(Complaint(kHead + "covers = \"F4\"\n" + kDomain),
              "cases/x.toml:6: 'covers' must be a list");
}

TEST_F(CaseTest, RefusesABlindAcceptance) {
    const auto check = [this](const std::string& oracle, const std::string& accept) {
        const auto read =
            Read("source = \"s\"\ncall = \"f(x)\"\noracle = \"" + oracle + "\"\naccept = { " +
                 accept + " }\n[domain]\nx = { values = [0.5, 1, 2] }\n");
        EXPECT_TRUE(read) << read.error().message;
        const auto table = Expand(read->domains, 1);
        EXPECT_TRUE(table);
        const auto checked = CheckAcceptance(*read, *table);
        return checked ? "" : BelowRoot(checked.error().message);
    };
    EXPECT_EQ(check("x", "absolute = 3.5"), "") << "-2 for 2 would fail";
    EXPECT_EQ(check("x", "absolute = 4"),
              "cases/x.toml:4: nothing could fail: absolute 4 accepts 0, -truth, 2 truth and truth "
              "+ 1 at all of 3 rows");
    EXPECT_EQ(check("x", "exact = true"), "");
    EXPECT_THAT(check("1 / (1/x - 1/x * 3 * (1/3))", "ulp = 1"), HasSubstr("nothing could fail"))
        << "the oracle knows nothing";
    EXPECT_EQ(check("x", "relative = 0.5, wrong = 0.4, beyond = 0.6"), "");
    EXPECT_EQ(check("x", "relative = 0.5, wrong = 0.4, beyond = 0.25"),
              "cases/x.toml:4: nothing could fail: the tolerance reaches as far as 'beyond' at all "
              "of 3 hits");
    EXPECT_EQ(check("-x", "absolute = 0.1, beyond = 1"), "");
    EXPECT_EQ(check("-x", "absolute = 0.1, missed = 0.1, beyond = 1"),
              "cases/x.toml:4: nothing could fail: 'missed' has no hits to miss, the truth is one "
              "at none of 3 rows");
    EXPECT_EQ(check("1 / ((x - 1) * (x - 2) + 3 * (1/3) - 1)", "exact = true, wrong = 0.4"),
              "cases/x.toml:4: nothing could fail: a value can be off at 1 of 3 rows, within the "
              "share that may be wrong");
    EXPECT_EQ(check("sqrt(-x)", "ulp = 1"),
              "cases/x.toml:4: the oracle for 'result' has no value at any of 3 rows");
}

TEST_F(CaseTest, ListsCases) {
    ASSERT_TRUE(WriteFile(root_ / "cases/b.toml", ""));
    ASSERT_TRUE(WriteFile(root_ / "cases/deep/a.toml", ""));
    ASSERT_TRUE(WriteFile(root_ / "cases/scene.glsl", ""));
    ASSERT_TRUE(WriteFile(root_ / "cases/deep/domain.part.toml", ""));
    const auto cases = ListCases(root_);
    ASSERT_TRUE(cases);
    EXPECT_THAT(*cases, ElementsAre("b", "deep/a"));
    const auto none = ListCases(root_ / "nowhere");
    ASSERT_FALSE(none);
    EXPECT_THAT(none.error().message, HasSubstr("nowhere/cases: No such file"));
}

}  // namespace
}  // namespace etalon
