#include "image/levels.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace etalon {
namespace {

constexpr std::size_t kChannels = 4;

// What texel `at` of `to` covers of a row or column of `from` = 2 to or 2 to + 1 texels: up to
// three of them, with weights of sum 1.
struct Cover {
    std::size_t first = 0;
    std::size_t count = 0;
    std::array<double, 3> weights = {};
};

Cover CoverOf(std::uint32_t from, std::uint32_t to, std::uint32_t at) {
    if (from == to) {
        return {at, 1, {1}};
    }
    if (from % 2 == 0) {
        return {std::size_t{2} * at, 2, {0.5, 0.5}};
    }
    const double size = from;
    return {std::size_t{2} * at, 3, {(to - at) / size, to / size, (at + 1) / size}};
}

// One face of the next level.
std::vector<double> Halve(const std::vector<double>& above, ImageSize from, ImageSize to) {
    std::vector<double> below(kChannels * to.texels());
    for (std::uint32_t y = 0; y < to.height; ++y) {
        const Cover rows = CoverOf(from.height, to.height, y);
        for (std::uint32_t x = 0; x < to.width; ++x) {
            const Cover columns = CoverOf(from.width, to.width, x);
            double* const texel = below.data() + kChannels * (std::size_t{y} * to.width + x);
            for (std::size_t row = 0; row < rows.count; ++row) {
                for (std::size_t column = 0; column < columns.count; ++column) {
                    const double weight = rows.weights[row] * columns.weights[column];
                    const double* const source =
                        above.data() +
                        kChannels * ((rows.first + row) * from.width + columns.first + column);
                    for (std::size_t channel = 0; channel < kChannels; ++channel) {
                        texel[channel] += weight * source[channel];
                    }
                }
            }
        }
    }
    return below;
}

}  // namespace

void AddLevels(Image& image) {
    ETALON_CHECK(image.levels == 1 && IsWhole(image));
    const std::uint32_t faces = FaceCount(image);
    std::vector<std::vector<double>> current;
    const std::size_t values = image.rgba.size() / faces;
    for (std::uint32_t face = 0; face < faces; ++face) {
        const auto begin = image.rgba.begin() + static_cast<std::ptrdiff_t>(face * values);
        current.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(values));
    }
    for (image.levels = 1; image.levels < FullLevels(image); ++image.levels) {
        const ImageSize from = LevelSize(image, image.levels - 1);
        const ImageSize to = LevelSize(image, image.levels);
        for (std::vector<double>& face : current) {
            face = Halve(face, from, to);
            std::transform(face.begin(), face.end(), std::back_inserter(image.rgba),
                           [](double value) { return static_cast<float>(value); });
        }
    }
}

}  // namespace etalon
