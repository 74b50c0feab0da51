#include "oracle/relief_fields.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

namespace etalon::oracle {
namespace {

constexpr double kUnit = 0x1p-12;  // all heights are multiples of it
constexpr int kSize = 128;
constexpr int kTinySize = 8;
static_assert(std::has_single_bit(unsigned{kSize}) && std::has_single_bit(unsigned{kTinySize}));

// sin(2 pi x / kSize)
double Wave(int x) {
    return std::sin(2 * std::numbers::pi * (x % kSize) / kSize);
}

double Smooth(int i, int j) {
    return 0.132 * Wave(4 * i) * Wave(3 * j + 32) + 0.118 * Wave(2 * i + 5 * j) +
           0.073 * Wave(7 * i - 2 * j + 7 * kSize);
}

// Bricks of 16 x 8 texels, every second row moved by half a brick, with joints of two texels.
double Bricks(int i, int j) {
    const int row = j / 8;
    const bool joint = (i + (row % 2) * 8) % 16 < 2 || j % 8 < 2;
    return joint ? -0.075 : 0.3;
}

// 0 .. 1, from the integers alone (the mixing of MurmurHash3).
double Random(std::uint32_t i, std::uint32_t j, std::uint32_t octave) {
    std::uint32_t x = (i * 0x9e3779b1u) ^ std::rotl(j * 0x85ebca77u, 13) ^ (octave * 0xc2b2ae3du);
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    x ^= x >> 16;
    return x / 4294967295.0;
}

// Random values every `period` texels and smoothstep between them.
double Octave(int i, int j, int period, unsigned octave) {
    const auto lattice = [&](int column, int row) {
        const int cells = kSize / period;
        return Random(static_cast<unsigned>(column % cells), static_cast<unsigned>(row % cells),
                      octave);
    };
    const auto fade = [period](int x) {
        const double f = static_cast<double>(x % period) / period;
        return f * f * (3 - 2 * f);
    };
    const int column = i / period;
    const int row = j / period;
    const double lower = std::lerp(lattice(column, row), lattice(column + 1, row), fade(i));
    const double upper = std::lerp(lattice(column, row + 1), lattice(column + 1, row + 1), fade(i));
    return std::lerp(lower, upper, fade(j));
}

double Noise(int i, int j) {
    return -0.45 + 0.7 * Octave(i, j, 16, 1) + 0.234 * Octave(i, j, 4, 2);
}

double Ridges(int i, int j) {
    return i % 32 == 5 || j % 32 == 11 ? 0.4 : -0.4;
}

double Steps(int i, int) {
    const int stair = i / 8;  // 0 .. 15
    return -0.43 + 0.11 * (stair < 8 ? stair : 15 - stair);
}

double Spike(int i, int j) {
    return i == 64 && j == 64 ? 0.5 : -0.43;
}

double Flat(int, int) {
    return -0.125;
}

double Plane(int, int) {
    return -0.137;
}

// Up and down again.
double Ramp(int i, int) {
    constexpr int kHalf = kSize / 2;
    const int steps = i < kHalf ? i : kSize - i;
    return -0.42 + 0.84 * steps / kHalf;
}

template <int kWaves>
double Sine(int i, int) {
    return 0.4 * Wave(kWaves * i);
}

double Ripples(int i, int) {
    return -0.125 + 0.02 * Wave(4 * i);
}

// Four caps 48 texels wide and 0.75 high, of spheres.
double Cap(int i, int j) {
    constexpr double kTexelsPerHeight = 12.8;
    constexpr double kFoot = 24 / kTexelsPerHeight;
    constexpr double kHigh = 0.75;
    constexpr double kBall = (kFoot * kFoot + kHigh * kHigh) / (2 * kHigh);
    const double x = (i % 64 - 32) / kTexelsPerHeight;
    const double y = (j % 64 - 32) / kTexelsPerHeight;
    const double square = kBall * kBall - x * x - y * y;
    const double above = square > 0 ? std::sqrt(square) - (kBall - kHigh) : 0;
    return -0.38 + std::max(above, 0.0);
}

double Film(int i, int j) {
    return 0.45 + 0.3 * Wave(3 * i + j) * Wave(2 * j + 16) + 0.1 * Wave(5 * i - j + kSize);
}

double Tiny(int i, int j) {
    return -0.4375 + 0.875 * Random(static_cast<unsigned>(i), static_cast<unsigned>(j), 3);
}

template <std::size_t kField>
void Texel(const double* const* in, double* const* out, std::size_t rows) {
    const HeightField& field = HeightFields()[kField];
    for (std::size_t row = 0; row < rows; ++row) {
        const double i = in[0][row];
        const double j = in[1][row];
        constexpr double kFar = 0x1p53;  // integers, as far as binary64 has all of them
        out[0][row] = std::fabs(i) <= kFar && std::fabs(j) <= kFar
                          ? field.Texel(static_cast<std::int64_t>(std::floor(i)),
                                        static_cast<std::int64_t>(std::floor(j)))
                          : std::numeric_limits<double>::quiet_NaN();
    }
}

}  // namespace

HeightField::HeightField(std::string_view name, int size, double (*height)(int i, int j))
    : name_(name), size_(size) {
    for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
            texels_.push_back(std::clamp(std::round(height(i, j) / kUnit) * kUnit, -0.5, 0.5));
        }
    }
}

std::span<const HeightField> HeightFields() {
    static const std::array<HeightField, kHeightFields> fields = {{
        {"smooth", kSize, Smooth},
        {"bricks", kSize, Bricks},
        {"noise", kSize, Noise},
        {"ridges", kSize, Ridges},
        {"steps", kSize, Steps},
        {"spike", kSize, Spike},
        {"flat", kSize, Flat},
        {"film", kSize, Film},
        {"tiny", kTinySize, Tiny},
        {"plane", kSize, Plane},
        {"ramp", kSize, Ramp},
        {"sine_one", kSize, Sine<1>},
        {"sine_four", kSize, Sine<4>},
        {"sine_sixteen", kSize, Sine<16>},
        {"cap", kSize, Cap},
        {"ripples", kSize, Ripples},
    }};
    return fields;
}

std::vector<Function> ReliefFieldFunctions() {
    static const auto names = [] {
        std::array<std::string, kHeightFields> all;
        std::ranges::transform(HeightFields(), all.begin(), [](const HeightField& field) {
            return "relief.texel_" + std::string(field.name());
        });
        return all;
    }();
    return []<std::size_t... kField>(std::index_sequence<kField...>) {
        return std::vector<Function>{
            {names[kField], {{"i", 1}, {"j", 1}}, 1, Texel<kField>, 0, 0}...};
    }
    (std::make_index_sequence<kHeightFields>());
}

}  // namespace etalon::oracle
