#include "run/prepared_case.h"

#include <gmock/gmock.h>

#include <bit>

#include "support/folder.h"

namespace etalon {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

constexpr const char* kShader = R"toml(
float twice(float x) { return 2.0 * x; }
vec2 both(float x, int n) { return vec2(x, float(n)); }
void split_up(float x, out int whole, out float rest) { whole = int(x); rest = fract(x); }
)toml";

constexpr const char* kTwice = R"toml(source = "f.glsl"
call = "twice(x)"
oracle = "2 * x"
accept = { ulp = 1 }
[domain]
x = { values = [1, 2, 3, 4, 5] }
)toml";

class PreparedCaseTest : public testing::Test {
  protected:
    PreparedCaseTest() { folder_.Write("f.glsl", kShader); }

    Case Source(const std::string& toml) {
        folder_.Write("cases/c.toml", toml);
        const auto source = ReadCase(folder_.path(), "c");
        EXPECT_TRUE(source) << source.error().message;
        return *source;
    }
    PreparedCase Ready(const std::string& toml) {
        const auto prepared = Prepare(Source(toml));
        EXPECT_TRUE(prepared) << prepared.error().message;
        return *prepared;
    }
    std::string ErrorOf(const std::string& toml) {
        const auto prepared = Prepare(Source(toml));
        return prepared ? "" : prepared.error().message;
    }
    std::string AtError(const std::string& at, const std::string& toml = kTwice) {
        const auto prepared = PrepareAt(Source(toml), at);
        return prepared ? "" : prepared.error().message;
    }
    static std::vector<float> Inputs(const PreparedCase& prepared, std::size_t column) {
        std::vector<float> values;
        for (std::uint64_t row = 0; row < prepared.table.rows; ++row) {
            values.push_back(std::bit_cast<float>(prepared.table.At(row, column)));
        }
        return values;
    }

    Folder folder_;
};

TEST_F(PreparedCaseTest, HasRowsTypesAndTruths) {
    const PreparedCase prepared = Ready(kTwice);
    EXPECT_EQ(prepared.table.rows, 5u);
    ASSERT_EQ(prepared.judged.size(), 1u);
    EXPECT_EQ(prepared.judged[0].name, "result");
    EXPECT_THAT(prepared.judged[0].truth.values, ElementsAre(2, 4, 6, 8, 10));
    EXPECT_EQ(prepared.judged[0].truth.errors.size(), 5u);
    EXPECT_THAT(prepared.judged[0].truth.alternatives, IsEmpty());
    EXPECT_THAT(prepared.laws, IsEmpty());
}

TEST_F(PreparedCaseTest, JudgesEveryComponentAndOutParameter) {
    const PreparedCase vector = Ready(R"toml(source = "f.glsl"
call = "both(x, n)"
oracle = "vec2(x, n)"
accept = { exact = true }
[domain]
x = { values = [0.5, 1.5] }
n = { type = "int", values = [-3] }
)toml");
    ASSERT_EQ(vector.judged.size(), 2u);
    EXPECT_EQ(vector.judged[0].name, "result.x");
    EXPECT_EQ(vector.judged[1].name, "result.y");
    EXPECT_EQ(vector.judged[1].column, 1u);
    EXPECT_THAT(vector.judged[0].truth.values, ElementsAre(0.5, 1.5));
    EXPECT_THAT(vector.judged[1].truth.values, ElementsAre(-3, -3));

    const PreparedCase outs = Ready(R"toml(source = "f.glsl"
call = "split_up(x, whole, rest)"
out = { whole = "int", rest = "float" }
oracle = { rest = "x - floor(x)", whole = "floor(x)" }
accept = { rest = { ulp = 1 }, whole = { exact = true } }
[domain]
x = { values = [2.75] }
)toml");
    ASSERT_EQ(outs.judged.size(), 2u);
    EXPECT_EQ(outs.judged[0].name, "rest");
    EXPECT_EQ(outs.judged[0].truth.values.at(0), 0.75);
    EXPECT_EQ(outs.judged[1].scalar, Scalar::kInt);
    EXPECT_NE(outs.judged[0].column, outs.judged[1].column);
}

