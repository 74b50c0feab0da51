// What the thesis says of its search's steps, in operations, which depend on no machine.
#include <gtest/gtest.h>

#include "case/case.h"
#include "cost/cost.h"

namespace etalon {
namespace {

// One call of the search on a flat solid at z = 0.01: 12 of 24 linear steps are made.
OperationCounts Search(int linear, int binary, bool approximate) {
    auto source = ReadCase(".", "published/full_screen/resolution");
    EXPECT_TRUE(source) << source.error().message;
    for (Input& input : source->domains.front().inputs) {
        if (input.name == "amplitude" || input.name == "level") {
            input.range.reset();
            input.values = {{input.name == "level" ? 0.01 : 0.0}};
        }
    }
    source->call = "find_solid_seen(uv, eye, 0.05, ivec2(" + std::to_string(linear) + ", " +
                   std::to_string(binary) + "), " + (approximate ? "true" : "false") + ").z";
    const auto prepared = PrepareCall(*source);
    EXPECT_TRUE(prepared) << prepared.error().message;
    const auto counted = CountOperations(*prepared);
    EXPECT_TRUE(counted) << counted.error().message;
    return counted->mean;
}

TEST(PublishedSteps, ABisectionIsDearerThanALinearStep) {
    const double linear = (Search(48, 0, false).Total() - Search(24, 0, false).Total()) / 12;
    const double binary = (Search(24, 12, false).Total() - Search(24, 6, false).Total()) / 6;
    EXPECT_GT(binary, linear);
    EXPECT_LT(binary, 2 * linear);
}

TEST(PublishedSteps, LinearStepsToTheSameResolutionAreTenTimesAsDear) {
    EXPECT_GT(Search(512, 0, false).Total(), 10 * Search(8, 6, false).Total());
}

TEST(PublishedSteps, TheApproximationCostsLessThanTwoBisections) {
    const double bisection = (Search(24, 12, false).Total() - Search(24, 6, false).Total()) / 6;
    const double approximation = Search(8, 6, true).Total() - Search(8, 6, false).Total();
    EXPECT_GT(approximation, 0);
    EXPECT_LT(approximation, 2 * bisection);
}

}  // namespace
}  // namespace etalon
