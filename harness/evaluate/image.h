// Images: what textureLod, texelFetch, textureSize and textureQueryLevels find in flat images and
// cubes. Coordinates, weights and the sums of texels are Numbers.
#pragma once

#include <algorithm>
#include <array>

#include "evaluate/glsl_scalar.h"
#include "evaluate/machine.h"
#include "evaluate/number.h"
#include "image/image.h"

namespace etalon::evaluate::operation {

template <typename N>
using Texel = std::array<N, 4>;

template <typename N>
class Sampler {
  public:
    explicit Sampler(const Texture& texture)
        : image_(*texture.image), sampling_(texture.sampling) {}

    Texel<N> Sample(const std::array<N, 3>& coordinate, const N& level) const {
        // Of NaN the first level, as what is out of range.
        const N last = O::FromUint(image_.levels - 1);
        const N clamped = O::Less(level, last) ? glsl::Max(Zero(), level) : last;
        const N inside = O::IsNan(level) ? Zero() : clamped;
        if (sampling_.filter == Filter::kNearest) {
            // ceil(level + 1/2) - 1, and 0 of 0.
            const N nearest = O::Sub(O::Ceil(O::Add(inside, Half())), glsl::One<N>());
            return AtLevel(coordinate, O::ToUint(glsl::Min(glsl::Max(nearest, Zero()), last)));
        }
        const std::uint32_t upper = O::ToUint(inside);
        const N share = O::Sub(inside, O::FromUint(upper));
        const Texel<N> first = AtLevel(coordinate, upper);
        if (upper + 1 >= image_.levels || O::Equal(share, Zero())) {
            return first;
        }
        return Between(first, AtLevel(coordinate, upper + 1), share);
    }

