#include "oracle/conductor.h"

#include "bound.h"

namespace etalon::oracle {
namespace {

std::vector<Row> RandomMetals(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    while (rows.size() < count) {
        const double cosine = random.Below(4) == 0 ? random.Power(-149, 0) : random.Float(0, 1);
        rows.push_back({random.Power(-3, 3), random.Power(-3, 3), random.Power(-1, 4),
                        random.Below(16) == 0 ? random.Below(2) : cosine});
    }
    return rows;
}

// In real numbers: a + i b = sqrt((n2 + i k2)^2 - (n1 sin)^2); the amplitudes' squares are
// |n1 c - (a + i b)|^2 over that of the sum, and for R_p of a c, b c and n1 sin^2 besides.
std::vector<Big> Reflectances(const Row& row) {
    const Big n1 = row[0];
    const Big n2 = row[1];
    const Big k2 = row[2];
    const Big c = row[3];
    const Big sine_squared = Big(1) - c * c;
    const Big real = n2 * n2 - k2 * k2 - n1 * n1 * sine_squared;
    const Big modulus = Sqrt(real * real + Big(4) * n2 * n2 * k2 * k2);
    const Big a = Sqrt((modulus + real) / Big(2));
    const Big b = n2 * k2 / a;
    const auto share = [](const Big& x, const Big& y, const Big& w) {
        return ((x - w) * (x - w) + y * y) / ((x + w) * (x + w) + y * y);
    };
    const Big s = share(a, b, n1 * c);
    return {s, s * share(a * c, b * c, n1 * sine_squared)};
}

TEST(Conductor, ReflectanceSpKeepsItsBound) {
    ExpectBound("conductor.reflectance_sp", RandomMetals(20000, 1), Reflectances);
}

TEST(Conductor, ReflectanceKeepsItsBound) {
    ExpectBound("conductor.reflectance", RandomMetals(20000, 2), [](const Row& row) {
        const std::vector<Big> both = Reflectances(row);
        return std::vector<Big>{(both[0] + both[1]) / Big(2)};
    });
}

}  // namespace
}  // namespace etalon::oracle
