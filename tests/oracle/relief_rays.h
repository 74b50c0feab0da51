// Random rays of a relief in bands of angles, as the cases have them.
#pragma once

#include <cmath>
#include <numbers>

#include "bound.h"

namespace etalon::oracle {

inline constexpr double kTexturePerHeight = 0.1;  // 12.8 texels of 128

struct Band {
    double from;  // degrees from the box's normal
    double to;
};
inline constexpr Band kBands[] = {{0, 45}, {45, 70}, {70, 85}, {85, 89}};

// start, velocity and end: seven floats. From the box's top down to its floor.
inline Row FallingRay(Random& random, const Band& band) {
    const double angle = random.Between(band.from, band.to) * std::numbers::pi / 180;
    const double azimuth = random.Between(0, 2 * std::numbers::pi);
    const double flat = kTexturePerHeight * std::sin(angle);
    const auto velocity_z = static_cast<float>(-std::cos(angle));
    return {random.Float(0, 1),
            random.Float(0, 1),
            0.5,
            static_cast<float>(flat * std::cos(azimuth)),
            static_cast<float>(flat * std::sin(azimuth)),
            velocity_z,
            static_cast<float>(-1.0 / velocity_z)};
}

// From anywhere in the box, in any direction, level ones and axes among them.
inline Row AnyRay(Random& random) {
    double v[3] = {random.Between(-1, 1), random.Between(-1, 1), random.Between(-1, 1)};
    v[random.Below(3)] *= random.Below(4) == 0 ? 0 : 1;
    v[2] *= random.Below(2) == 0 ? 0.05 : 1;
    const double length = std::hypot(v[0], v[1], v[2]) + 1e-6;
    const double scale = kTexturePerHeight / length;
    const double z = random.Float(-0.5, 0.5);
    const double room = v[2] < 0 ? z + 0.5 : 0.5 - z;
    const double way = v[2] == 0 ? 10 : std::fmin(10, room * length / std::fabs(v[2]));
    return {random.Float(-1, 2),
            random.Float(-1, 2),
            z,
            static_cast<float>(v[0] * scale),
            static_cast<float>(v[1] * scale),
            static_cast<float>(v[2] / length),
            static_cast<float>(way)};
}

// One component of a function at every row.
inline std::vector<double> Evaluate(std::string_view name, const std::vector<Row>& rows) {
    const Function* const function = FindFunction(name);
    EXPECT_NE(function, nullptr) << name;
    const std::size_t inputs = rows.front().size();
    std::vector<std::vector<double>> columns(inputs, Row(rows.size()));
    std::vector<const double*> in;
    for (std::size_t k = 0; k < inputs; ++k) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            columns[k][row] = rows[row][k];
        }
        in.push_back(columns[k].data());
    }
    std::vector<double> result(rows.size());
    double* const out = result.data();
    function->evaluate(in.data(), &out, rows.size());
    return result;
}

inline double EvaluateOne(std::string_view name, const Row& row) {
    return Evaluate(name, {row}).front();
}

}  // namespace etalon::oracle
