#include "oracle/plane.h"

#include "bound.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kRows = 20000;

Big Component(const Row& row, std::size_t k) {
    return row[k];
}

TEST(Plane, RayParameterKeepsItsBound) {
    Random random(1);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        Row row(12);
        for (std::size_t k = 0; k < 3; ++k) {
            row[k] = random.Float(-16, 16);
            row[3 + k] = random.Float(-1, 1);
            row[6 + k] = random.Below(8) == 0 ? Step(row[k], 1) : random.Float(-16, 16);
            row[9 + k] = random.Below(8) == 0 ? 0 : random.Float(-1, 1);
        }
        if (std::abs(row[3] * row[9] + row[4] * row[10] + row[5] * row[11]) >= std::exp2(-20)) {
            rows.push_back(row);
        }
    }
    ExpectBound("plane.ray_parameter", rows, [](const Row& row) -> std::vector<Big> {
        Big numerator;
        Big denominator;
        for (std::size_t k = 0; k < 3; ++k) {
            const Big normal = Component(row, 9 + k);
            numerator = numerator + (Component(row, 6 + k) - Component(row, k)) * normal;
            denominator = denominator + Component(row, 3 + k) * normal;
        }
        return {numerator / denominator};
    });
}

TEST(Plane, FlatLayerKeepsItsBound) {
    Random random(2);
    std::vector<Row> rows;
    while (rows.size() < kRows) {
        const double z = random.Float(-16, 16);
        rows.push_back({random.Below(8) == 0 ? Step(z, -1) : random.Float(-1, 1),
                        random.Float(-1, 1), random.Float(-1, 1), z, random.Float(-1, 1),
                        random.Float(-1, 1), -random.Power(-20, 0)});
    }
    ExpectBound("plane.flat_layer", rows, [](const Row& row) -> std::vector<Big> {
        return {(Component(row, 0) - Component(row, 3)) / Component(row, 6)};
    });
}

TEST(Plane, AParallelRayHasNoParameter) {
    const Big undefined = Big(0) / Big(0);
    const Row across = {0, 0, 1, 1, 0, 0, 0, 0, 0, 0, 0, 1};
    EXPECT_EQ(Compare(*FindFunction("plane.ray_parameter"), {across},
                      [&](const Row&) -> std::vector<Big> { return {undefined}; })
                  .used,
              0);
    EXPECT_EQ(Compare(*FindFunction("plane.flat_layer"), {{0, 0, 0, 1, 1, 0, 0}},
                      [&](const Row&) -> std::vector<Big> { return {undefined}; })
                  .used,
              0);
}

}  // namespace
}  // namespace etalon::oracle
