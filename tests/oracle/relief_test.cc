#include "oracle/relief.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "bound.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRay = 7;  // start, velocity, end

double Hit(std::string_view name, const Row& row) {
    std::vector<const double*> in;
    for (const double& input : row) {
        in.push_back(&input);
    }
    double result = 0;
    double* const out = &result;
    FindFunction(name)->evaluate(in.data(), &out, 1);
    return result;
}

// The unclamped height at texture coordinates, as a row has its parameters; twice, as the scan
// needs no 200 bits.
struct Scene {
    std::string_view name;
    std::function<Row(Random&)> parameters;
    double (*height)(const double* scene, double u, double v);
    Big (*exact_height)(const double* scene, const Big& u, const Big& v);
    double texture_per_height = 0.1;
};

double SphereHeight(const double* scene, double u, double v) {
    const double x = (u - scene[0]) / scene[4];
    const double y = (v - scene[1]) / scene[4];
    const double rest = scene[2] * scene[2] - x * x - y * y;
    return std::max(scene[3], rest >= 0 ? -0.5 + std::sqrt(rest) : -0.5);
}

Big ExactSphereHeight(const double* scene, const Big& u, const Big& v) {
    const Big x = (u - Big(scene[0])) / Big(scene[4]);
    const Big y = (v - Big(scene[1])) / Big(scene[4]);
    const Big rest = Big(scene[2]) * Big(scene[2]) - x * x - y * y;
    const Big height = rest < Big(0) ? Big(-0.5) : Sqrt(rest) - Big(0.5);
    return height < Big(scene[3]) ? Big(scene[3]) : height;
}

Big ExactStep(const double* scene, const Big& u, const Big&) {
    const Big half = Floor(u / Big(scene[0])) / Big(2);
    return Floor(half) == half ? Big(scene[2]) : Big(scene[2]) + Big(scene[1]);
}

const std::vector<Scene>& Scenes() {
    static const std::vector<Scene> scenes = {
        {"relief.plane", [](Random& random) { return Row{random.Float(-0.6, 0.6)}; },
         [](const double* scene, double, double) { return scene[0]; },
         [](const double* scene, const Big&, const Big&) { return Big(scene[0]); }},
        {"relief.ramp",
         [](Random& random) {
             return Row{random.Float(-0.4, 0.4), random.Float(-0.4, 0.4), random.Float(-0.2, 0.4)};
         },
         [](const double* scene, double u, double v) {
             return scene[2] + scene[0] * u + scene[1] * v;
         },
         [](const double* scene, const Big& u, const Big& v) {
             return Big(scene[2]) + Big(scene[0]) * u + Big(scene[1]) * v;
         }},
        {"relief.sine",
         [](Random& random) {
             const double fastest = random.Below(2) == 0 ? 4 : 64;
             return Row{random.Float(-0.5, 0.5), random.Float(-fastest, fastest),
                        random.Float(-fastest, fastest), random.Float(-1, 1),
                        random.Float(-0.4, 0.4)};
         },
         [](const double* scene, double u, double v) {
             return scene[4] + scene[0] * std::sin(2 * std::numbers::pi *
                                                   (scene[1] * u + scene[2] * v + scene[3]));
         },
         [](const double* scene, const Big& u, const Big& v) {
             return Big(scene[4]) +
                    Big(scene[0]) * Sin(Big(2) * Big::Pi() *
                                        (Big(scene[1]) * u + Big(scene[2]) * v + Big(scene[3])));
         }},
        {"relief.sphere_cap",
         [](Random& random) {
             return Row{random.Float(0, 1), random.Float(0, 1), random.Float(0, 6),
                        random.Float(-0.5, 0.4), 0.1f};
         },
         SphereHeight, ExactSphereHeight},
        {"relief.steps",
         [](Random& random) {
             return Row{random.Power(-7, 0), random.Float(-1, 1), random.Float(-0.5, 0.5)};
         },
         [](const double* scene, double u, double) {
             const double half = std::floor(u / scene[0]) / 2;
             return std::floor(half) == half ? scene[2] : scene[2] + scene[1];
         },
         ExactStep},
    };
    return scenes;
}

