#include "oracle/snell.h"

#include <algorithm>
#include <limits>

namespace etalon::oracle {
namespace {

constexpr std::size_t kDimensions = 3;

ETALON_BATCH void CosTransmitted(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double square = TransmittedSquare(in[0][row], in[1][row], {in[2][row], 0});
        out[0][row] = std::sqrt(std::max(square, 0.0)) / in[1][row];
    }
}

ETALON_BATCH void CriticalCosine(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double n1 = in[0][row];
        const double n2 = in[1][row];
        out[0][row] = n1 > n2 ? std::sqrt((n1 - n2) * (n1 + n2)) / n1
                              : std::numeric_limits<double>::quiet_NaN();
    }
}

ETALON_BATCH void TotalInternalReflection(const double* const* in, double* const* out,
                                          std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double square = TransmittedSquare(in[0][row], in[1][row], {in[2][row], 0});
        out[0][row] = square < 0 ? 1 : 0;
    }
}

ETALON_BATCH void Reflect(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double projection = Dot(in, in + kDimensions, row).high;
        for (std::size_t k = 0; k < kDimensions; ++k) {
            out[k][row] = std::fma(-2 * projection, in[kDimensions + k][row], in[k][row]);
        }
    }
}

// One ray of one row: in holds v and n.
ETALON_STEP void RefractRow(const double* const* in, double n1, double n2, double* const* out,
                            std::size_t row) {
    const Pair projection = Dot(in, in + kDimensions, row);
    const double side = projection.high > 0 ? -1 : 1;
    Pair c = {-side * projection.high, -side * projection.low};
    if (c.high > 1 || (c.high == 1 && c.low > 0)) {
        c = {1, 0};
    }
    const double square = TransmittedSquare(n1, n2, c);
    const double sum = n1 * c.high + std::sqrt(std::max(square, 0.0));
    const double along_normal = n1 == n2 ? 0 : side * ((n2 - n1) * (n2 + n1) / sum);
    for (std::size_t k = 0; k < kDimensions; ++k) {
        const double bent = (n1 * in[k][row] - along_normal * in[kDimensions + k][row]) / n2;
        out[k][row] = square < 0 ? 0 : bent;
    }
}

ETALON_BATCH void Refract(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        RefractRow(in, in[6][row], in[7][row], out, row);
    }
}

ETALON_BATCH void RefractRgb(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            RefractRow(in, in[6 + channel][row], in[9 + channel][row], out + kDimensions * channel,
                       row);
        }
    }
}

}  // namespace

std::vector<Function> SnellFunctions() {
    const std::vector<Parameter> incidence = {{"n1", 1}, {"n2", 1}, {"cos_i", 1}};
    return {
        {"snell.cos_transmitted", incidence, 1, CosTransmitted, 1e-15, 0},
        {"snell.critical_cosine", {{"n1", 1}, {"n2", 1}}, 1, CriticalCosine, 1e-15, 0},
        {"snell.total_internal_reflection", incidence, 1, TotalInternalReflection, 0, 0},
        {"snell.reflect", {{"v", 3}, {"n", 3}}, 3, Reflect, 0, 1e-15},
        {"snell.refract", {{"v", 3}, {"n", 3}, {"n1", 1}, {"n2", 1}}, 3, Refract, 0, 4e-15},
        {"snell.refract_rgb", {{"v", 3}, {"n", 3}, {"n1", 3}, {"n2", 3}}, 9, RefractRgb, 0, 4e-15},
    };
}

}  // namespace etalon::oracle
