#include "oracle/relief_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace etalon::oracle {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kNearTie = 0x1p-20;

double FirstWay(double translucent, double solid) {
    if (std::isnan(translucent) || std::isnan(solid)) {
        return kNan;
    }
    if (translucent < 0 || solid < 0) {
        const double other = std::max(translucent, solid);
        return other < 0 ? -1 : other;
    }
    return std::min(translucent, solid);
}

double FirstLayer(double translucent, double solid) {
    const double first = FirstWay(translucent, solid);
    if (std::isnan(first)) {
        return kNan;
    }
    if (first < 0) {
        return 0;
    }
    const double apart = std::fabs(translucent - solid);
    if (apart > 0 && apart < kNearTie && std::min(translucent, solid) >= 0) {
        return kNan;
    }
    return first == solid ? 2 : 1;
}

template <double (*kFunction)(double, double)>
void Evaluate(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        out[0][row] = kFunction(in[0][row], in[1][row]);
    }
}

}  // namespace

std::vector<Function> ReliefLayerFunctions() {
    return {
        {"relief.first", {{"t_translucent", 1}, {"t_solid", 1}}, 1, Evaluate<FirstWay>, 0, 0},
        {"relief.first_layer",
         {{"t_translucent", 1}, {"t_solid", 1}},
         1,
         Evaluate<FirstLayer>,
         0,
         0},
    };
}

}  // namespace etalon::oracle
