// The unit in the last place of binary32, as IEEE and the Vulkan specification define it.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace etalon {

// Distance of the two finite floats nearest around `x` (a <= x <= b, a != b); `x` need not be a
// float. At a power of two it is the distance to the larger neighbour in magnitude; 2^-149 below
// 2^-126 and at zero; beyond the largest float, and for infinities, 2^104. NaN for NaN.
inline double Ulp(double x) {
    if (x != x) {
        return x;
    }
    const double binade = std::clamp(std::fabs(x), 0x1p-126, 0x1p127);
    const std::uint64_t power = std::bit_cast<std::uint64_t>(binade) & 0x7ff0000000000000u;
    return std::bit_cast<double>(power - (std::uint64_t{23} << 52));
}

// |value - truth| in ulp(truth). 0 where both are the same infinity, or both NaN; infinity where
// one of them alone is NaN or infinite. An infinite `value` of a truth that is finite is infinitely
// far, whatever the rule allows.
double UlpError(float value, double truth);

// Floats in numeric order as integers: adjacent floats differ by one, -0 and +0 by one as well. NaN
// is not ordered.
std::int64_t OrderedBits(float value);
float FromOrderedBits(std::int64_t ordered);

float FromBits(std::uint32_t bits);
std::uint32_t ToBits(float value);

// A subnormal becomes the zero of its sign; all else stays.
float Flush(float value);
double FlushBinary32(double value);

}  // namespace etalon
