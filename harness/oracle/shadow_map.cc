#include "oracle/shadow_map.h"

#include <cmath>
#include <numbers>

namespace etalon::oracle {
namespace {

constexpr int kTexels = 128;
constexpr double kWidth = 8;
constexpr double kTexel = kWidth / kTexels;

struct Medium {
    double albedo;
    double real_depth;
    double virtual_depth;
    double extinction;
};

Medium MakeMedium(double absorbed, double scattered, double index) {
    const double total = absorbed + scattered;
    const double reflected = (-1.440 / index + 0.710) / index + 0.668 + 0.0636 * index;
    const double boundary = (1 + reflected) / (1 - reflected);
    return {scattered / total, 1 / total, (1 + 4.0 / 3.0 * boundary) / total,
            std::sqrt(3 * absorbed * total)};
}

double Pole(double z, double extinction, double square) {
    const double way_squared = square + z * z;
    const double way = std::sqrt(way_squared);
    const double x = extinction * way;
    return z * (1 + x) * std::exp(-x) / (way_squared * way);
}

double Reflected(const Medium& medium, double square) {
    return medium.albedo / (4 * std::numbers::pi) *
           (Pole(medium.real_depth, medium.extinction, square) +
            Pole(medium.virtual_depth, medium.extinction, square));
}

double PoleBeyond(double z, double extinction, double square) {
    const double way = std::sqrt(square + z * z);
    return z * std::exp(-extinction * way) / way;
}

// The depth of the scene's surface, or NaN where there is none.
double SceneDepth(double scene, double x, double y) {
    if (scene == 2) {
        return 4 - std::sqrt(4 - (x * x + y * y));
    }
    if (std::abs(x) > 3 || std::abs(y) > 3) {
        return std::nan("");
    }
    return scene == 0 ? 2 : 2 + 0.5 * (scene == 1 ? x : std::abs(x));
}

void Reflectance(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const double r = in[3][row];
        out[0][row] = Reflected(MakeMedium(in[0][row], in[1][row], in[2][row]), r * r);
    }
}

void Beyond(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Medium medium = MakeMedium(in[0][row], in[1][row], in[2][row]);
        const double square = in[3][row];
        out[0][row] = 0.5 * medium.albedo *
                      (PoleBeyond(medium.real_depth, medium.extinction, square) +
                       PoleBeyond(medium.virtual_depth, medium.extinction, square));
    }
}

void Sum(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Medium medium = MakeMedium(in[1][row], in[2][row], in[3][row]);
        const double leaves[3] = {(in[4][row] - 0.5) * kWidth, (in[5][row] - 0.5) * kWidth,
                                  in[6][row]};
        double sum = 0;
        for (int j = 0; j < kTexels; ++j) {
            const double y = (j + 0.5) * kTexel - kWidth / 2;
            for (int i = 0; i < kTexels; ++i) {
                const double x = (i + 0.5) * kTexel - kWidth / 2;
                const double depth = SceneDepth(in[0][row], x, y);
                if (!std::isnan(depth)) {
                    const double way[3] = {x - leaves[0], y - leaves[1], depth - leaves[2]};
                    sum += Reflected(medium, way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
                }
            }
        }
        out[0][row] = sum * (kTexel * kTexel);
    }
}

}  // namespace

std::vector<Function> ShadowMapFunctions() {
    return {
        {"shadow_map.reflectance",
         {{"sigma_a", 1}, {"sigma_s", 1}, {"index", 1}, {"r", 1}},
         1,
         Reflectance,
         4e-14,
         0},
        {"shadow_map.beyond",
         {{"sigma_a", 1}, {"sigma_s", 1}, {"index", 1}, {"square", 1}},
         1,
         Beyond,
         4e-14,
         0},
        {"shadow_map.sum",
         {{"scene", 1},
          {"sigma_a", 1},
          {"sigma_s", 1},
          {"index", 1},
          {"u", 1},
          {"v", 1},
          {"depth", 1}},
         1,
         Sum,
         2e-14,
         0},
    };
}

}  // namespace etalon::oracle
