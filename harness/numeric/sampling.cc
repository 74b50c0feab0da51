#include "numeric/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/check.h"
#include "base/hash.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr float kSmallest = std::numeric_limits<float>::denorm_min();
constexpr float kNormal = std::numeric_limits<float>::min();

bool Within(float value, float low, float high) {
    const std::int64_t ordered = OrderedBits(value);
    return OrderedBits(low) <= ordered && ordered <= OrderedBits(high);
}

// Error-free: sum + error == a + b (Knuth).
void TwoSum(double a, double b, double& sum, double& error) {
    sum = a + b;
    const double second = sum - a;
    error = (a - (sum - second)) + (b - second);
}

// The sign of dot(a, b), exactly: a product of two floats is a double, and the sum of three doubles
// is kept as an expansion whose last component that is not zero has its sign (Shewchuk 1997, 2.2).
double DotSign(std::span<const float> a, std::span<const float> b) {
    double product[3] = {};
    for (std::size_t k = 0; k < a.size(); ++k) {
        product[k] = static_cast<double>(a[k]) * b[k];
    }
    double high = 0;
    double low = 0;
    TwoSum(product[0], product[1], high, low);
    double carry = 0;
    double lowest = 0;
    TwoSum(low, product[2], carry, lowest);
    double highest = 0;
    double middle = 0;
    TwoSum(high, carry, highest, middle);
    return highest != 0 ? highest : (middle != 0 ? middle : lowest);
}

void Store(const double (&vector)[3], std::span<float> out) {
    double length = 0;
    for (std::size_t k = 0; k < out.size(); ++k) {
        length = std::hypot(length, vector[k]);
    }
    for (std::size_t k = 0; k < out.size(); ++k) {
        out[k] = static_cast<float>(vector[k] / length);
    }
}

}  // namespace

