// What a filter may find in an image over a range of places.
#pragma once

#include "evaluate/image.h"
#include "evaluate/interval_operations.h"

namespace etalon::evaluate::operation {

// Samples one image for one lane.
class IntervalSampler {
  public:
    IntervalSampler(IntervalMachine& m, const Texture& texture)
        : m_(m), image_(*texture.image), sampling_(texture.sampling) {}

    Texel<Interval> Sample(const std::array<Interval, 3>& coordinate, const Interval& level) {
        Texel<Interval> result;
        result.fill(interval::Anything());
        for (const Interval& x : coordinate) {
            if (x.IsAnything()) {
                return result;
            }
        }
        const double last = image_.levels - 1;
        const double slack = Weight();
        double lowest = std::clamp(level.low() - slack, 0.0, last);
        double highest = std::clamp(level.high + slack, 0.0, last);
        if (level.IsAnything()) {
            lowest = 0;
            highest = last;
        }
        const bool is_linear = sampling_.filter == Filter::kLinear;
        const auto first = static_cast<std::uint32_t>(is_linear ? std::floor(lowest)
                                                                : std::ceil(lowest + 0.5) - 1);
        const auto final =
            static_cast<std::uint32_t>(is_linear ? std::ceil(highest) : std::floor(highest + 0.5));
        for (std::uint32_t at = first; at <= final; ++at) {
            const TexelRange range = OfLevel(coordinate, at);
            for (std::size_t i = 0; i < result.size(); ++i) {
                const Interval one = interval::Settled(-static_cast<double>(range[i].first),
                                                       static_cast<double>(range[i].second));
                result[i] = at == first ? one : interval::Hull(result[i], one);
            }
        }
        return result;
    }

  private:
    // Beyond so many texels to a side the whole level is taken.
    static constexpr double kMostAcross = 16;

    static double Weight() { return Held::profile().weight_absolute; }

    TexelRange OfLevel(const std::array<Interval, 3>& coordinate, std::uint32_t level) {
        const ImageSize size = LevelSize(image_, level);
        const auto place = [&](const Interval& x, std::uint32_t count) {
            // Its product with the size is rounded too.
            const double off = x.magnitude * count * interval::kEpsilon;
            const double shift = sampling_.filter == Filter::kLinear ? 0.5 : 0.0;
            return std::pair(x.low() * count - shift - off, x.high * count - shift + off);
        };
        const auto [left, right] = place(coordinate[0], size.width);
        const auto [top, bottom] = place(coordinate[1], size.height);
        if (image_.shape == ImageShape::kCube || !(right - left <= kMostAcross) ||
            !(bottom - top <= kMostAcross) || !(std::abs(left) + std::abs(top) < 0x1p40)) {
            return m_.context.RangeOf(image_, level);
        }
        return sampling_.filter == Filter::kNearest
                   ? OfNearest(left, right, top, bottom, size, level)
                   : OfLinear(left, right, top, bottom, size, level);
    }

    const float* TexelAt(std::int64_t x, std::int64_t y, ImageSize size,
                         std::uint32_t level) const {
        const auto wrapped = [&](std::int64_t place, std::uint32_t count) {
            const auto end = static_cast<std::int64_t>(count);
            if (sampling_.wrap == Wrap::kClamp) {
                return static_cast<std::size_t>(std::clamp<std::int64_t>(place, 0, end - 1));
            }
            return static_cast<std::size_t>((place % end + end) % end);
        };
        return image_.rgba.data() + LevelStart(image_, level) +
               4 * (wrapped(y, size.height) * size.width + wrapped(x, size.width));
    }

    static void Widen(TexelRange& range, std::size_t channel, double low, double high) {
        range[channel].first = std::min(range[channel].first, static_cast<float>(low));
        range[channel].second = std::max(range[channel].second, static_cast<float>(high));
    }
    static TexelRange Nothing() {
        TexelRange range;
        range.fill(
            {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()});
        return range;
    }

