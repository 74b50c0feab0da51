#include "base/result.h"

#include <gtest/gtest.h>

namespace etalon {
namespace {

Result<int> Half(int number) {
    if (number % 2 != 0) {
        return Error{"odd"};
    }
    return number / 2;
}

Result<int> Quarter(int number) {
    ETALON_TRY(half, Half(number));
    ETALON_TRY(quarter, Half(half));
    return quarter;
}

Status<> IsEven(int number, int& steps) {
    ETALON_TRY_STEP(Half(number));
    ++steps;
    return Ok();
}

TEST(Result, TravelsToTheCaller) {
    EXPECT_EQ(*Quarter(8), 2);
    EXPECT_EQ(Quarter(6).error().message, "odd");
    EXPECT_FALSE(Quarter(7).ok());
    int steps = 0;
    EXPECT_TRUE(IsEven(2, steps));
    EXPECT_FALSE(IsEven(3, steps));
    EXPECT_EQ(steps, 1);
}

TEST(ResultDeathTest, StopsWhereTheValueIsNotThere) {
    EXPECT_DEATH((void)Half(3).value(), "internal error");
    EXPECT_DEATH((void)Half(2).error(), "internal error");
}

}  // namespace
}  // namespace etalon
