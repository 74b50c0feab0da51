// The unit in the last place of binary32, as IEEE and the Vulkan specification define it.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace etalon {

// The least distance of two different finite floats a <= x <= b; `x` need not be a float. At a
// power of two it is the distance to the neighbour of smaller magnitude, half of the other one;
// 2^-149 up to 2^-125 and at zero; beyond the largest float, and for infinities, 2^104. NaN for
// NaN.
inline double Ulp(double x) {
    if (x != x) {
        return x;
    }
    const double magnitude = std::clamp(std::fabs(x), 0x1p-125, 0x1.fffffep127);
    // One bit less leaves a power of two in the binade below it, and all else where it is.
    const std::uint64_t power = (std::bit_cast<std::uint64_t>(magnitude) - 1) & 0x7ff0000000000000u;
    return std::bit_cast<double>(power - (std::uint64_t{23} << 52));
}

// |value - truth| in ulp(truth). 0 where both are the same infinity, or both NaN; infinity where
// one of them alone is NaN or infinite. An infinite `value` of a truth that is finite is infinitely
// far, whatever the rule allows.
double UlpError(float value, double truth);

inline float FromBits(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}
inline std::uint32_t ToBits(float value) {
    return std::bit_cast<std::uint32_t>(value);
}

// Floats in numeric order as integers: adjacent floats differ by one, -0 and +0 by one as well. NaN
// is not ordered.
inline std::int64_t OrderedBits(float value) {
    const std::uint32_t bits = ToBits(value);
    const auto magnitude = static_cast<std::int64_t>(bits & 0x7fffffffu);
    return (bits >> 31) != 0 ? -1 - magnitude : magnitude;
}
inline float FromOrderedBits(std::int64_t ordered) {
    return ordered < 0 ? FromBits(0x80000000u | static_cast<std::uint32_t>(-1 - ordered))
                       : FromBits(static_cast<std::uint32_t>(ordered));
}

// A subnormal becomes the zero of its sign; all else stays.
float Flush(float value);
double FlushBinary32(double value);

}  // namespace etalon
