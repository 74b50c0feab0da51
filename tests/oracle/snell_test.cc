#include "oracle/snell.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 40000;

Interface At(const Row& row) {
    return {row[0], row[1], row[2]};
}

std::vector<Big> Reflected(const Row& row) {
    std::vector<Big> result;
    for (std::size_t k = 0; k < 3; ++k) {
        result.push_back(Big(row[k]) - Big(2) * ExactDot(row, 0, 3) * Big(row[3 + k]));
    }
    return result;
}

std::vector<Big> Refracted(const Row& row, double n1, double n2) {
    Big cosine = -ExactDot(row, 0, 3);
    Big side = 1;
    if (cosine < Big(0)) {
        cosine = -cosine;
        side = -1;
    }
    const Interface at(n1, n2, Big(1) < cosine ? Big(1) : cosine);
    std::vector<Big> result;
    for (std::size_t k = 0; k < 3; ++k) {
        const Big along_normal = at.n1 / at.n2 * at.cos_i - at.cos_t;
        result.push_back(at.total
                             ? Big(0)
                             : at.n1 / at.n2 * Big(row[k]) + along_normal * side * Big(row[3 + k]));
    }
    return result;
}

// Indices of ordinary media: the bounds of vectors are absolute, and grow with n1 / n2.
Indices Media(Random& random) {
    Indices indices = RandomIndices(random);
    while (indices.n1 < 1 || indices.n1 > 4 || indices.n2 < 1 || indices.n2 > 4) {
        indices = RandomIndices(random);
    }
    return indices;
}

TEST(Snell, CosTransmittedKeepsItsBound) {
    ExpectBound("snell.cos_transmitted", RandomIncidence(kRows, 1),
                [](const Row& row) -> std::vector<Big> { return {At(row).cos_t}; });
}

TEST(Snell, CriticalCosineKeepsItsBoundAndIsNanWithoutOne) {
    ExpectBound("snell.critical_cosine", RandomIncidence(kRows, 2),
                [](const Row& row) -> std::vector<Big> {
                    const Interface at = At(row);
                    return {at.n2 < at.n1 ? Sqrt((at.n1 - at.n2) * (at.n1 + at.n2)) / at.n1
                                          : Big(0) / Big(0)};
                });
}

TEST(Snell, TotalInternalReflectionIsNeverWrong) {
    ExpectBound("snell.total_internal_reflection", RandomIncidence(kRows, 3),
                [](const Row& row) -> std::vector<Big> { return {At(row).total ? 1.0 : 0.0}; });
}

TEST(Snell, ReflectKeepsItsBound) {
    Random random(4);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        rows.push_back(RandomPair(random, random.Float(0, 1), random.Below(8) == 0));
    }
    ExpectBound("snell.reflect", rows, Reflected);
}

TEST(Snell, RefractKeepsItsBound) {
    Random random(5);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        const Indices indices = Media(random);
        Row row = RandomPair(random, RandomCosine(random, indices), random.Below(2) == 0);
        row.insert(row.end(), {indices.n1, indices.n2});
        rows.push_back(row);
    }
    ExpectBound("snell.refract", rows,
                [](const Row& row) { return Refracted(row, row[6], row[7]); });
}

TEST(Snell, RefractRgbKeepsItsBound) {
    Random random(6);
    std::vector<Row> rows;
    while (rows.size() < kRows / 4) {
        const Indices red = Media(random);
        const Indices green = Media(random);
        const Indices blue = Media(random);
        Row row = RandomPair(random, RandomCosine(random, green), random.Below(2) == 0);
        row.insert(row.end(), {red.n1, green.n1, blue.n1, red.n2, green.n2, blue.n2});
        rows.push_back(row);
    }
    ExpectBound("snell.refract_rgb", rows, [](const Row& row) {
        std::vector<Big> result;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const std::vector<Big> ray = Refracted(row, row[6 + channel], row[9 + channel]);
            result.insert(result.end(), ray.begin(), ray.end());
        }
        return result;
    });
}

// The printed law of the thesis, with the wrong sign, must not pass for a reflection.
TEST(Snell, AWrongSignIsNoticed) {
    Random random(7);
    std::vector<Row> rows;
    while (rows.size() < 100) {
        rows.push_back(RandomPair(random, random.Float(0.1, 1), false));
    }
    const Worst worst = Compare(*FindFunction("snell.reflect"), rows, [](const Row& row) {
        std::vector<Big> result;
        for (std::size_t k = 0; k < 3; ++k) {
            result.push_back(Big(row[k]) + Big(2) * ExactDot(row, 0, 3) * Big(row[3 + k]));
        }
        return result;
    });
    EXPECT_GT(worst.used, 1e9);
}

}  // namespace
}  // namespace etalon::oracle