// Most fall from the top to the floor, at all angles; some go anywhere.
Row RandomRay(Random& random) {
    const bool falls = random.Below(3) != 0;
    const double angle =
        falls ? random.Between(0, 89.2) : std::fmin(90, random.Between(0, 120)) + 60;
    const double theta = angle * std::numbers::pi / 180;
    const double azimuth = random.Between(0, 2 * std::numbers::pi);
    const double flat = 0.1 * std::sin(theta) * (random.Below(8) == 0 ? 0 : 1);
    const auto z = falls && random.Below(2) == 0 ? 0.5 : random.Float(-0.5, 0.5);
    const double fall = static_cast<float>(-std::cos(theta));
    const double room = fall < 0 ? z + 0.5 : 0.5 - z;
    const double end = std::fmin(room / std::fabs(fall), 64);
    return {random.Float(-1, 2),
            random.Float(-1, 2),
            z,
            static_cast<float>(flat * std::cos(azimuth)),
            static_cast<float>(flat * std::sin(azimuth)) * (random.Below(8) == 0 ? 0 : 1),
            fall,
            static_cast<float>(end)};
}

std::vector<Row> RandomRows(const Scene& scene, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    while (rows.size() < count) {
        Row row = RandomRay(random);
        const Row parameters = scene.parameters(random);
        row.insert(row.end(), parameters.begin(), parameters.end());
        rows.push_back(row);
    }
    return rows;
}

double Gap(const Scene& scene, const Row& row, double t) {
    const double height = scene.height(row.data() + kRay, row[0] + t * row[3], row[1] + t * row[4]);
    return row[2] + t * row[5] - std::clamp(height, -0.5, 0.5);
}

Big ExactGap(const Scene& scene, const Row& row, const Big& t) {
    Big height = scene.exact_height(row.data() + kRay, Big(row[0]) + t * Big(row[3]),
                                    Big(row[1]) + t * Big(row[4]));
    height = height < Big(-0.5) ? Big(-0.5) : Big(0.5) < height ? Big(0.5) : height;
    return Big(row[2]) + t * Big(row[5]) - height;
}

std::string Text(const Scene& scene, const Row& row, double hit) {
    Worst worst;
    worst.row = row;
    return std::string(scene.name) + " hit " + std::to_string(hit) + ' ' + worst.Text();
}

// In 200 bits, the ray is above the surface one bound before the hit, and not one bound after it.
TEST(Relief, AHitIsWithinItsBound) {
    for (const Scene& scene : Scenes()) {
        const Function& function = *FindFunction(scene.name);
        std::size_t hits = 0;
        for (const Row& row : RandomRows(scene, 4000, 1)) {
            const double hit = Hit(scene.name, row);
            if (!(hit > 0)) {
                continue;
            }
            ++hits;
            const Big bound = function.relative_bound * hit + function.absolute_bound;
            EXPECT_TRUE(Big(0) < ExactGap(scene, row, Big(hit) - bound)) << Text(scene, row, hit);
            EXPECT_FALSE(Big(0) < ExactGap(scene, row, Big(hit) + bound)) << Text(scene, row, hit);
        }
        EXPECT_GT(hits, 1000u) << scene.name;
    }
}

// A dense scan finds no earlier hit, and none where there is said to be none.
TEST(Relief, NothingIsMetBeforeTheHit) {
    constexpr int kSamples = 4000;
    for (const Scene& scene : Scenes()) {
        std::size_t none = 0;
        std::size_t undecided = 0;
        const std::vector<Row> rows = RandomRows(scene, 4000, 2);
        for (const Row& row : rows) {
            const double hit = Hit(scene.name, row);
            undecided += std::isnan(hit) ? 1 : 0;
            none += hit < 0 ? 1 : 0;
            if (std::isnan(hit)) {
                continue;
            }
            if (hit == 0) {
                EXPECT_LE(Gap(scene, row, 0), 0) << Text(scene, row, hit);
            }
            const double last = hit < 0 ? row[6] : hit * (1 - 1e-12);
            for (int sample = 0; sample < kSamples && hit != 0; ++sample) {
                const double t = last * sample / (kSamples - 1);
                if (!(Gap(scene, row, t) > -1e-12)) {
                    ADD_FAILURE() << "met at " << t << ' ' << Text(scene, row, hit);
                    break;
                }
            }
        }
        EXPECT_GT(none, 100u) << scene.name;
        EXPECT_LT(undecided, rows.size() / 10) << scene.name << " is nearly always decided";
    }
}

