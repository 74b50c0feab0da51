#include "oracle/shadow.h"

#include "relief_rays.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 20000;

Big Max(const Big& a, const Big& b) {
    return a < b ? b : a;
}

Big Hypot(const Big& a, const Big& b) {
    return Sqrt(a * a + b * b);
}

// (sine - cosine T) / (cosine + sine T) at 200 bits.
std::vector<Big> Opening(const double* direction, const Big& horizon) {
    const Big aside = Hypot(direction[0], direction[1]);
    return {(Big(direction[2]) - aside * horizon) / (aside + Big(direction[2]) * horizon)};
}

// A direction between the horizon and 85 degrees, of a length that is not one.
Row Direction(Random& random) {
    const double elevation = random.Between(0, 85) * std::numbers::pi / 180;
    const double azimuth = random.Between(0, 2 * std::numbers::pi);
    const double length = random.Between(0.5, 8);
    return {static_cast<float>(length * std::cos(elevation) * std::cos(azimuth)),
            static_cast<float>(length * std::cos(elevation) * std::sin(azimuth)),
            static_cast<float>(length * std::sin(elevation))};
}

void Append(Row& row, const Row& more) {
    row.insert(row.end(), more.begin(), more.end());
}

TEST(Shadow, RampKeepsItsBound) {
    Random random(1);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        Row row = Direction(random);
        Append(row, {random.Float(-20, 20), random.Float(-20, 20), random.Float(0.05, 0.2)});
        rows.push_back(row);
    }
    ExpectBound("shadow.ramp", rows, [](const Row& row) {
        const Big aside = Hypot(row[0], row[1]);
        const Big rise = (Big(row[3]) * Big(row[0]) + Big(row[4]) * Big(row[1])) * Big(row[5]);
        return Opening(row.data(), Max(rise / aside, 0));
    });
}

TEST(Shadow, StepsKeepTheirBound) {
    Random random(2);
    std::vector<Row> rows;
    std::size_t shaded = 0;
    while (rows.size() < kRows) {
        Row row = {random.Float(-2, 2), random.Float(-2, 2), random.Float(-0.5, 0)};
        Append(row, Direction(random));
        const double width = random.Float(0.1, 0.5);
        Append(row, {width, random.Float(0, 1), row[2], random.Float(0.05, 0.2)});
        const double share = row[0] / width - std::floor(row[0] / width);
        if (share > 0.05 && share < 0.95) {
            rows.push_back(row);
            shaded += std::fmod(std::floor(row[0] / width), 2) == 0 ? 1 : 0;
        }
    }
    EXPECT_GT(shaded, kRows / 3);
    ExpectBound("shadow.steps", rows, [](const Row& row) {
        const Big width = row[6];
        const Big terrace = Floor(Big(row[0]) / width);
        Big horizon = 0;
        if (Floor(terrace / Big(2)) * Big(2) == terrace && row[3] != 0) {
            const Big wall = (row[3] > 0 ? terrace + Big(1) : terrace) * width;
            // The way along the surface to the wall, in box heights.
            const Big way =
                (wall - Big(row[0])) / Big(row[3]) * Hypot(row[3], row[4]) / Big(row[9]);
            horizon = Max((Big(row[8]) + Big(row[7]) - Big(row[2])) / way, 0);
        }
        return Opening(row.data() + 3, horizon);
    });
}