    TexelRange OfNearest(double left, double right, double top, double bottom, ImageSize size,
                         std::uint32_t level) const {
        TexelRange range = Nothing();
        const double off = std::min(Weight(), 0.5);
        for (double y = std::floor(top - off); y <= std::floor(bottom + off); ++y) {
            for (double x = std::floor(left - off); x <= std::floor(right + off); ++x) {
                const float* texel = TexelAt(static_cast<std::int64_t>(x),
                                             static_cast<std::int64_t>(y), size, level);
                for (std::size_t i = 0; i < 4; ++i) {
                    Widen(range, i, static_cast<double>(texel[i]), static_cast<double>(texel[i]));
                }
            }
        }
        return range;
    }

    // Between four texels the value is linear in each weight, so its extremes are at the extreme
    // weights.
    TexelRange OfLinear(double left, double right, double top, double bottom, ImageSize size,
                        std::uint32_t level) const {
        TexelRange range = Nothing();
        const double off = std::min(Weight(), 1.0);
        for (double y = std::floor(top - off); y <= std::floor(bottom + off); ++y) {
            for (double x = std::floor(left - off); x <= std::floor(right + off); ++x) {
                const std::array<double, 2> across = {std::clamp(left - off - x, 0.0, 1.0),
                                                      std::clamp(right + off - x, 0.0, 1.0)};
                const std::array<double, 2> down = {std::clamp(top - off - y, 0.0, 1.0),
                                                    std::clamp(bottom + off - y, 0.0, 1.0)};
                Mix(range, static_cast<std::int64_t>(x), static_cast<std::int64_t>(y), across, down,
                    size, level);
            }
        }
        return range;
    }

    void Mix(TexelRange& range, std::int64_t x, std::int64_t y, const std::array<double, 2>& across,
             const std::array<double, 2>& down, ImageSize size, std::uint32_t level) const {
        const float* corners[] = {TexelAt(x, y, size, level), TexelAt(x + 1, y, size, level),
                                  TexelAt(x, y + 1, size, level),
                                  TexelAt(x + 1, y + 1, size, level)};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto value = [&](std::size_t corner) {
                return static_cast<double>(corners[corner][i]);
            };
            double most = 0;
            for (std::size_t corner = 0; corner < 4; ++corner) {
                most = std::max(most, std::abs(value(corner)));
            }
            const double rounding = 4 * interval::kEpsilon * most;
            for (const double s : across) {
                for (const double t : down) {
                    const double upper = value(0) + (value(1) - value(0)) * s;
                    const double lower = value(2) + (value(3) - value(2)) * s;
                    const double mixed = upper + (lower - upper) * t;
                    Widen(range, i, interval::FloatBelow(mixed - rounding),
                          interval::FloatAbove(mixed + rounding));
                }
            }
        }
    }

    IntervalMachine& m_;
    const Image& image_;
    const Sampling sampling_;
};

template <>
inline void ImageSampleExplicitLod(IntervalMachine& m, const Step& step) {
    const Texture& texture = TextureOf(m, step);
    IntervalSampler sampler(m, texture);
    const std::uint32_t at = m.Operand(step, 0).floats;
    const std::uint32_t parts = texture.image->shape == ImageShape::kCube ? 3 : 2;
    const Interval* level = m.Floats(m.Operand(step, 1).floats);
    m.lanes.Each([&](std::uint32_t lane) {
        std::array<Interval, 3> coordinate{};
        for (std::uint32_t i = 0; i < parts; ++i) {
            coordinate[i] = interval::Settle(m.Floats(at + i)[lane]);
        }
        const Texel<Interval> texel = sampler.Sample(coordinate, interval::Settle(level[lane]));
        for (std::uint32_t i = 0; i < texel.size(); ++i) {
            m.Floats(step.result.floats + i)[lane] = texel[i];
        }
    });
}

}  // namespace etalon::evaluate::operation
