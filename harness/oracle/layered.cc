#include "oracle/layered.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "oracle/batch.h"

namespace etalon::oracle {
namespace {

ETALON_STEP double Sum(Pair pair) {
    return pair.high + pair.low;
}

// The refracted ray, times n2 and any length, is n1 times what of -v lies across the normal, and
// along -n what completes it to the length n2.
ETALON_BATCH void Way(const double* const* in, double* const* out, std::size_t rows) {
    const double* const* v = in;
    const double* const* n = in + 3;
    for (std::size_t row = 0; row < rows; ++row) {
        const double n1 = in[6][row];
        const double n2 = in[7][row];
        const double d = in[8][row];
        const Pair normal_square = Dot(n, n, row);
        const Pair view_square = Dot(v, v, row);
        const Pair view_normal = Dot(v, n, row);
        const double view_length = std::sqrt(Sum(view_square));
        const double along = Sum(view_normal) / Sum(normal_square);
        const double across_scale = n1 / view_length;
        double ray[3];
        for (int k = 0; k < 3; ++k) {
            ray[k] = -across_scale * std::fma(-along, n[k][row], v[k][row]);
        }
        // Near the critical angle the two terms nearly cancel.
        const Pair projection = Multiply({n1, 0}, view_normal);
        const Pair square =
            Add(Multiply(ExactProduct(n2 - n1, n2 + n1), Multiply(view_square, normal_square)),
                Multiply(projection, projection));
        const double rest = std::sqrt(Sum(square)) / (view_length * Sum(normal_square));
        for (int k = 0; k < 3; ++k) {
            ray[k] -= std::copysign(rest, along) * n[k][row];
        }
        const double scale = ray[2] < 0 ? -d / ray[2] : std::numeric_limits<double>::quiet_NaN();
        out[0][row] = scale * ray[0];
        out[1][row] = scale * ray[1];
        out[2][row] = scale * n2;
    }
}

// Gauss and Chebyshev's rule of the second kind over the diameter: exact to the last bits as long
// as the wave has fewer periods than the rule has nodes.
constexpr int kNodes = 95;

struct Node {
    double place;
    double weight;
};

std::array<Node, kNodes> DiscNodes() {
    std::array<Node, kNodes> nodes;
    for (int k = 0; k < kNodes; ++k) {
        const double angle = std::numbers::pi * (k + 1) / (kNodes + 1);
        const double sine = std::sin(angle);
        nodes[static_cast<std::size_t>(k)] = {std::cos(angle), 2 * sine * sine / (kNodes + 1)};
    }
    return nodes;
}

void Disc(const double* const* in, double* const* out, std::size_t rows) {
    static const std::array<Node, kNodes> nodes = DiscNodes();
    for (std::size_t row = 0; row < rows; ++row) {
        double mean = 0;
        for (const Node& node : nodes) {
            mean += node.weight * std::cos(in[0][row] * node.place);
        }
        out[0][row] = mean;
    }
}

}  // namespace

std::vector<Function> LayeredFunctions() {
    return {
        {"layered.way", {{"v", 3}, {"n", 3}, {"n1", 1}, {"n2", 1}, {"d", 1}}, 3, Way, 0, 8e-13},
        {"layered.disc", {{"x", 1}}, 1, Disc, 0, 2e-14},
    };
}

}  // namespace etalon::oracle
