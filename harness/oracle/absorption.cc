#include "oracle/absorption.h"

#include <numbers>

#include "oracle/batch.h"

namespace etalon::oracle {
namespace {

// 2^(-d / h) for an exact d; the rounding of the quotient is made good.
ETALON_STEP double Halvings(double d, double h) {
    const double y = d / h;
    const double residual = std::fma(-y, h, d) / h;
    return std::exp2(-y) * (1 - std::numbers::ln2 * residual);
}

ETALON_BATCH void Absorbed(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = -std::expm1(-std::numbers::ln2 * (in[0][row] / in[1][row]));
    }
}

ETALON_BATCH void Transmitted(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = Halvings(in[0][row], in[1][row]);
    }
}

ETALON_BATCH void Hued(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double transmitted = Halvings(in[0][row], in[1][row]);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double absorb = in[2 + channel][row];
            out[channel][row] = (1 - absorb) + absorb * transmitted;
        }
    }
}

ETALON_BATCH void BeerLambert(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            out[channel][row] = Halvings(in[0][row] * in[2 + channel][row], in[1][row]);
        }
    }
}

}  // namespace

std::vector<Function> AbsorptionFunctions() {
    const std::vector<Parameter> way = {{"d", 1}, {"half_distance", 1}};
    const std::vector<Parameter> hued = {{"d", 1}, {"half_distance", 1}, {"absorb_color", 3}};
    return {
        {"absorption.absorbed", way, 1, Absorbed, 1e-15, 0},
        {"absorption.transmitted", way, 1, Transmitted, 1e-15, 0},
        {"absorption.hued", hued, 3, Hued, 1e-15, 0},
        {"absorption.beer_lambert", hued, 3, BeerLambert, 1e-15, 0},
    };
}

}  // namespace etalon::oracle
