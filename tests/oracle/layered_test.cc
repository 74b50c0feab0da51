#include "oracle/layered.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 20000;

struct Refraction {
    std::vector<Big> ray;  // unit length
    Big cos_t;
    Big square;  // (n2 cos_t)^2
};

// The row is v (to the eye), n, n1, n2; Snell's law by the cosines, in the thesis' form.
Refraction Refracted(const Row& row) {
    const Big v_length = Sqrt(ExactDot(row, 0, 0));
    const Big n_length = Sqrt(ExactDot(row, 3, 3));
    Big cosine = ExactDot(row, 0, 3) / (v_length * n_length);
    Big side = 1;
    if (cosine < Big(0)) {
        cosine = -cosine;
        side = -1;
    }
    const Interface at(row[6], row[7], cosine);
    const Big ratio = at.n1 / at.n2;
    std::vector<Big> ray;
    for (std::size_t k = 0; k < 3; ++k) {
        ray.push_back((ratio * cosine - at.cos_t) * side * Big(row[3 + k]) / n_length -
                      ratio * Big(row[k]) / v_length);
    }
    return {ray, at.cos_t, at.square};
}

std::vector<Big> Way(const Row& row) {
    const Refraction refraction = Refracted(row);
    const Big& down = refraction.ray[2];
    if (refraction.square < Big(0) || !(down < Big(0))) {
        const Big none = Big(0) / Big(0);
        return {none, none, none};
    }
    const Big way = Big(row[8]) / -down;
    return {way * refraction.ray[0], way * refraction.ray[1], way};
}

Row RandomSurface(Random& random) {
    const double n1 = random.Float(1, 4);
    const double n2 =
        random.Below(4) == 0 ? Step(n1, static_cast<int>(random.Below(3)) - 1) : random.Float(1, 4);
    const Indices indices = {n1, std::max(n2, 1.0)};
    Row row = RandomPair(random, RandomCosine(random, indices), random.Below(4) == 0);
    for (std::size_t k = 0; k < 3; ++k) {
        row[k] = -row[k];
    }
    row.insert(row.end(), {indices.n1, indices.n2, random.Float(0, 8)});
    return row;
}

TEST(Layered, WayKeepsItsBound) {
    Random random(1);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        const Row row = RandomSurface(random);
        const Refraction refraction = Refracted(row);
        if (!(refraction.square < Big(0)) && Big(0.1) < refraction.cos_t &&
            refraction.ray[2] < Big(-0.1)) {
            rows.push_back(row);
        }
    }
    ExpectBound("layered.way", rows, Way);
}

TEST(Layered, ThereIsNoWayThatLeadsUpOrDoesNotEnter) {
    Random random(2);
    std::vector<Row> rows;
    while (rows.size() < 1000) {
        const Row row = RandomSurface(random);
        const Refraction refraction = Refracted(row);
        // Binary64 decides but for its last digits.
        if (refraction.square < Big(-1e-12) || Big(1e-6) < refraction.ray[2]) {
            rows.push_back(row);
        }
    }
    const Worst worst = Compare(*FindFunction("layered.way"), rows,
                                [none = Big(0) / Big(0)](const Row&) -> std::vector<Big> {
                                    return {none, none, none};
                                });
    EXPECT_EQ(worst.used, 0) << worst.Text();
}

TEST(Layered, DiscKeepsItsBound) {
    Random random(3);
    std::vector<Row> rows = {{0}, {64}};
    while (rows.size() < kRows / 4) {
        rows.push_back({random.Below(2) == 0 ? random.Float(0, 64) : random.Power(-149, 6)});
    }
    ExpectBound("layered.disc", rows, [](const Row& row) -> std::vector<Big> {
        return {row[0] == 0 ? Big(1) : Big(2) * BesselJ1(Big(row[0])) / Big(row[0])};
    });
}

}  // namespace
}  // namespace etalon::oracle
