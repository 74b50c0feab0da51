#include "oracle/intensity.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

// normal and light_dir stand the other way round than v and n.
std::vector<Row> RandomLight(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    while (rows.size() < count) {
        const Indices indices = RandomIndices(random);
        const Row pair = RandomPair(random, RandomCosine(random, indices), random.Below(2) == 0);
        rows.push_back(
            {pair[3], pair[4], pair[5], pair[0], pair[1], pair[2], indices.n1, indices.n2});
    }
    return rows;
}

TEST(Intensity, RefractionKeepsItsBound) {
    ExpectBound("intensity.refraction", RandomLight(40000, 1),
                [](const Row& row) -> std::vector<Big> {
                    const Big cosine = -ExactDot(row, 0, 3);
                    if (cosine < Big(0)) {
                        return {0};
                    }
                    const Interface at(row[6], row[7], Big(1) < cosine ? Big(1) : cosine);
                    return {at.Transmitted()};
                });
}

// At the critical angle a cosine of 53 bits is not enough.
TEST(Intensity, ARoundedCosineIsNoticed) {
    const Worst worst = Compare(
        *FindFunction("intensity.refraction"), RandomLight(40000, 1),
        [](const Row& row) -> std::vector<Big> {
            const double cosine = -(row[0] * row[3] + row[1] * row[4] + row[2] * row[5]);
            return {cosine < 0 ? Big(0)
                               : Interface(row[6], row[7], std::min(cosine, 1.0)).Transmitted()};
        });
    EXPECT_GT(worst.used, 100);
}

}  // namespace
}  // namespace etalon::oracle
