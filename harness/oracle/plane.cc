#include "oracle/plane.h"

#include <limits>

#include "oracle/batch.h"

namespace etalon::oracle {
namespace {

constexpr std::size_t kDimensions = 3;

ETALON_STEP double Quotient(Pair numerator, Pair denominator) {
    const double quotient = (numerator.high + numerator.low) / (denominator.high + denominator.low);
    return denominator.high == 0 ? std::numeric_limits<double>::quiet_NaN() : quotient;
}

ETALON_BATCH void RayParameter(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        Pair distance = {0, 0};
        for (std::size_t k = 0; k < kDimensions; ++k) {
            const double normal = in[3 * kDimensions + k][row];
            const Pair way = ExactSum(in[2 * kDimensions + k][row], -in[k][row]);
            Pair part = ExactProduct(way.high, normal);
            part.low += way.low * normal;
            distance = Add(distance, part);
        }
        out[0][row] = Quotient(distance, Dot(in + kDimensions, in + 3 * kDimensions, row));
    }
}

ETALON_BATCH void FlatLayer(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = Quotient(ExactSum(in[0][row], -in[3][row]), {in[6][row], 0});
    }
}

}  // namespace

std::vector<Function> PlaneFunctions() {
    return {
        {"plane.ray_parameter",
         {{"i", 3}, {"v", 3}, {"s", 3}, {"n", 3}},
         1,
         RayParameter,
         1e-15,
         1e-20},
        {"plane.flat_layer", {{"h", 1}, {"i", 3}, {"v", 3}}, 1, FlatLayer, 1e-15, 0},
    };
}

}  // namespace etalon::oracle