std::uint64_t Mix(std::uint64_t seed, std::uint64_t index) {
    // splitmix64 (Steele, Lea and Flood 2014), started at the seed and moved on to the index.
    std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

std::uint64_t Mix(std::uint64_t seed, std::string_view name) {
    Hash hash;
    hash.Add(name);
    return Mix(Mix(seed, hash.value()), 0);
}

double Uniform(std::uint64_t seed, std::uint64_t index) {
    return static_cast<double>(Mix(seed, index) >> 11) * 0x1p-53;
}

std::vector<float> Strata(Spacing spacing, float low, float high, std::uint64_t count,
                          std::uint64_t seed) {
    ETALON_CHECK(low <= high && count <= (1u << 24));
    const std::int64_t first = OrderedBits(low);
    const auto floats = static_cast<std::uint64_t>(OrderedBits(high) - first + 1);
    const double sign = low < 0 ? -1 : 1;
    std::vector<float> samples(count);
    for (std::uint64_t k = 0; k < count; ++k) {
        if (spacing == Spacing::kBits) {
            const std::uint64_t begin = floats * k / count;
            const std::uint64_t size = std::max<std::uint64_t>(floats * (k + 1) / count - begin, 1);
            samples[k] =
                FromOrderedBits(first + static_cast<std::int64_t>(begin + Mix(seed, k) % size));
            continue;
        }
        const double share =
            (static_cast<double>(k) + Uniform(seed, k)) / static_cast<double>(count);
        double value = low + (static_cast<double>(high) - low) * share;
        if (spacing == Spacing::kLog) {
            const double from = std::log(std::fabs(static_cast<double>(low)));
            const double to = std::log(std::fabs(static_cast<double>(high)));
            value = sign * std::exp(from + (to - from) * share);
        }
        samples[k] = std::clamp(static_cast<float>(value), low, high);
    }
    return samples;
}

std::vector<float> Landmarks(Spacing spacing, float low, float high) {
    std::vector<float> values = {low, high};
    if (spacing == Spacing::kBits) {
        const float below_normal = std::nextafter(kNormal, 0.0f);
        for (const float value :
             {-kNormal, -below_normal, -kSmallest, -0.0f, 0.0f, kSmallest, below_normal, kNormal,
              std::nextafter(1.0f, 0.0f), 1.0f, std::nextafter(1.0f, 2.0f)}) {
            if (Within(value, low, high)) {
                values.push_back(value);
            }
        }
    }
    SortUnique(values);
    return values;
}

void SortUnique(std::vector<float>& values) {
    std::sort(values.begin(), values.end(),
              [](float a, float b) { return OrderedBits(a) < OrderedBits(b); });
    const auto same = [](float a, float b) { return ToBits(a) == ToBits(b); };
    values.erase(std::unique(values.begin(), values.end(), same), values.end());
}

std::vector<float> Neighbourhood(double value, float low, float high) {
    std::vector<float> values;
    if (std::isnan(value)) {
        return values;
    }
    // Steps by value, not by order: the floats next to 0 are the two subnormals, not -0.
    float below = static_cast<float>(value);
    values.push_back(below);
    float above = below;
    for (int step = 0; step < 2; ++step) {
        below = std::nextafter(below, -std::numeric_limits<float>::infinity());
        above = std::nextafter(above, std::numeric_limits<float>::infinity());
        values.push_back(below);
        values.push_back(above);
    }
    std::erase_if(values, [low, high](float v) { return !Within(v, low, high); });
    SortUnique(values);
    return values;
}

void Shuffle(std::span<float> values, std::uint64_t seed) {
    for (std::size_t k = values.size(); k > 1; --k) {
        std::swap(values[k - 1], values[Mix(seed, k) % k]);
    }
}

void Direction(std::uint64_t index, std::uint64_t count, std::uint64_t seed, std::span<float> out) {
    ETALON_CHECK(out.size() == 2 || out.size() == 3);
    const double turn = 2 * std::numbers::pi;
    const double share =
        (static_cast<double>(index) + Uniform(seed, 2 * index)) / static_cast<double>(count);
    if (out.size() == 2) {
        Store({std::cos(turn * share), std::sin(turn * share), 0}, out);
        return;
    }
    // Equal areas between planes of equal distance, turned by the golden ratio from one to the
    // next.
    const double z = 1 - 2 * share;
    const double radius = std::sqrt((1 - z) * (1 + z));
    const double angle =
        turn * (std::fmod(static_cast<double>(index) / std::numbers::phi, 1.0) +
                Uniform(seed, 2 * index + 1) / std::sqrt(1.0 + static_cast<double>(count)));
    Store({radius * std::cos(angle), radius * std::sin(angle), z}, out);
}

void OpposedDirection(std::span<const float> against, std::uint64_t index, std::uint64_t count,
                      std::uint64_t seed, std::span<float> out) {
    ETALON_CHECK(against.size() == out.size());
    double toward[3] = {};
    double length = 0;
    for (std::size_t k = 0; k < against.size(); ++k) {
        toward[k] = against[k];
        length = std::hypot(length, toward[k]);
    }
    Direction(index, std::max(count, index + 1), seed, out);
    if (index < kOpposedLandmarks && length > 0) {
        double across[3] = {out[0], out[1], out.size() == 3 ? out[2] : 0.0};
        double along = 0;
        for (std::size_t k = 0; k < against.size(); ++k) {
            toward[k] /= length;
            along += toward[k] * across[k];
        }
        double rest = 0;
        for (std::size_t k = 0; k < against.size(); ++k) {
            across[k] -= along * toward[k];
            rest = std::hypot(rest, across[k]);
        }
        // The cosine of each landmark's angle of incidence.
        constexpr double kCosines[kOpposedLandmarks] = {1, 1e-7, 1e-4, 1e-2};
        const double cosine = kCosines[index];
        const double sine = std::sqrt((1 - cosine) * (1 + cosine));
        double opposed[3] = {};
        for (std::size_t k = 0; k < against.size(); ++k) {
            opposed[k] = -cosine * toward[k] + (sine > 0 && rest > 0 ? sine * across[k] / rest : 0);
        }
        Store(opposed, out);
    }
    if (DotSign(against, out) > 0) {
        for (float& component : out) {
            component = -component;
        }
    }
}

}  // namespace etalon
