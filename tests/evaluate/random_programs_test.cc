// Random expression programs: compiled by glslang and evaluated, against the same expression
// evaluated by the host as it was made.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <functional>
#include <memory>
#include <random>

#include "evaluate/probed.h"

namespace etalon {
namespace {

constexpr std::size_t kInputs = 4;
constexpr std::size_t kRows = 300;
constexpr int kPrograms = 200;

using Inputs = std::array<float, kInputs>;

// A piece of GLSL and what it means.
struct Made {
    std::string text;
    std::function<float(const Inputs&)> value;
};

class Maker {
  public:
    explicit Maker(std::uint32_t seed) : random_(seed) {}

    Made Make(int depth) {
        const std::uint32_t kind = Below(depth == 0 ? 2 : 14);
        if (kind == 0) {
            const std::uint32_t input = Below(kInputs);
            return {std::string(1, static_cast<char>('a' + input)),
                    [input](const Inputs& in) { return in[input]; }};
        }
        if (kind == 1) {
            // A call, because glslang folds what is constant in binary64, with one rounding.
            const float constant = static_cast<float>(Below(64)) / 8.0f - 3.5f;
            return {"kept(" + std::to_string(constant) + ")",
                    [constant](const Inputs&) { return constant; }};
        }
        const Made x = Make(depth - 1);
        const Made y = Make(depth - 1);
        const auto two = [&](const std::string& text, float (*f)(float, float)) {
            return Made{text, [x, y, f](const Inputs& in) { return f(x.value(in), y.value(in)); }};
        };
        switch (kind) {
            case 2:
            case 3:
                return two("(" + x.text + " + " + y.text + ")",
                           [](float p, float q) { return p + q; });
            case 4:
                return two("(" + x.text + " - " + y.text + ")",
                           [](float p, float q) { return p - q; });
            case 5:
            case 6:
                return two("(" + x.text + " * " + y.text + ")",
                           [](float p, float q) { return p * q; });
            case 7:
                return two("(" + x.text + " / " + y.text + ")",
                           [](float p, float q) { return p / q; });
            case 8:
                return two("sqrt(abs(" + x.text + "))",
                           [](float p, float) { return std::sqrt(std::abs(p)); });
            case 9:
                return two("min(" + x.text + ", " + y.text + ")",
                           [](float p, float q) { return std::isnan(p) || q < p ? q : p; });
            case 10:
                return two("dot(vec2(" + x.text + ", " + y.text + "), vec2(" + y.text + ", 0.75))",
                           [](float p, float q) { return p * q + q * 0.75f; });
            case 11: {
                const Made z = Make(depth - 1);
                return {"choose(" + x.text + ", " + y.text + ", " + z.text + ")",
                        [x, y, z](const Inputs& in) {
                            const float p = x.value(in);
                            const float q = y.value(in);
                            return p < q ? q - p : z.value(in) * p;
                        }};
            }
            case 12:
                return two("power(" + x.text + ", int(clamp(mod(" + y.text + ", 5.0), 0.0, 4.0)))",
                           [](float p, float q) {
                               const float rest = q - 5.0f * std::floor(q / 5.0f);
                               const int n =
                                   rest > 0.0f ? static_cast<int>(std::min(rest, 4.0f)) : 0;
                               float product = 1.0f;
                               for (int i = 0; i < n; ++i) {
                                   product = product * p;
                               }
                               return product;
                           });
            default:
                return two("(-" + x.text + ")", [](float p, float) { return -p; });
        }
    }

  private:
    std::uint32_t Below(std::uint32_t end) { return static_cast<std::uint32_t>(random_() % end); }
    std::mt19937 random_;
};

TEST(RandomPrograms, AreTheHosts) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> near(-3.0f, 3.0f);
    std::vector<std::vector<float>> columns(kInputs);
    for (auto& column : columns) {
        for (std::size_t row = 0; row < kRows; ++row) {
            column.push_back(row % 10 == 0 ? std::ldexp(near(random), static_cast<int>(row) - 150)
                                           : near(random));
        }
    }
    for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
        const Made made = Maker(seed).Make(4);
        const std::string source =
            "float kept(float x) { return x; }\n"
            "float choose(float a, float b, float c) {\n"
            "  if (a < b) { return b - a; }\n  return c * a; }\n"
            "float power(float x, int n) {\n"
            "  float product = 1.0; for (int i = 0; i < n; ++i) { product = product * x; }\n"
            "  return product; }\n"
            "float f(float a, float b, float c, float d) { return " +
            made.text + "; }\n";
        const Probed probed(source, "f(a, b, c, d)", {"float a", "float b", "float c", "float d"});
        ASSERT_EQ(probed.error(), "") << source;
        const std::vector<float> out = probed.Floats(columns);
        ASSERT_EQ(out.size(), kRows) << source;
        for (std::size_t row = 0; row < kRows; ++row) {
            const float truth =
                made.value({columns[0][row], columns[1][row], columns[2][row], columns[3][row]});
            ASSERT_TRUE(std::bit_cast<std::uint32_t>(out[row]) ==
                            std::bit_cast<std::uint32_t>(truth) ||
                        (std::isnan(out[row]) && std::isnan(truth)))
                << "seed " << seed << " row " << row << ": " << out[row] << ", not " << truth
                << "\n"
                << source;
        }
    }
}

}  // namespace
}  // namespace etalon
