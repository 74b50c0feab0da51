#include "numeric/ulp.h"

#include <bit>
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

std::int64_t OrderedBits(float value) {
    const std::uint32_t bits = ToBits(value);
    const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffu);
    return (bits >> 31) != 0 ? -1 - magnitude : magnitude;
}

float FromOrderedBits(std::int64_t ordered) {
    return ordered < 0 ? FromBits(0x80000000u | static_cast<std::uint32_t>(-1 - ordered))
                       : FromBits(static_cast<std::uint32_t>(ordered));
}

float FromBits(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

std::uint32_t ToBits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

float Flush(float value) {
    return std::fabs(value) < std::numeric_limits<float>::min() ? std::copysign(0.0f, value)
                                                                : value;
}

double FlushBinary32(double value) {
    return std::fabs(value) < std::numeric_limits<float>::min() ? std::copysign(0.0, value) : value;
}

}  // namespace etalon