TEST(Relief, ARayThatStartsInTheSolidMeetsItThere) {
    for (const Scene& scene : Scenes()) {
        std::size_t inside = 0;
        for (const Row& row : RandomRows(scene, 2000, 3)) {
            const double gap = Gap(scene, row, 0);
            if (gap < -1e-5) {
                ++inside;
                EXPECT_EQ(Hit(scene.name, row), 0) << Text(scene, row, 0);
            } else if (gap > 1e-5) {
                EXPECT_NE(Hit(scene.name, row), 0) << Text(scene, row, 0);
            }
        }
        EXPECT_GT(inside, 20u) << scene.name;
    }
}

// A level ray over a wave's crest, along u; one wave is a box height long.
Row OverTheCrest(double above, double phase) {
    return {0, 0, 0.25 + above, 0.1f, 0, 0, 16, 0.25, 10, 0, phase, 0};
}

TEST(Relief, ASineIsMissedOrMetAtItsCrest) {
    for (int k = 0; k < 64; ++k) {
        const double phase = k / 64.0;
        EXPECT_EQ(Hit("relief.sine", OverTheCrest(std::ldexp(1, -16), phase)), -1) << phase;
        EXPECT_TRUE(std::isnan(Hit("relief.sine", OverTheCrest(0, phase)))) << phase;
        // The crest is where 0.1f * 10 * t + phase is a quarter; before it by the arc cosine.
        const double depth = std::ldexp(1, -13);
        const double before = std::acos(1 - 4 * depth) / (2 * std::numbers::pi);
        const double from_crest = 0.25 - phase - before;
        const double hit = Hit("relief.sine", OverTheCrest(-depth, phase));
        const double inside = std::remainder(phase - 0.25, 1.0);
        if (std::fabs(inside) < before) {
            EXPECT_EQ(hit, 0) << phase;
        } else {
            EXPECT_NEAR(hit, from_crest < 0 ? from_crest + 1 : from_crest, 1e-6) << phase;
        }
    }
}

TEST(Relief, AWaveBetweenTwoSamplesIsMet) {
    // 100 waves along the ray, of which the first reaches the ray's height after 0.7 of them all.
    const Row row = {0, 0, 0.5, 1, 0, -0.25, 1, 0.1, 100, 0, 0, 0.2};
    const double hit = Hit("relief.sine", row);
    EXPECT_GT(hit, 0.7);
    EXPECT_LT(hit, 0.82);
    EXPECT_NEAR(0.5 - 0.25 * hit - 0.2 - 0.1 * std::sin(200 * std::numbers::pi * hit), 0, 1e-11);
}

// The gap falls through zero like a cube, without a slope: 200 bits would not find its root.
TEST(Relief, ARayAlongASinesFlankIsUndecided) {
    const float slope = -2 * std::numbers::pi_v<float> * 0.4f * 2.5f;
    const Row along = {0, 0, slope / -16, 1, 0, slope, 0.125f, 0.4f, 2.5f, 0, 0.34375f, 0};
    EXPECT_TRUE(std::isnan(Hit("relief.sine", along)));
    Row steeper = along;
    steeper[5] = 1.01 * slope;
    steeper[2] = steeper[5] / -16;
    EXPECT_NEAR(Hit("relief.sine", steeper), 0.0625, 1e-6);
}

TEST(Relief, NothingIsMetAboveTheBox) {
    EXPECT_EQ(Hit("relief.plane", {0, 0, 1, 0, 0, -1, 1.5, 0.75}), 0.5);
    EXPECT_EQ(Hit("relief.plane", {0, 0, 1, 0, 0, -1, 1.5, 0.25}), 0.75);
    EXPECT_EQ(Hit("relief.plane", {0, 0, 1, 0, 0, 1, 1, 0.75}), -1);
    // Rises out of the box under a steeper ramp, which it would meet at z = 0.75.
    EXPECT_EQ(Hit("relief.ramp", {0, 0, 0.25, 1, 0, 1, 1, 1.5, 0, 0}), -1);
    EXPECT_EQ(Hit("relief.ramp", {0, 0, 0.25, 1, 0, 1, 1, 3, 0, 0}), 0.125);
}

