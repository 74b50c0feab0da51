#include "oracle/intensity.h"

#include "oracle/batch.h"
#include "oracle/fresnel.h"

namespace etalon::oracle {
namespace {

ETALON_BATCH void Refraction(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Pair projection = Dot(in, in + 3, row);
        const bool beyond = projection.high < -1 || (projection.high == -1 && projection.low < 0);
        const Pair c = beyond ? Pair{1, 0} : Pair{-projection.high, -projection.low};
        const Shares shares = FresnelShares(in[6][row], in[7][row], c);
        const double transmitted = 0.5 * (shares.s_transmitted + shares.p_transmitted);
        out[0][row] = projection.high > 0 ? 0 : transmitted;
    }
}

}  // namespace

std::vector<Function> IntensityFunctions() {
    return {
        {"intensity.refraction",
         {{"normal", 3}, {"light_dir", 3}, {"n1", 1}, {"n2", 1}},
         1,
         Refraction,
         5e-15,
         1e-15},
    };
}

}  // namespace etalon::oracle
