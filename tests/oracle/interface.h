// Interfaces of two media for the tests of the optics: inputs, and the physics at 200 bits.
#pragma once

#include <cmath>
#include <vector>

#include "bound.h"

namespace etalon::oracle {

struct Indices {
    double n1;
    double n2;
};

// Ordinary, nearly equal down to neighbouring floats, equal, and far apart.
inline Indices RandomIndices(Random& random) {
    const double n1 = random.Float(1, 4);
    switch (random.Below(8)) {
        case 0:
            return {n1, Step(n1, static_cast<int>(random.Below(7)) - 3)};
        case 1:
            return {n1, static_cast<float>(n1 * (1 + random.Power(-22, -1)))};
        case 2:
            return {n1, static_cast<float>(n1 * (1 - random.Power(-22, -1)))};
        case 3:
            return {random.Power(-10, 10), random.Power(-10, 10)};
        default:
            return {n1, random.Float(1, 4)};
    }
}

// Cosines everywhere: subnormal to 1, and the last floats around the critical and Brewster's angle.
inline double RandomCosine(Random& random, Indices indices) {
    const auto [n1, n2] = indices;
    const int step = static_cast<int>(random.Below(9)) - 4;
    switch (random.Below(8)) {
        case 0:
            return 0;
        case 1:
            return 1;
        case 2:
            return random.Power(-149, 0);
        case 3:
            return std::min(Step(n1 / std::hypot(n1, n2), step), 1.0);
        case 4:
        case 5:
            if (n1 > n2) {
                return std::min(Step(std::sqrt((n1 - n2) * (n1 + n2)) / n1, step), 1.0);
            }
            [[fallthrough]];
        default:
            return random.Float(0, 1);
    }
}

inline std::vector<Row> RandomIncidence(std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<Row> rows;
    while (rows.size() < count) {
        const Indices indices = RandomIndices(random);
        rows.push_back({indices.n1, indices.n2, RandomCosine(random, indices)});
    }
    return rows;
}

// Unit vectors (v, n), n opposing v but for a few, with the cosine of the angle between them:
// v in the plane x, z and n = z where `exact`, so that the cosine stays the float that it is.
inline Row RandomPair(Random& random, double cosine, bool exact) {
    const double sine = std::sqrt((1 - cosine) * (1 + cosine));
    double v[3] = {sine, 0, -cosine};
    double n[3] = {0, 0, 1};
    if (!exact) {
        double axis[3];
        double length = 0;
        while (length < 0.1 || length > 1) {
            for (double& part : axis) {
                part = random.Between(-1, 1);
            }
            length = std::hypot(axis[0], axis[1], axis[2]);
        }
        // Mirrored in a random plane, both alike.
        for (double* vector : {v, n}) {
            const double along =
                2 * (vector[0] * axis[0] + vector[1] * axis[1] + vector[2] * axis[2]);
            for (int k = 0; k < 3; ++k) {
                vector[k] -= along * axis[k] / (length * length);
            }
        }
    }
    const double side = random.Below(16) == 0 ? -1 : 1;
    Row row;
    for (const double part : v) {
        row.push_back(static_cast<float>(part));
    }
    for (const double part : n) {
        row.push_back(static_cast<float>(side * part));
    }
    return row;
}

inline Big ExactDot(const Row& row, std::size_t a, std::size_t b) {
    Big sum;
    for (std::size_t k = 0; k < 3; ++k) {
        sum = sum + Big(row[a + k]) * Big(row[b + k]);
    }
    return sum;
}

// Snell's law and Fresnel's equations as every textbook has them; 200 bits are enough for what
// cancels in them, at least 50 are left of every difference. The transmitted share is a product, as
// 1 - R would not have them.
struct Interface {
    Interface(double first, double second, Big cosine)
        : n1(first),
          n2(second),
          cos_i(cosine),
          square((n2 - n1) * (n2 + n1) + n1 * n1 * cos_i * cos_i) {
        total = square < Big(0);
        cos_t = total ? Big(0) : Sqrt(square) / n2;
    }

    Big ReflectedS() const { return ReflectedShare(n1 * cos_i, n2 * cos_t); }
    Big ReflectedP() const { return ReflectedShare(n1 * cos_t, n2 * cos_i); }
    Big Reflected() const { return (ReflectedS() + ReflectedP()) / Big(2); }
    Big TransmittedS() const { return TransmittedShare(n1 * cos_i, n2 * cos_t); }
    Big TransmittedP() const { return TransmittedShare(n1 * cos_t, n2 * cos_i); }
    Big Transmitted() const { return (TransmittedS() + TransmittedP()) / Big(2); }

    Big n1;
    Big n2;
    Big cos_i;
    Big square;
    Big cos_t;
    bool total = false;

  private:
    Big ReflectedShare(const Big& a, const Big& b) const {
        if (total || n1 == n2) {
            return total ? 1 : 0;
        }
        const Big amplitude = (a - b) / (a + b);
        return amplitude * amplitude;
    }
    Big TransmittedShare(const Big& a, const Big& b) const {
        if (total || n1 == n2) {
            return total ? 0 : 1;
        }
        // 4 n1 cos_i n2 cos_t of both polarisations, over the square of its own sum.
        return Big(4) * n1 * cos_i * n2 * cos_t / ((a + b) * (a + b));
    }
};

}  // namespace etalon::oracle