TEST(Shadow, CapKeepsItsBound) {
    Random random(3);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        const double level = random.Float(-0.5, 0);
        Row row = {random.Float(0, 1), random.Float(0, 1), level};
        Append(row, Direction(random));
        const double radius = random.Float(0.1, 1);
        const double scale = random.Float(0.05, 0.2);
        Append(row, {random.Float(0, 1), random.Float(0, 1), radius, level, scale});
        const double way = std::hypot(row[6] - row[0], row[7] - row[1]) / scale;
        if (std::hypot(way, level + 0.5) > radius + 0.02) {
            rows.push_back(row);
        }
    }
    // The tangent by the other root's form, which cancels where the circle is above the point.
    ExpectBound("shadow.cap", rows, [](const Row& row) {
        const Big scale = row[10];
        const Big to_u = (Big(row[6]) - Big(row[0])) / scale;
        const Big to_v = (Big(row[7]) - Big(row[1])) / scale;
        const Big aside = Hypot(row[3], row[4]);
        const Big along = (to_u * Big(row[3]) + to_v * Big(row[4])) / aside;
        const Big beside = (to_u * Big(row[4]) - to_v * Big(row[3])) / aside;
        const Big square = Big(row[8]) * Big(row[8]) - beside * beside;
        const Big centre = Big(-0.5) - Big(row[2]);
        Big horizon = 0;
        if (Big(0) < along && Big(0) < square) {
            const Big reach = Sqrt(along * along + centre * centre - square);
            horizon = Max((along * centre + Sqrt(square) * reach) / (along * along - square), 0);
        }
        return Opening(row.data() + 3, horizon);
    });
}

// No place of a scene is above the ray that the oracle says touches it, and one is on it.
TEST(Shadow, ADenseScanFindsTheSameEdge) {
    Random random(4);
    for (int k = 0; k < 200; ++k) {
        const double radius = random.Float(0.3, 0.9);
        const double level = random.Float(-0.4, -0.1);
        const double way = radius + random.Float(0.05, 2);
        const double beside = random.Float(-0.2, 0.2);
        const Row row = {0, 0, level, 0.5, 0, 0.5, way, beside, radius, level, 1};
        const double opening = EvaluateOne("shadow.cap", row);
        double least = 1;
        for (int i = 1; i < 40000; ++i) {
            const double t = i * 1e-4;
            const double square = radius * radius - beside * beside - (t - way) * (t - way);
            const double above = std::fmax(level, std::sqrt(std::fmax(square, 0)) - 0.5) - level;
            least = std::fmin(least, (t - above) / (t + above));
        }
        EXPECT_NEAR(opening, least, 2e-6) << k;
    }
}

TEST(Shadow, DiscKeepsItsBound) {
    Random random(5);
    std::vector<Row> rows = {{-1}, {1}, {0}, {0.5}, {-1.5}, {2}};
    while (rows.size() < kRows) {
        const double x = random.Below(2) == 0 ? random.Float(-1, 1) : 1 - random.Power(-24, 0);
        rows.push_back({random.Below(2) == 0 ? x : -x});
    }
    // acos(x) = 2 atan(sqrt((1 - x) / (1 + x)))
    ExpectBound("shadow.disc", rows, [](const Row& row) -> std::vector<Big> {
        const Big x = row[0];
        if (!(Big(-1) < x)) {
            return {0};
        }
        if (!(x < Big(1))) {
            return {1};
        }
        const Big angle = Big(2) * Atan(Sqrt((Big(1) + x) / (Big(1) - x)));
        return {(angle + x * Sqrt((Big(1) - x) * (Big(1) + x))) / Big::Pi()};
    });
    EXPECT_NEAR(EvaluateOne("shadow.disc", {0.5}), 0.80449889, 1e-8);
}

TEST(Shadow, FlatGroundHidesNothing) {
    EXPECT_EQ(EvaluateOne("shadow.ramp", {3, 4, 5, 0, 0, 0.1}), 1);
    EXPECT_EQ(EvaluateOne("shadow.ramp", {3, 4, 5, -7, -7, 0.1}), 1) << "nor does a slope down";
    EXPECT_EQ(EvaluateOne("shadow.steps", {0.75, 0, 0, 3, 4, 5, 0.5, 0.25, -0.25, 0.1}), 1)
        << "nor a terrace as high";
    EXPECT_EQ(EvaluateOne("shadow.cap", {0, 0, 0, 3, 4, 5, -1, -1, 0.75, 0, 0.1}), 1)
        << "nor what is behind";
}

}  // namespace
}  // namespace etalon::oracle
