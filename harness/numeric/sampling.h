// Deterministic samples of floats and directions. Every random choice is a pure function of a seed
// and an index, so that any one sample can be had again without the others.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace etalon {

std::uint64_t Mix(std::uint64_t seed, std::uint64_t index);
// The seed of a named stream.
std::uint64_t Mix(std::uint64_t seed, std::string_view name);
// In [0, 1).
double Uniform(std::uint64_t seed, std::uint64_t index);

enum class Spacing : std::uint8_t { kBits, kLinear, kLog };

// One random float out of each of `count` equal strata of [low, high], ascending; equal in the
// order of the floats (kBits), in value, or in the logarithm of the value (then low and high have
// one sign and are not zero). The bounds must be numbers, low <= high, finite except for kBits.
std::vector<float> Strata(Spacing spacing, float low, float high, std::uint64_t count,
                          std::uint64_t seed);

// What no sample of [low, high] should miss, ascending: the two ends and, for kBits, where inside
// (-0 lies before 0): the zeros, both signs of the smallest and largest subnormal and of the
// smallest normal, and 1 with its neighbours.
std::vector<float> Landmarks(Spacing spacing, float low, float high);

// Ascending in the order of the floats (-0 before 0), without doubles; NaN must not occur.
void SortUnique(std::vector<float>& values);

// The float nearest to `value` and two on either side that lie in [low, high]; none for a NaN.
std::vector<float> Neighbourhood(double value, float low, float high);

// A random order, decided by the seed.
void Shuffle(std::span<float> values, std::uint64_t seed);

// Sample `index` of `count` unit vectors of 2 or 3 components, spread evenly over the circle or
// sphere. The components are rounded to float.
void Direction(std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::span<float> out);

// Sample `index` of `count` unit vectors n with dot(against, n) <= 0 as an exact sum of the floats.
// The index 0 is the normal incidence, n = -against normalised; 1 to 3 are nearly grazing.
void OpposedDirection(std::span<const float> against, std::uint64_t index, std::uint64_t count,
                      std::uint64_t seed, std::span<float> out);
inline constexpr std::uint64_t kOpposedLandmarks = 4;

}  // namespace etalon
