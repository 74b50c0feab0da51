#include "numeric/ulp.h"

#include <cmath>
#include <limits>

namespace etalon {

double UlpError(float value, double truth) {
    if (std::isfinite(value) && std::isfinite(truth)) {
        return std::fabs(static_cast<double>(value) - truth) / Ulp(truth);
    }
    const bool same = std::isnan(truth) ? std::isnan(value) : static_cast<double>(value) == truth;
    return same ? 0 : std::numeric_limits<double>::infinity();
}

float Flush(float value) {
    return std::fabs(value) < std::numeric_limits<float>::min() ? std::copysign(0.0f, value)
                                                                : value;
}

double FlushBinary32(double value) {
    return std::fabs(value) < std::numeric_limits<float>::min() ? std::copysign(0.0, value) : value;
}

}  // namespace etalon