TEST_F(PreparedCaseTest, AllowsZeroForSubnormalInputs) {
    const PreparedCase prepared = Ready(R"toml(source = "f.glsl"
call = "twice(x)"
oracle = "x + 1"
accept = { ulp = 1 }
[domain]
x = { values = [1, "0x1p-130", "-0x1p-149", "0x1p-126"] }
)toml");
    const Truth& truth = prepared.judged.at(0).truth;
    ASSERT_EQ(truth.alternatives.size(), 2u);
    EXPECT_EQ(truth.alternatives[0].row, 1u);
    EXPECT_EQ(truth.alternatives[0].value, 1);
    EXPECT_EQ(truth.alternatives[1].row, 2u);
}

TEST_F(PreparedCaseTest, PairsTheSidesOfALaw) {
    const PreparedCase prepared = Ready(R"toml(source = "f.glsl"
call = "twice(x)"
[domain]
x = { values = [1] }
n = { type = "int", values = [1] }
[[law]]
name = "one for all"
holds = "both(x, n) >= 0.0"
[[law]]
name = "each with its own"
holds = "both(x, n) == both(x, n)"
)toml");
    ASSERT_EQ(prepared.laws.size(), 2u);
    EXPECT_THAT(prepared.laws[0].pairs,
                ElementsAre(std::pair<std::size_t, std::size_t>(0, 2), std::pair(1u, 2u)));
    EXPECT_THAT(prepared.laws[1].pairs,
                ElementsAre(std::pair<std::size_t, std::size_t>(0, 2), std::pair(1u, 3u)));
    EXPECT_THAT(prepared.judged, IsEmpty());
}

TEST_F(PreparedCaseTest, NamesTheCasesMistakes) {
    const std::string file = (folder_.path() / "cases/c.toml").string();
    const std::string domain =
        "[domain]\nx = { values = [1] }\nn = { type = \"int\", values = [1] }\n";
    const auto with = [&](const std::string& call, const std::string& oracle) {
        return ErrorOf("source = \"f.glsl\"\ncall = \"" + call + "\"\noracle = \"" + oracle +
                       "\"\naccept = { ulp = 1 }\n" + domain);
    };
    EXPECT_EQ(with("both(x, n)", "x"), file + ":4: 'result' has 2 components, its oracle 1");
    EXPECT_EQ(with("twice(x)", "vec2(x, x)"), file + ":4: 'result' has 1 components, its oracle 2");
    EXPECT_EQ(with("thrice(x)", "x"),
              file + ":2: call:1: 'thrice' : no matching overloaded function found");
    EXPECT_THAT(with("twice(y)", "x"),
                StartsWith(file + ":2: call:1: 'y' : undeclared identifier"));
    EXPECT_EQ(
        ErrorOf("source = \"no.glsl\"\ncall = \"f(x)\"\noracle = \"x\"\naccept = { ulp = 1 }\n" +
                domain),
        file + ":1: 'source': there is no file " + (folder_.path() / "no.glsl").string());
    const auto scene = [&](const std::string& one) {
        return ErrorOf("source = \"f.glsl\"\ncall = \"twice(x)\"\nwith = [\"" + one +
                       "\"]\noracle = \"x\"\naccept = { ulp = 1 }\n" + domain);
    };
    EXPECT_EQ(scene("no.glsl"),
              file + ":3: 'with': there is no file " + (folder_.path() / "no.glsl").string());
    EXPECT_EQ(scene("map=no.png"),
              file + ":3: 'with': there is no file " + (folder_.path() / "no.png").string());
    const auto law = [&](const std::string& holds) {
        return ErrorOf("source = \"f.glsl\"\ncall = \"twice(x)\"\n" + domain +
                       "[[law]]\nname = \"l\"\nholds = \"" + holds + "\"\n");
    };
    EXPECT_EQ(law("both(x, n) == vec3(x)"),
              file + ":8: law 'l': the sides have 2 and 3 components");
    EXPECT_EQ(law("x == n"), file + ":8: law 'l': the sides have different types");
    EXPECT_THAT(law("nothing(x) == x"), StartsWith(file + ":8: law 'l':1: 'nothing' : "));
}

TEST_F(PreparedCaseTest, PreparesAtOneInput) {
    const auto prepared = PrepareAt(Source(kTwice), "x=0x1.8p+0");
    ASSERT_TRUE(prepared) << prepared.error().message;
    EXPECT_EQ(prepared->table.rows, 1u);
    EXPECT_EQ(prepared->judged.at(0).truth.values.at(0), 3);
    EXPECT_TRUE(PrepareAt(Source(kTwice), "  x= 7"));
}

