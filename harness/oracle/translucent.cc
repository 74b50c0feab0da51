#include "oracle/translucent.h"

#include <array>
#include <cmath>

#include "oracle/batch.h"
#include "oracle/fresnel.h"

namespace etalon::oracle {
namespace {

// One direction's passage of the layer.
struct Passage {
    double cosine;  // outside
    double reflected;
    double transmitted;
    std::array<double, 3> left;  // by the way between the face and the solid
};

// in: the direction's three columns; layer: n1, n2, thickness, half_distance, absorb_color(3).
Passage Pass(const double* const* in, const double* const* layer, std::size_t row) {
    const double n1 = layer[0][row];
    const double n2 = layer[1][row];
    const Pair square_length = Dot(in, in, row);
    const double cosine = in[2][row] / std::sqrt(square_length.high + square_length.low);
    const Shares face = FresnelShares(n1, n2, {cosine, 0});
    Passage passage = {cosine,
                       0.5 * (face.s_reflected + face.p_reflected),
                       0.5 * (face.s_transmitted + face.p_transmitted),
                       {}};
    const double square = TransmittedSquare(n1, n2, {cosine, 0});
    if (square > 0) {
        const double halvings = layer[2][row] * n2 / std::sqrt(square) / layer[3][row];
        for (std::size_t channel = 0; channel < 3; ++channel) {
            passage.left[channel] = std::exp2(-halvings * layer[4 + channel][row]);
        }
    }
    return passage;
}

void Light(const double* const* in, double* const* out, std::size_t rows) {
    for (std::size_t row = 0; row < rows; ++row) {
        const Passage lamp = Pass(in, in + 3, row);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            out[channel][row] = lamp.transmitted * lamp.left[channel];
        }
    }
}

void Flat(const double* const* in, double* const* out, std::size_t rows) {
    const double* const* layer = in + 6;
    const double* const* albedo = in + 13;
    const double* const* sky = in + 16;
    const double* const* ambient = in + 19;
    const double* const* diffuse = in + 22;
    for (std::size_t row = 0; row < rows; ++row) {
        const Passage eye = Pass(in, layer, row);
        const Passage lamp = Pass(in + 3, layer, row);
        const double ratio = layer[0][row] / layer[1][row];
        const double lit = lamp.cosine * ratio * ratio * lamp.transmitted;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double light =
                ambient[channel][row] + diffuse[channel][row] * lit * lamp.left[channel];
            out[channel][row] = eye.reflected * sky[channel][row] +
                                eye.transmitted * eye.left[channel] * albedo[channel][row] * light;
        }
    }
}

}  // namespace

std::vector<Function> TranslucentFunctions() {
    return {
        {"translucent.light",
         {{"to_lamp", 3},
          {"n1", 1},
          {"n2", 1},
          {"thickness", 1},
          {"half_distance", 1},
          {"absorb_color", 3}},
         3,
         Light,
         2e-13,
         0},
        {"translucent.flat",
         {{"to_eye", 3},
          {"to_lamp", 3},
          {"n1", 1},
          {"n2", 1},
          {"thickness", 1},
          {"half_distance", 1},
          {"absorb_color", 3},
          {"albedo", 3},
          {"sky", 3},
          {"ambient", 3},
          {"diffuse", 3}},
         3,
         Flat,
         2e-13,
         0},
    };
}

}  // namespace etalon::oracle
