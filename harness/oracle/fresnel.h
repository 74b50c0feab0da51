// The shares of light that an interface of two dielectrics reflects and transmits.
//
// Domain of the bounds: n1, n2 floats in [2^-10, 2^10], cos_i a float in [0, 1]; at total internal
// reflection everything is reflected; at n1 = n2 nothing is, also at cos_i = 0.
//
//   fresnel.reflectance_sp(n1, n2, cos_i)  (R_s, R_p), the two polarisations
//   fresnel.reflectance(n1, n2, cos_i)     their mean
//   fresnel.transmittance(n1, n2, cos_i)   1 - reflectance, without the cancellation
//   fresnel.schlick(n1, n2, cos_i)         Schlick's approximation, its cosine on the thin side
//   fresnel.brewster_cosine(n1, n2)        where R_p = 0: n1 / sqrt(n1^2 + n2^2)
#pragma once

#include <vector>

#include "oracle/batch.h"
#include "oracle/function.h"
#include "oracle/snell.h"

namespace etalon::oracle {

struct Shares {
    double s_reflected;
    double p_reflected;
    double s_transmitted;
    double p_transmitted;
};

// All are relatively accurate but p_reflected near its zero. The cosine c is in [0, 1].
ETALON_STEP Shares FresnelShares(double n1, double n2, Pair c) {
    const double x = n1 * c.high;
    const double square = TransmittedSquare(n1, n2, c);
    const double g = std::sqrt(square < 0 ? 0.0 : square);
    // No branches, so that loops are vectorised: at total internal reflection g = 0 makes both
    // amplitudes 1 once s is limited to it. kTiny is below every true square, and serves 0 / 0.
    constexpr double kTiny = 1e-200;
    const double s_squared = (x + g) * (x + g) + kTiny;
    const double p_sum = n1 * g + n2 * n2 * c.high;
    const double p_squared = p_sum * p_sum + kTiny;
    const double along = c.high * g;
    const double across = n1 * ((1 - c.high) * (1 + c.high));
    const double amplitude = std::abs((n2 - n1) * (n2 + n1)) / s_squared;
    const double s_amplitude = amplitude < 1 ? amplitude : 1;
    const double p_amplitude = s_amplitude * ((along - across) / (along + across));
    const double s_transmitted = 4 * x * g / s_squared;
    const double p_transmitted = 4 * x * g * (n2 * n2) / p_squared;
    return {s_amplitude * s_amplitude, p_amplitude * p_amplitude, n1 == n2 ? 1 : s_transmitted,
            n1 == n2 ? 1 : p_transmitted};
}

std::vector<Function> FresnelFunctions();

}  // namespace etalon::oracle
