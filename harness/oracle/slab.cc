#include "oracle/slab.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/batch.h"
#include "oracle/fresnel.h"

namespace etalon::oracle {
namespace {

// Adds half of one polarisation's shares. `halvings` is the way in half distances.
void AddPolarisation(double reflected, double transmitted, double halvings, double* const* out,
                     std::size_t row) {
    if (transmitted == 0) {
        out[0][row] += 0.5;
        return;
    }
    const double left = std::exp2(-halvings);
    const double loss = -std::expm1(-2 * std::numbers::ln2 * halvings);
    // 1 - (reflected left)^2, which would cancel.
    const double rest = transmitted * (1 + reflected) + reflected * reflected * loss;
    const double through = transmitted / rest * transmitted * left;
    out[0][row] += 0.5 * (reflected + through * reflected * left);
    out[1][row] += 0.5 * through;
}

void SlabShares(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double n1 = in[0][row];
        const double n2 = in[1][row];
        const Pair cosine = {in[2][row], 0};
        const Shares face = FresnelShares(n1, n2, cosine);
        const double square = TransmittedSquare(n1, n2, cosine);
        const double cos_t = std::max(std::sqrt(std::max(square, 0.0)) / n2, 0x1p-12);
        const double halvings = in[3][row] / cos_t / in[4][row];
        out[0][row] = 0;
        out[1][row] = 0;
        AddPolarisation(face.s_reflected, face.s_transmitted, halvings, out, row);
        AddPolarisation(face.p_reflected, face.p_transmitted, halvings, out, row);
    }
}

}  // namespace

std::vector<Function> SlabFunctions() {
    return {
        {"slab.shares",
         {{"n1", 1}, {"n2", 1}, {"cos_i", 1}, {"thickness", 1}, {"half_distance", 1}},
         2,
         SlabShares,
         1e-14,
         1e-15},
    };
}

}  // namespace etalon::oracle