TEST(Relief, KnowsWhatIsEasyToSay) {
    const Row down = {0.5, 0.5, 0.5, 0, 0, -1, 1};
    const auto with = [&down](const Row& scene) {
        Row row = down;
        row.insert(row.end(), scene.begin(), scene.end());
        return row;
    };
    EXPECT_EQ(Hit("relief.plane", with({0.25})), 0.25);
    EXPECT_EQ(Hit("relief.plane", with({0.5})), 0);
    EXPECT_EQ(Hit("relief.plane", with({7})), 0) << "clamped to the box's top";
    EXPECT_TRUE(std::isnan(Hit("relief.plane", with({-0.5})))) << "at the ray's very end";
    EXPECT_EQ(Hit("relief.ramp", with({0.5, 0.25, -0.375})), 0.5);
    EXPECT_EQ(Hit("relief.sphere_cap", with({0.5, 0.5, 0.75, -0.5, 0.1})), 0.25);
    EXPECT_EQ(Hit("relief.sphere_cap", with({0.5, 0.5, 0.75, 0.375, 0.1})), 0.125);
    EXPECT_EQ(Hit("relief.steps", with({0.375, 0.5, -0.25})), 0.25);
    EXPECT_EQ(Hit("relief.steps", with({0.3125, 0.5, -0.25})), 0.25);
    EXPECT_EQ(Hit("relief.steps", with({0.75, 0.5, -0.25})), 0.75);
    EXPECT_EQ(Hit("relief.steps", {-0.25, 0, 0.5, 0, 0, -1, 1, 1, 0.5, -0.25}), 0.25)
        << "terraces go on below zero";
}

TEST(Relief, AWallIsAHitFromBothSides) {
    EXPECT_EQ(Hit("relief.steps", {0.5, 0, 0, 0.5, 0, 0, 4, 1, 0.5, -0.25}), 1);
    EXPECT_EQ(Hit("relief.steps", {2.5, 0, 0, -0.5, 0, 0, 4, 1, 0.5, -0.25}), 1);
    EXPECT_EQ(Hit("relief.steps", {0.5, 0, 0.375, 0.5, 0, 0, 4, 1, 0.5, -0.25}), -1);
}

TEST(Relief, ARayAlongTheSurfaceIsUndecided) {
    EXPECT_TRUE(std::isnan(Hit("relief.plane", {0, 0, 0.25, 0.1, 0, 0, 4, 0.25})));
    EXPECT_TRUE(std::isnan(Hit("relief.ramp", {0, 0, 0.25, 0.125, 0, 0.125, 4, 1, 0, 0.25})));
    EXPECT_TRUE(std::isnan(Hit("relief.steps", {0.5, 0, 0.25, 0.5, 0, 0, 4, 1, 0.5, -0.25})));
    EXPECT_TRUE(std::isnan(Hit("relief.steps", {0, 0, 0, 0.5, 0, 0, 4, 1, 0.5, -0.25})))
        << "from a wall";
    EXPECT_TRUE(std::isnan(Hit("relief.steps", {1, 0, 0.5, 0, 0, -1, 1, 1, 0.5, -0.25})))
        << "down along a wall";
    EXPECT_TRUE(
        std::isnan(Hit("relief.sphere_cap", {0, 0, 0.25, 0.1, 0, 0, 16, 0.8, 0, 0.75, -0.5, 0.1})));
}

TEST(Relief, WhatIsNoRayIsUndecided) {
    const double bad[] = {std::nan(""), std::numeric_limits<double>::infinity()};
    for (const Scene& scene : Scenes()) {
        const Row good = RandomRows(scene, 1, 4).front();
        for (std::size_t k = 0; k < good.size(); ++k) {
            for (const double value : bad) {
                Row row = good;
                row[k] = value;
                EXPECT_TRUE(std::isnan(Hit(scene.name, row))) << scene.name << ' ' << k;
            }
        }
        Row row = good;
        row[6] = -1;
        EXPECT_TRUE(std::isnan(Hit(scene.name, row))) << scene.name;
    }
    EXPECT_TRUE(std::isnan(Hit("relief.sine", {0, 0, 0.5, 1, 0, -1, 1, 0.1, 1e6, 0, 0, 0})));
    EXPECT_TRUE(std::isnan(Hit("relief.steps", {0, 0, 0.5, 1, 0, -1, 1, 1e-6, 0.1, 0})));
    EXPECT_TRUE(std::isnan(Hit("relief.steps", {0, 0, 0.5, 1, 0, -1, 1, 0, 0.1, 0})));
}

}  // namespace
}  // namespace etalon::oracle
