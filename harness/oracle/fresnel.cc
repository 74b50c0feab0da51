#include "oracle/fresnel.h"

namespace etalon::oracle {
namespace {

ETALON_BATCH void ReflectanceSp(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Shares shares = FresnelShares(in[0][row], in[1][row], {in[2][row], 0});
        out[0][row] = shares.s_reflected;
        out[1][row] = shares.p_reflected;
    }
}

ETALON_BATCH void Reflectance(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Shares shares = FresnelShares(in[0][row], in[1][row], {in[2][row], 0});
        out[0][row] = 0.5 * (shares.s_reflected + shares.p_reflected);
    }
}

ETALON_BATCH void Transmittance(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Shares shares = FresnelShares(in[0][row], in[1][row], {in[2][row], 0});
        out[0][row] = 0.5 * (shares.s_transmitted + shares.p_transmitted);
    }
}

ETALON_BATCH void Schlick(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double n1 = in[0][row];
        const double n2 = in[1][row];
        const double c = in[2][row];
        const double square = TransmittedSquare(n1, n2, {c, 0});
        const double cos_t = std::sqrt(square < 0 ? 0.0 : square) / n2;
        const double ratio = n1 / n2;
        const double rest = n1 > n2 ? ratio * ratio * ((1 - c) * (1 + c)) / (1 + cos_t) : 1 - c;
        const double amplitude = (n2 - n1) / (n2 + n1);
        const double normal = amplitude * amplitude;
        const double approximation = normal + (1 - normal) * (rest * rest) * (rest * rest) * rest;
        out[0][row] = square < 0 ? 1 : approximation;
    }
}

ETALON_BATCH void BrewsterCosine(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double n1 = in[0][row];
        const double n2 = in[1][row];
        out[0][row] = n1 / std::sqrt(n1 * n1 + n2 * n2);
    }
}

}  // namespace

std::vector<Function> FresnelFunctions() {
    const std::vector<Parameter> incidence = {{"n1", 1}, {"n2", 1}, {"cos_i", 1}};
    return {
        {"fresnel.reflectance_sp", incidence, 2, ReflectanceSp, 1e-14, 1e-16},
        {"fresnel.reflectance", incidence, 1, Reflectance, 5e-15, 0},
        {"fresnel.transmittance", incidence, 1, Transmittance, 4e-15, 0},
        {"fresnel.schlick", incidence, 1, Schlick, 4e-15, 0},
        {"fresnel.brewster_cosine", {{"n1", 1}, {"n2", 1}}, 1, BrewsterCosine, 1e-15, 0},
    };
}

}  // namespace etalon::oracle
