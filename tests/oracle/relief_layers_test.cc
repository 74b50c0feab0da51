#include "oracle/relief_layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "relief_rays.h"

namespace etalon::oracle {
namespace {

struct Meeting {
    double first;
    double layer;
};

Meeting Of(double translucent, double solid) {
    return {EvaluateOne("relief.first", {translucent, solid}),
            EvaluateOne("relief.first_layer", {translucent, solid})};
}

void Expect(double translucent, double solid, double first, double layer) {
    const Meeting meeting = Of(translucent, solid);
    EXPECT_EQ(meeting.first, first) << translucent << ' ' << solid;
    EXPECT_EQ(meeting.layer, layer) << translucent << ' ' << solid;
}

TEST(ReliefLayers, TheFirstIsMet) {
    Expect(0.25, 0.5, 0.25, 1);
    Expect(0.5, 0.25, 0.25, 2);
    Expect(0, 0.25, 0, 1);
    Expect(0.25, 0, 0, 2);
}

TEST(ReliefLayers, OfTwoAtOnceTheSolidIsMet) {
    Expect(0.5, 0.5, 0.5, 2);
    Expect(0, 0, 0, 2);
}

TEST(ReliefLayers, ALayerThatIsNotMetIsNotFirst) {
    Expect(-1, 0.5, 0.5, 2);
    Expect(0.5, -1, 0.5, 1);
    Expect(0, -1, 0, 1);
    Expect(-1, 0, 0, 2);
    Expect(-1, -1, -1, 0);
}

TEST(ReliefLayers, WhatIsUndecidedStaysSo) {
    const double nan = std::nan("");
    for (const auto& [translucent, solid] : {std::pair(nan, 0.5), {0.5, nan}, {nan, nan}}) {
        EXPECT_TRUE(std::isnan(Of(translucent, solid).first));
        EXPECT_TRUE(std::isnan(Of(translucent, solid).layer));
    }
}

TEST(ReliefLayers, NearlyAtOnceTheWayIsKnownAndTheLayerIsNot) {
    const double near = 0.5 + 1e-7;
    EXPECT_EQ(Of(0.5, near).first, 0.5);
    EXPECT_TRUE(std::isnan(Of(0.5, near).layer));
    EXPECT_TRUE(std::isnan(Of(near, 0.5).layer));
    Expect(0.5, 0.5 + 1e-6, 0.5, 1);
}

}  // namespace
}  // namespace etalon::oracle
