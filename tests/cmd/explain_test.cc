// `etalon explain` as a user meets it, on the device that is Etalon's own evaluator.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "support/etalon.h"

namespace etalon {
namespace {

using nlohmann::json;
using testing::HasSubstr;

Finished Explain(std::vector<std::string> more) {
    more.insert(more.begin(), {"explain", "--root", "tests/readme", "-d", "cpu", "--at",
                               "radius=50,aperture=0.10201321"});
    return RunEtalon(more);
}

TEST(Explain, TheExitStatusIsTheVerdict) {
    const Finished wrong = Explain({"lens/sagitta"});
    EXPECT_EQ(wrong.status, 1) << wrong.err;
    EXPECT_THAT(wrong.out, HasSubstr("fail: rounding"));
    const Finished right = Explain({"lens/sagitta_stable"});
    EXPECT_EQ(right.status, 0) << right.err;
}

TEST(Explain, JsonHasEveryStep) {
    const Finished finished = Explain({"lens/sagitta", "--json"});
    const json read = json::parse(finished.out, nullptr, false);
    ASSERT_FALSE(read.is_discarded()) << finished.out.substr(0, 300) << finished.err;
    EXPECT_EQ(read["case"], "lens/sagitta");
    EXPECT_EQ(read["worst_step"], 5);
    ASSERT_EQ(read["steps"].size(), 5u);
    const json& last = read["steps"][4];
    EXPECT_EQ(last["operation"], "radius - #4");
    EXPECT_EQ(last["line"], 4);
    EXPECT_EQ(last["values"][0]["binary32"]["hex"], "0x1.cp-14");
    EXPECT_NEAR(last["values"][0]["lost_bits"].get<double>(), 19, 0.5);
    EXPECT_EQ(read["devices"][0]["record"]["verdict"], "fail");
    EXPECT_EQ(read["devices"][0]["result"]["hex"], "0x1.cp-14");
    EXPECT_FALSE(read["devices"][0]["parting"].contains("step"));
}

TEST(Explain, HelpDefinesTheAmplification) {
    EXPECT_THAT(RunEtalon({"explain", "--help"}).out, HasSubstr("|x df/dx|"));
}

}  // namespace
}  // namespace etalon
