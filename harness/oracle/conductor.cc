#include "oracle/conductor.h"

#include <complex>

namespace etalon::oracle {
namespace {

using Complex = std::complex<double>;

// Fresnel's equations as they stand, in complex numbers.
void Reflectances(const double* const* in, std::size_t row, double* s, double* p) {
    const double n1 = in[0][row];
    const Complex index(in[1][row], in[2][row]);
    const double c = in[3][row];
    const Complex sine = n1 * std::sqrt((1 - c) * (1 + c)) / index;
    const Complex cos_t = std::sqrt((1.0 - sine) * (1.0 + sine));
    *s = std::norm((n1 * c - index * cos_t) / (n1 * c + index * cos_t));
    *p = std::norm((n1 * cos_t - index * c) / (n1 * cos_t + index * c));
}

void ReflectanceSp(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        Reflectances(in, row, &out[0][row], &out[1][row]);
    }
}

void Reflectance(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        double s = 0;
        double p = 0;
        Reflectances(in, row, &s, &p);
        out[0][row] = 0.5 * (s + p);
    }
}

}  // namespace

std::vector<Function> ConductorFunctions() {
    const std::vector<Parameter> incidence = {{"n1", 1}, {"n2", 1}, {"k2", 1}, {"cos_i", 1}};
    return {
        {"conductor.reflectance_sp", incidence, 2, ReflectanceSp, 1e-14, 0},
        {"conductor.reflectance", incidence, 1, Reflectance, 1e-14, 0},
    };
}

}  // namespace etalon::oracle
