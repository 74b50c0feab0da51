#include "report/record.h"

#include <gmock/gmock.h>

#include "report/records.h"

namespace etalon {
namespace {

using testing::MatchesRegex;

TEST(Record, IsGoodWhereNothingNewIsWrong) {
    EXPECT_TRUE(Passed().Good());
    EXPECT_TRUE(Without(Verdict::kSkip, "x").Good());
    for (const Verdict verdict : {Verdict::kFail, Verdict::kCrash, Verdict::kTimeout}) {
        Record record = Without(verdict, "x");
        EXPECT_FALSE(record.Good());
        record.known_cause = "bug: y";
        EXPECT_TRUE(record.Good());
    }
}

TEST(VerdictName, IsAWord) {
    EXPECT_EQ(VerdictName(Verdict::kPass), "pass");
    EXPECT_EQ(VerdictName(Verdict::kFail), "fail");
    EXPECT_EQ(VerdictName(Verdict::kSkip), "skip");
    EXPECT_EQ(VerdictName(Verdict::kCrash), "crash");
    EXPECT_EQ(VerdictName(Verdict::kTimeout), "timeout");
}

TEST(Fingerprint, DependsOnAllThatADeviceTellsOfItself) {
    const std::string first = Fingerprint(Llvmpipe());
    EXPECT_THAT(first, MatchesRegex("[0-9a-f]{12}"));
    EXPECT_EQ(Fingerprint(Llvmpipe()), first);
    std::vector<DeviceInfo> others(7, Llvmpipe());
    others[0].description += "x";
    others[1].driver += "x";
    others[2].version += "x";
    others[3].api += "x";
    others[4].compiler += "x";
    others[5].features.pop_back();
    others[6].float_controls.clear();
    for (const DeviceInfo& other : others) {
        EXPECT_NE(Fingerprint(other), first);
    }
    DeviceInfo renamed = Llvmpipe();
    renamed.name = "osmesa:llvmpipe@new";
    EXPECT_EQ(Fingerprint(renamed), first);
}

}  // namespace
}  // namespace etalon
