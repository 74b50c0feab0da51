#include "oracle/absorption.h"

#include "bound.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 20000;

// Ways from nothing to a thousand half distances, at every scale.
std::vector<Row> RandomWays(std::uint64_t seed, bool colored) {
    Random random(seed);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        const double half_distance = random.Power(-120, 100);
        double d = half_distance * std::exp2(random.Between(-24, 9.9));
        switch (random.Below(8)) {
            case 0:
                d = random.Power(-149, 0) * half_distance;
                break;
            case 1:
                d = half_distance * random.Below(4);
                break;
            default:
                break;
        }
        Row row = {static_cast<float>(d), half_distance};
        for (int channel = 0; colored && channel < 3; ++channel) {
            row.push_back(random.Below(4) == 0 ? random.Below(2) : random.Power(-30, 0));
        }
        rows.push_back(row);
    }
    return rows;
}

Big Halvings(const Row& row) {
    return Big(row[0]) / Big(row[1]);
}

// 200 bits are few for 1 - 2^(-y): y goes down to 2^-149, and 2^(-y) as well.
Big Absorbed(const Row& row) {
    return -Expm1(-(Big::Ln2() * Halvings(row)));
}

TEST(Absorption, AbsorbedKeepsItsBound) {
    ExpectBound("absorption.absorbed", RandomWays(1, false),
                [](const Row& row) -> std::vector<Big> { return {Absorbed(row)}; });
}

TEST(Absorption, TransmittedKeepsItsBound) {
    ExpectBound("absorption.transmitted", RandomWays(2, false),
                [](const Row& row) -> std::vector<Big> { return {Exp2(-Halvings(row))}; });
}

TEST(Absorption, HuedKeepsItsBound) {
    ExpectBound("absorption.hued", RandomWays(3, true), [](const Row& row) {
        std::vector<Big> result;
        for (std::size_t channel = 2; channel < 5; ++channel) {
            const Big absorb = row[channel];
            result.push_back((Big(1) - absorb) + absorb * Exp2(-Halvings(row)));
        }
        return result;
    });
}

TEST(Absorption, BeerLambertKeepsItsBound) {
    ExpectBound("absorption.beer_lambert", RandomWays(4, true), [](const Row& row) {
        std::vector<Big> result;
        for (std::size_t channel = 2; channel < 5; ++channel) {
            result.push_back(Exp2(-(Big(row[channel]) * Halvings(row))));
        }
        return result;
    });
}

// 1 - 2^(-y) in binary64 has no digit left for the shortest ways.
TEST(Absorption, AnOracleThatCancelsIsNoticed) {
    Function wrong = *FindFunction("absorption.absorbed");
    wrong.evaluate = [](const double* const* in, double* const* out, std::size_t rows) {
        for (std::size_t row = 0; row < rows; ++row) {
            out[0][row] = 1 - std::exp2(-in[0][row] / in[1][row]);
        }
    };
    const Worst worst = Compare(wrong, RandomWays(1, false),
                                [](const Row& row) -> std::vector<Big> { return {Absorbed(row)}; });
    EXPECT_GT(worst.used, 1000);
}

}  // namespace
}  // namespace etalon::oracle
