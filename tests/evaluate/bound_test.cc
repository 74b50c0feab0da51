#include "evaluate/bound.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>

#include "evaluate/probed.h"

namespace etalon {
namespace {

using evaluate::Bound;

std::vector<Bound> BoundsOf(const Probed& probed, const std::vector<std::vector<float>>& inputs,
                            const std::string& profile = "vulkan-1.3",
                            evaluate::Limits limits = {}) {
    std::vector<std::uint32_t> words;
    for (const auto& column : inputs) {
        for (const float x : column) {
            words.push_back(std::bit_cast<std::uint32_t>(x));
        }
    }
    return evaluate::BoundOutputs(probed.plan(), {}, *evaluate::FindProfile(profile),
                                  static_cast<std::uint32_t>(inputs.at(0).size()), words,
                                  probed.program().output_words, limits);
}

// Of one output at one row of floats a, b, c...
Bound BoundAt(const std::string& expression, const std::vector<float>& inputs,
              const std::string& functions = "", const std::string& recipe = "spirv",
              const std::string& profile = "vulkan-1.3") {
    std::vector<std::string> names;
    std::vector<std::vector<float>> columns;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        names.push_back(std::string("float ") + static_cast<char>('a' + i));
        columns.push_back({inputs[i]});
    }
    const Probed probed(functions + "\nfloat unused() { return 0.0; }\n", expression, names,
                        recipe);
    EXPECT_EQ(probed.error(), "");
    return probed.error().empty() ? BoundsOf(probed, columns, profile).at(0) : Bound{};
}

float Next(float x, int steps) {
    for (int i = 0; i < std::abs(steps); ++i) {
        x = std::nextafter(x, steps < 0 ? -INFINITY : INFINITY);
    }
    return x;
}

#define EXPECT_BOUND(bound, expected_low, expected_high)                   \
    do {                                                                   \
        const Bound seen = bound;                                          \
        EXPECT_EQ(seen.kind, Bound::Kind::kNumber);                        \
        EXPECT_EQ(seen.low, expected_low) << std::hexfloat << seen.low;    \
        EXPECT_EQ(seen.high, expected_high) << std::hexfloat << seen.high; \
    } while (false)

TEST(Bound, OfOneRoundedOperationAreTheNeighbours) {
    EXPECT_BOUND(BoundAt("a + b", {1.0f, 0x1p-30f}), 1.0f, Next(1.0f, 1));
    EXPECT_BOUND(BoundAt("a - b", {1.0f, 0x1p-30f}), Next(1.0f, -1), 1.0f);
    EXPECT_BOUND(BoundAt("a * b", {1.1f, 1.3f}), 1.43f - 0x1p-23f * 0, 1.43f);
}

}  // namespace
}  // namespace etalon
