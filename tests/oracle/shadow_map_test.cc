#include "oracle/shadow_map.h"

#include "bound.h"

namespace etalon::oracle {
namespace {

Big Exp(const Big& a) {
    return Expm1(a) + Big(1);
}

Big Pi() {
    return Big(4) * (Big(4) * Atan(Big(1) / Big(5)) - Atan(Big(1) / Big(239)));
}

struct Medium {
    Medium(double absorbed, double scattered, double index_of_refraction)
        : total(Big(absorbed) + Big(scattered)) {
        // The coefficients are decimal fractions.
        const Big index = index_of_refraction;
        const Big reflected = (Big(-1440) / index / index + Big(710) / index + Big(668) +
                               Big(636) * index / Big(10)) /
                              Big(1000);
        albedo = Big(scattered) / total;
        extinction = Sqrt(Big(3) * Big(absorbed) * total);
        poles[0] = Big(1) / total;
        poles[1] =
            poles[0] + Big(4) * (Big(1) + reflected) / (Big(3) * (Big(1) - reflected) * total);
    }

    Big Reflectance(const Big& square) const {
        Big sum;
        for (const Big& z : poles) {
            const Big d = Sqrt(square + z * z);
            const Big x = extinction * d;
            sum = sum + z * (Big(1) + x) * Exp(-x) / (d * d * d);
        }
        return albedo * sum / (Big(4) * Pi());
    }
    Big Beyond(const Big& square) const {
        Big sum;
        for (const Big& z : poles) {
            const Big d = Sqrt(square + z * z);
            sum = sum + z * Exp(-(extinction * d)) / d;
        }
        return albedo * sum / Big(2);
    }

    Big total;
    Big albedo;
    Big extinction;
    Big poles[2];
};

Row RandomMedium(Random& random) {
    const double absorbed = random.Below(8) == 0 ? 0 : random.Power(-8, 4);
    return {absorbed, random.Power(-6, 4), random.Float(1, 3)};
}

// A way of at most 60 effective mean free paths, and not too far for the domain.
double RandomWay(Random& random, const Row& medium) {
    const double extinction = std::sqrt(3 * medium[0] * (medium[0] + medium[1]));
    return static_cast<float>(random.Between(0, std::min(32.0, 40 / (extinction + 0.1))));
}

TEST(ShadowMap, ReflectanceKeepsItsBound) {
    Random random(1);
    std::vector<Row> rows;
    while (rows.size() < 4000) {
        Row row = RandomMedium(random);
        row.push_back(random.Below(8) == 0 ? 0 : RandomWay(random, row));
        rows.push_back(row);
    }
    ExpectBound("shadow_map.reflectance", rows, [](const Row& row) -> std::vector<Big> {
        return {Medium(row[0], row[1], row[2]).Reflectance(Big(row[3]) * Big(row[3]))};
    });
}

TEST(ShadowMap, BeyondKeepsItsBound) {
    Random random(2);
    std::vector<Row> rows;
    while (rows.size() < 4000) {
        Row row = RandomMedium(random);
        const double way = random.Below(8) == 0 ? 0 : RandomWay(random, row);
        row.push_back(static_cast<float>(way * way));
        rows.push_back(row);
    }
    ExpectBound("shadow_map.beyond", rows, [](const Row& row) -> std::vector<Big> {
        return {Medium(row[0], row[1], row[2]).Beyond(row[3])};
    });
}

// R_d integrated numerically over rings is its closed integral: to 6 digits, for the three media of
// which these values are known.
TEST(ShadowMap, ThePlanesIntegralIsThatOfTheReflectance) {
    const Row media[] = {{0.01, 1, 1.3}, {0.0021, 2.55, 1.3}, {1, 1, 1.5}};
    const double known[] = {0.645827, 0.875477, 0.073572};
    for (int k = 0; k < 3; ++k) {
        const double* in[4];
        double square = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            in[i] = &media[k][i];
        }
        in[3] = &square;
        double integral = 0;
        double* out[] = {&integral};
        FindFunction("shadow_map.beyond")->evaluate(in, out, 1);
        EXPECT_NEAR(integral, known[k], 6e-7);

        // Rings of equal steps in log r, by the midpoint rule.
        double sum = 0;
        const double step = 1e-3;
        for (double log_r = -12 + step / 2; log_r < 7; log_r += step) {
            const double r = std::exp(log_r);
            double value = 0;
            in[3] = &r;
            double* at[] = {&value};
            FindFunction("shadow_map.reflectance")->evaluate(in, at, 1);
            sum += value * 2 * 3.14159265358979 * r * r * step;
        }
        EXPECT_NEAR(sum, integral, 1e-6);
    }
}

TEST(ShadowMap, SumKeepsItsBound) {
    Random random(3);
    std::vector<Row> rows;
    for (double scene = 0; scene < 4; ++scene) {
        rows.push_back({scene, random.Float(0, 0.5), random.Float(0.25, 2), random.Float(1, 2),
                        random.Float(0, 1), random.Float(0, 1), random.Float(2, 6)});
    }
    ExpectBound("shadow_map.sum", rows, [](const Row& row) -> std::vector<Big> {
        const Medium medium(row[1], row[2], row[3]);
        Big sum;
        for (int texel = 0; texel < 128 * 128; ++texel) {
            const double x = (texel % 128 - 63.5) / 16;
            const double y = (texel / 128 - 63.5) / 16;
            const bool sphere = row[0] == 2;
            if (sphere ? x * x + y * y > 4 : std::max(std::abs(x), std::abs(y)) > 3) {
                continue;
            }
            Big depth = 2;
            if (sphere) {
                depth = Big(4) - Sqrt(Big(4 - x * x - y * y));
            } else if (row[0] != 0) {
                depth = Big(2 + (row[0] == 1 ? x : std::abs(x)) / 2);
            }
            const Big way[] = {Big(x) - Big(8) * (Big(row[4]) - Big(0.5)),
                               Big(y) - Big(8) * (Big(row[5]) - Big(0.5)), depth - Big(row[6])};
            sum = sum + medium.Reflectance(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
        }
        return {sum / Big(256)};
    });
}

}  // namespace
}  // namespace etalon::oracle
