#include "case/any_bits.h"

#include <algorithm>
#include <span>

#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr std::uint32_t kFloats[] = {
    0x00000000, 0x80000000,              // zeros
    0x00000001, 0x007fffff, 0x00800000,  // the ends of the subnormal, the smallest normal
    0x3f800000, 0x7f7fffff, 0xff7fffff,  // 1, the largest of both signs
    0x7f800000, 0xff800000,              // infinities
    0x7fc00000, 0xffc00000,              // quiet NaNs
    0x7f800001, 0xffbfffff,              // signalling NaNs
};
constexpr std::uint32_t kIntegers[] = {0, 1, 0xffffffff, 0x7fffffff, 0x80000000};
constexpr std::uint32_t kBools[] = {0, 1};

std::span<const std::uint32_t> SpecialWords(Scalar scalar) {
    switch (scalar) {
        case Scalar::kFloat:
            return kFloats;
        case Scalar::kInt:
        case Scalar::kUint:
            return kIntegers;
        case Scalar::kBool:
            break;
    }
    return kBools;
}

std::uint32_t OrdinaryWord(Scalar scalar, std::uint64_t seed) {
    const double share = Uniform(seed, 0);
    if (scalar == Scalar::kFloat) {
        return ToBits(static_cast<float>(4 * share - 2));
    }
    const auto number = static_cast<std::int32_t>(64 * share);
    return static_cast<std::uint32_t>(scalar == Scalar::kInt ? number - 32 : number);
}

std::uint32_t AnyWord(Scalar scalar, std::uint64_t seed) {
    const auto special = SpecialWords(scalar);
    const std::uint64_t kind = Mix(seed, "kind") % 8;
    if (scalar == Scalar::kBool || kind == 4) {
        return special[Mix(seed, "special") % special.size()];
    }
    return kind < 4 ? OrdinaryWord(scalar, Mix(seed, "ordinary"))
                    : static_cast<std::uint32_t>(Mix(seed, "bits") >> 32);
}

}  // namespace

ValueList AnyBits(const TypeShape& shape, std::uint64_t count, std::uint64_t seed,
                  bool side_by_side) {
    ValueList list{shape.size(), {}};
    const auto special = SpecialWords(shape.scalar);
    std::uint64_t drawn = count;
    if (!side_by_side || 2 * special.size() <= count) {
        for (const std::uint32_t word : special) {
            list.words.insert(list.words.end(), list.components, word);
        }
        drawn = side_by_side ? count - special.size() : count;
    }
    for (std::uint64_t k = 0; k < drawn; ++k) {
        for (unsigned c = 0; c < list.components; ++c) {
            list.words.push_back(AnyWord(shape.scalar, Mix(Mix(seed, c), k)));
        }
    }
    const std::uint64_t order = Mix(seed, "order");
    for (std::uint64_t k = side_by_side ? list.size() : 0; k > 1; --k) {
        const auto at = [&list](std::uint64_t value) {
            return list.words.begin() + static_cast<std::ptrdiff_t>(value * list.components);
        };
        const std::uint64_t other = Mix(order, k) % k;
        if (other != k - 1) {
            std::swap_ranges(at(k - 1), at(k), at(other));
        }
    }
    return list;
}

}  // namespace etalon