    Texel<N> At(std::uint32_t face, std::int32_t x, std::int32_t y, std::uint32_t level) const {
        const ImageSize size = LevelSize(image_, level);
        const std::size_t texel = std::size_t{face} * size.texels() +
                                  static_cast<std::size_t>(y) * size.width +
                                  static_cast<std::size_t>(x);
        const float* rgba = image_.rgba.data() + LevelStart(image_, level) + texel * 4;
        Texel<N> result{};
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] = O::FromBits(std::bit_cast<std::uint32_t>(rgba[i]));
        }
        return result;
    }

  private:
    using O = Ops<N>;
    static N Zero() { return glsl::Zero<N>(); }
    static N Half() { return O::FromBits(0x3f000000); }

    static Texel<N> Between(const Texel<N>& a, const Texel<N>& b, const N& share) {
        Texel<N> result{};
        for (std::size_t i = 0; i < result.size(); ++i) {
            result[i] = O::Add(O::Mul(a[i], O::Sub(glsl::One<N>(), share)), O::Mul(b[i], share));
        }
        return result;
    }

    std::int32_t Wrapped(std::int32_t place, std::uint32_t size) const {
        const auto count = static_cast<std::int32_t>(size);
        if (sampling_.wrap == Wrap::kClamp) {
            return std::clamp(place, 0, count - 1);
        }
        const std::int32_t rest = place % count;
        return rest < 0 ? rest + count : rest;
    }

    // The whole number below, and what is above it.
    static std::int32_t Split(const N& x, N& rest) {
        const N whole = O::Floor(x);
        rest = O::Sub(x, whole);
        // Not finite: anything will do, but a weight must be in 0..1.
        if (!O::Less(rest, glsl::One<N>()) || O::Less(rest, Zero())) {
            rest = Zero();
        }
        return O::ToInt(whole);
    }

    Texel<N> AtLevel(const std::array<N, 3>& coordinate, std::uint32_t level) const {
        return image_.shape == ImageShape::kCube ? OfCube(coordinate, level)
                                                 : OfPlane(coordinate, level);
    }

    Texel<N> OfPlane(const std::array<N, 3>& coordinate, std::uint32_t level) const {
        const ImageSize size = LevelSize(image_, level);
        const N x = O::Mul(Repeated(coordinate[0]), O::FromUint(size.width));
        const N y = O::Mul(Repeated(coordinate[1]), O::FromUint(size.height));
        N rest;
        if (sampling_.filter == Filter::kNearest) {
            return At(0, Wrapped(Split(x, rest), size.width), Wrapped(Split(y, rest), size.height),
                      level);
        }
        N across;
        N down;
        const std::int32_t i = Split(O::Sub(x, Half()), across);
        const std::int32_t j = Split(O::Sub(y, Half()), down);
        const std::int32_t left = Wrapped(i, size.width);
        const std::int32_t right = Wrapped(Next(i), size.width);
        const std::int32_t top = Wrapped(j, size.height);
        const std::int32_t bottom = Wrapped(Next(j), size.height);
        return Between(Between(At(0, left, top, level), At(0, right, top, level), across),
                       Between(At(0, left, bottom, level), At(0, right, bottom, level), across),
                       down);
    }

    // Subtracting whole turns first is exact and keeps large coordinates within integers.
    N Repeated(const N& x) const {
        return sampling_.wrap == Wrap::kRepeat ? O::Sub(x, O::Floor(x)) : x;
    }
    static std::int32_t Next(std::int32_t i) {
        return i == std::numeric_limits<std::int32_t>::max() ? i : i + 1;
    }

    struct OnFace {
        std::uint32_t face = 0;
        N s;
        N t;
    };

    // The face that a direction meets, and where, by the table of both APIs (OpenGL 4.5,
    // table 8.19).
    static OnFace Meet(const std::array<N, 3>& d) {
        const N x = O::Abs(d[0]);
        const N y = O::Abs(d[1]);
        const N z = O::Abs(d[2]);
        std::size_t axis = O::LessEqual(y, x) && O::LessEqual(z, x) ? 0
                           : O::LessEqual(z, y)                     ? 1
                                                                    : 2;
        if (O::LessEqual(x, z) && O::LessEqual(y, z)) {
            axis = 2;
        } else if (O::LessEqual(x, y) && O::LessEqual(z, y)) {
            axis = 1;
        }
        const bool negative = O::IsNegative(d[axis]);
        const N major = O::Abs(d[axis]);
        OnFace at;
        at.face = static_cast<std::uint32_t>(2 * axis + (negative ? 1 : 0));
        N s;
        N t;
        switch (axis) {
            case 0:
                s = negative ? d[2] : O::Neg(d[2]);
                t = O::Neg(d[1]);
                break;
            case 1:
                s = d[0];
                t = negative ? O::Neg(d[2]) : d[2];
                break;
            default:
                s = negative ? O::Neg(d[0]) : d[0];
                t = O::Neg(d[1]);
                break;
        }
        at.s = O::Mul(Half(), O::Add(O::Div(s, major), glsl::One<N>()));
        at.t = O::Mul(Half(), O::Add(O::Div(t, major), glsl::One<N>()));
        return at;
    }

    Texel<N> OfCube(const std::array<N, 3>& direction, std::uint32_t level) const {
        const OnFace at = Meet(direction);
        const std::uint32_t size = LevelSize(image_, level).width;
        const auto last = static_cast<std::int32_t>(size) - 1;
        const N x = O::Mul(at.s, O::FromUint(size));
        const N y = O::Mul(at.t, O::FromUint(size));
        N rest;
        if (sampling_.filter == Filter::kNearest) {
            return At(at.face, std::clamp(Split(x, rest), 0, last),
                      std::clamp(Split(y, rest), 0, last), level);
        }
        N across;
        N down;
        const std::int32_t i = std::clamp(Split(O::Sub(x, Half()), across), -1, last);
        const std::int32_t j = std::clamp(Split(O::Sub(y, Half()), down), -1, last);
        return Between(Between(Beyond(at.face, i, j, size, level),
                               Beyond(at.face, i + 1, j, size, level), across),
                       Between(Beyond(at.face, i, j + 1, size, level),
                               Beyond(at.face, i + 1, j + 1, size, level), across),
                       down);
    }

    // A texel of a face, or of the neighbour that lies beyond its edge. Beyond a corner there is
    // none: the mean of the three that meet there.
    Texel<N> Beyond(std::uint32_t face, std::int32_t x, std::int32_t y, std::uint32_t size,
                    std::uint32_t level) const {
        const auto last = static_cast<std::int32_t>(size) - 1;
        const bool beyond_x = x < 0 || x > last;
        const bool beyond_y = y < 0 || y > last;
        if (!beyond_x && !beyond_y) {
            return At(face, x, y, level);
        }
        const std::int32_t in_x = std::clamp(x, 0, last);
        const std::int32_t in_y = std::clamp(y, 0, last);
        if (beyond_x && beyond_y) {
            const Texel<N> a = At(face, in_x, in_y, level);
            const Texel<N> b = Beyond(face, x, in_y, size, level);
            const Texel<N> c = Beyond(face, in_x, y, size, level);
            Texel<N> mean{};
            for (std::size_t k = 0; k < mean.size(); ++k) {
                mean[k] = O::Div(O::Add(O::Add(a[k], b[k]), c[k]), O::FromInt(3));
            }
            return mean;
        }
        // The face's plane goes on past the edge; the direction there meets the neighbour within
        // half a texel of its edge.
        const auto centre = [&](std::int32_t k) {
            return (static_cast<double>(k) + 0.5) / static_cast<double>(size);
        };
        const Direction there = CubeDirection(face, centre(x), centre(y));
        std::array<double, 3> d = {there.x, there.y, there.z};
        const std::size_t own = face / 2;
        // What lies beyond the edge is as far along the neighbour's axis as its own texels' centres
        // are from the edge along this face's axis.
        std::size_t other = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            if (k != own && std::abs(d[k]) > 1.0) {
                other = k;
            }
        }
        const double inward = 2.0 - std::abs(d[other]);
        d[own] = std::copysign(inward, d[own]);
        d[other] = std::copysign(1.0, d[other]);
        return Neighbour(other, d, size, level);
    }

    Texel<N> Neighbour(std::size_t axis, const std::array<double, 3>& d, std::uint32_t size,
                       std::uint32_t level) const {
        const bool negative = d[axis] < 0;
        double s = 0;
        double t = 0;
        switch (axis) {
            case 0:
                s = negative ? d[2] : -d[2];
                t = -d[1];
                break;
            case 1:
                s = d[0];
                t = negative ? -d[2] : d[2];
                break;
            default:
                s = negative ? -d[0] : d[0];
                t = -d[1];
                break;
        }
        const auto last = static_cast<std::int32_t>(size) - 1;
        const auto place = [&](double k) {
            return std::clamp(static_cast<std::int32_t>((k + 1.0) / 2.0 * size), 0, last);
        };
        return At(static_cast<std::uint32_t>(2 * axis + (negative ? 1 : 0)), place(s), place(t),
                  level);
    }

    const Image& image_;
    const Sampling sampling_;
};