TEST_F(PreparedCaseTest, SaysWhatIsWrongWithAnInput) {
    EXPECT_EQ(AtError("x"), "--at: 'x' is not NAME=VALUE");
    EXPECT_EQ(AtError("y=1"), "--at: the case has no input 'y'");
    EXPECT_EQ(AtError("x=word"), "--at: x: 'word' is not a float");
    EXPECT_EQ(AtError("x=1,"), "--at: '' is not NAME=VALUE");
    EXPECT_EQ(AtError("x.x=1"), "--at: the case has no input 'x.x'");
    constexpr const char* kVector = R"toml(source = "f.glsl"
call = "twice(v.x)"
oracle = "2 * v.x"
accept = { ulp = 1 }
[domain]
v = { type = "vec2", values = [[1, 2]] }
)toml";
    EXPECT_EQ(AtError("v.x=1", kVector), "--at: no value for input 'v.y'");
    EXPECT_EQ(AtError("v=1", kVector), "--at: the case has no input 'v'");
    EXPECT_EQ(AtError("v.y=1,v.x=3", kVector), "");
}

TEST_F(PreparedCaseTest, RefusesAnInputThatStandsTwice) {
    EXPECT_EQ(AtError("x=1,x=2"), "--at: 'x' stands twice");
}

TEST_F(PreparedCaseTest, ThinsEvenlyWithBothEnds) {
    const PreparedCase prepared = Ready(R"toml(source = "f.glsl"
call = "twice(x)"
oracle = "2 * x"
accept = { ulp = 1 }
[domain]
x = { values = [1, 2, "0x1p-130", 4, 5, 6, "0x1p-140"] }
)toml");
    const PreparedCase thin = Thin(prepared, 3);
    EXPECT_EQ(thin.table.rows, 3u);
    EXPECT_THAT(Inputs(thin, 0), ElementsAre(1, 4, 0x1p-140f));
    const Truth& truth = thin.judged.at(0).truth;
    EXPECT_THAT(truth.values, ElementsAre(2, 8, 0x1p-139));
    EXPECT_EQ(truth.errors.size(), 3u);
    // The alternative goes with its row; that of a row left out goes too.
    ASSERT_EQ(truth.alternatives.size(), 1u);
    EXPECT_EQ(truth.alternatives[0].row, 2u);
    EXPECT_EQ(prepared.judged.at(0).truth.alternatives.size(), 2u);

    EXPECT_EQ(Thin(prepared, 7).table.rows, 7u);
    EXPECT_EQ(Thin(prepared, 100).table.rows, 7u);
    EXPECT_THAT(Inputs(Thin(prepared, 1), 0), ElementsAre(1));
    EXPECT_THAT(Inputs(Thin(prepared, 2), 0), ElementsAre(1, 0x1p-140f));
}

TEST_F(PreparedCaseTest, ThinsASmallShareToOneValue) {
    const std::string rule = "absolute = 0.1, missed = 0.01, wrong = 0.4, beyond = 1";
    PreparedCase prepared = Ready(R"toml(source = "f.glsl"
call = "twice(x)"
oracle = "(x >= 3) * (2 * x + 1) - 1"
accept = { )toml" + rule + R"toml( }
[domain]
x = { values = [1, 2, 3, 4, 5, 6, 7] }
)toml");
    const Shares thin = *Thin(prepared, 4).judged[0].accept.shares;
    EXPECT_EQ(thin.missed, 1.0 / 3) << "of the hits at 1, 3, 5 and 7";
    EXPECT_EQ(thin.wrong, 0.4);
    prepared.judged[0].accept.shares = Shares{0, 0.01, 1};
    EXPECT_EQ(Thin(prepared, 4).judged[0].accept.shares->wrong, 0.25);
    EXPECT_EQ(Thin(prepared, 4).judged[0].accept.shares->missed, 0);
}

TEST_F(PreparedCaseTest, WantsAFloatForTheWayToAHit) {
    const auto layer = [](const std::string& rule) {
        return R"toml(source = "f.glsl"
call = "int(twice(x))"
oracle = "2 * x"
accept = { )toml" +
               rule + " }\n[domain]\nx = { values = [1, 2, 3] }\n";
    };
    EXPECT_EQ(ErrorOf(layer("exact = true, wrong = 0.01")), "");
    EXPECT_THAT(ErrorOf(layer("ulp = 1, wrong = 0.01, beyond = 1")),
                EndsWith("c.toml:4: 'result' is no float, and no way to a hit: 'wrong' goes with "
                         "exact = true"));
}

}  // namespace
}  // namespace etalon
