#include "oracle/slab.h"

#include "interface.h"

namespace etalon::oracle {
namespace {

std::vector<Row> RandomSlabs(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Row> rows = RandomIncidence(count, seed);
    for (Row& row : rows) {
        row.push_back(random.Below(4) == 0 ? 0 : random.Power(-20, 3));
        row.push_back(random.Power(-3, 3));
    }
    return rows;
}

// The shares of the face for one polarisation; T is a product, for 1 - R would cancel.
std::vector<Big> Slab(const Big& reflected, const Big& transmitted, const Big& left) {
    if (transmitted == Big(0)) {
        return {1, 0};
    }
    const Big inside = reflected * left;
    const Big through = transmitted * transmitted * left / (Big(1) - inside * inside);
    return {reflected + reflected * left * through, through};
}

TEST(Slab, SharesKeepTheirBound) {
    ExpectBound("slab.shares", RandomSlabs(20000, 1), [](const Row& row) {
        const Interface face(row[0], row[1], row[2]);
        const Big least = std::exp2(-12);
        const Big way = Big(row[3]) / (face.cos_t < least ? least : face.cos_t);
        const Big left = Exp2(-(way / Big(row[4])));
        const std::vector<Big> s = Slab(face.ReflectedS(), face.TransmittedS(), left);
        const std::vector<Big> p = Slab(face.ReflectedP(), face.TransmittedP(), left);
        return std::vector<Big>{(s[0] + p[0]) / Big(2), (s[1] + p[1]) / Big(2)};
    });
}

TEST(Slab, WithoutAbsorptionNothingIsLost) {
    const Function& shares = *FindFunction("slab.shares");
    for (const Row& row : RandomSlabs(1000, 2)) {
        const double inputs[] = {row[0], row[1], row[2], 0, 1};
        const double* in[] = {inputs, inputs + 1, inputs + 2, inputs + 3, inputs + 4};
        double results[2];
        double* out[] = {results, results + 1};
        shares.evaluate(in, out, 1);
        EXPECT_NEAR(results[0] + results[1], 1, 4e-15);
    }
}

}  // namespace
}  // namespace etalon::oracle