template <typename N>
const Texture& TextureOf(Machine<N>& m, const Step& step) {
    return m.images[m.Resolve(step.address).place.words];
}

template <typename N>
void ImageSampleExplicitLod(Machine<N>& m, const Step& step) {
    const Texture& texture = TextureOf(m, step);
    const Sampler<N> sampler(texture);
    const std::uint32_t at = m.Operand(step, 0).floats;
    const std::uint32_t parts = texture.image->shape == ImageShape::kCube ? 3 : 2;
    const N* level = m.Floats(m.Operand(step, 1).floats);
    m.lanes.Each([&](std::uint32_t lane) {
        std::array<N, 3> coordinate{};
        for (std::uint32_t i = 0; i < parts; ++i) {
            coordinate[i] = m.Floats(at + i)[lane];
        }
        const Texel<N> texel = sampler.Sample(coordinate, level[lane]);
        for (std::uint32_t i = 0; i < texel.size(); ++i) {
            m.Floats(step.result.floats + i)[lane] = texel[i];
        }
    });
}

// Outside of the image, which the specification leaves undefined: zeros.
template <typename N>
void ImageFetch(Machine<N>& m, const Step& step) {
    const Texture& texture = TextureOf(m, step);
    const Sampler<N> sampler(texture);
    const std::uint32_t* x = m.Words(m.Operand(step, 0).words);
    const std::uint32_t* y = m.Words(m.Operand(step, 0).words + 1);
    const std::uint32_t* levels = step.operands > 1 ? m.Words(m.Operand(step, 1).words) : nullptr;
    m.lanes.Each([&](std::uint32_t lane) {
        const std::uint32_t level = levels == nullptr ? 0 : levels[lane];
        Texel<N> texel;
        texel.fill(glsl::Zero<N>());
        if (level < texture.image->levels) {
            const ImageSize size = LevelSize(*texture.image, level);
            if (x[lane] < size.width && y[lane] < size.height) {
                texel = sampler.At(0, Signed(x[lane]), Signed(y[lane]), level);
            }
        }
        for (std::uint32_t i = 0; i < texel.size(); ++i) {
            m.Floats(step.result.floats + i)[lane] = texel[i];
        }
    });
}

template <typename N>
void ImageQuerySizeLod(Machine<N>& m, const Step& step) {
    const Image& image = *TextureOf(m, step).image;
    const std::uint32_t* levels = m.Words(m.Operand(step, 0).words);
    m.lanes.Each([&](std::uint32_t lane) {
        const bool is_there = levels[lane] < image.levels;
        const ImageSize size = is_there ? LevelSize(image, levels[lane]) : ImageSize{};
        m.Words(step.result.words)[lane] = size.width;
        m.Words(step.result.words + 1)[lane] = size.height;
    });
}

template <typename N>
void ImageQueryLevels(Machine<N>& m, const Step& step) {
    std::uint32_t* result = m.Words(step.result.words);
    m.lanes.Each([&](std::uint32_t lane) { result[lane] = TextureOf(m, step).image->levels; });
}

}  // namespace etalon::evaluate::operation
