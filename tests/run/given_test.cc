#include "run/given.h"

#include <gtest/gtest.h>

#include "numeric/ulp.h"

namespace etalon {
namespace {

const std::vector<Column> kColumns = {
    {"n", Scalar::kInt}, {"v.x", Scalar::kFloat}, {"v.y", Scalar::kFloat}};

TEST(Given, HasWordsOfWhatIsThere) {
    const auto given = ReadGiven(kColumns, "v.y=0x1.8p+0, n=-1");
    ASSERT_TRUE(given) << given.error().message;
    EXPECT_EQ((*given)[0], 0xffffffffu);
    EXPECT_EQ((*given)[1], std::nullopt);
    EXPECT_EQ((*given)[2], ToBits(1.5f));
    const auto none = ReadGiven(kColumns, "");
    ASSERT_TRUE(none);
    EXPECT_EQ(*none, std::vector<std::optional<std::uint32_t>>(3));
}

TEST(Given, SaysWhatIsWrong) {
    const std::pair<const char*, const char*> rows[] = {
        {"n", "--at: 'n' is not NAME=VALUE"},       {"n=1,", "--at: '' is not NAME=VALUE"},
        {"m=1", "--at: the case has no input 'm'"}, {"n=x", "--at: n: 'x' is not an int"},
        {"n=1, n=2", "--at: 'n' stands twice"},
    };
    for (const auto& [at, message] : rows) {
        const auto given = ReadGiven(kColumns, at);
        ASSERT_FALSE(given) << at;
        EXPECT_EQ(given.error().message, message);
    }
}

}  // namespace
}  // namespace etalon
