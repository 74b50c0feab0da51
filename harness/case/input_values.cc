#include "case/input_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "case/any_bits.h"
#include "numeric/sampling.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr std::uint64_t kMostValues = 1u << 24;

Result<std::pair<float, float>> FloatRange(const Input& input, Spacing spacing) {
    const auto [low, high] = *input.range;
    const auto from = static_cast<float>(low);
    const auto to = static_cast<float>(high);
    const bool finite = std::isfinite(from) && std::isfinite(to);
    if (!(low <= high)) {
        return Error{"the range [" + Shortest(low) + ", " + Shortest(high) + "] is empty"};
    }
    if (!finite && (spacing != Spacing::kBits || std::isfinite(low) != std::isfinite(from) ||
                    std::isfinite(high) != std::isfinite(to))) {
        return Error{"the range [" + Shortest(low) + ", " + Shortest(high) + "] does not fit"};
    }
    if (spacing == Spacing::kLog && (from == 0 || to == 0 || (from < 0) != (to < 0))) {
        return Error{"a logarithmic range must not hold zero"};
    }
    return std::pair(from, to);
}

// Exactly `count` values in random order: the landmarks, if they make up no more than half of them,
// and samples.
std::vector<float> ShuffledFloats(Spacing spacing, float low, float high, std::uint64_t count,
                                  std::uint64_t seed) {
    std::vector<float> values = Landmarks(spacing, low, high);
    if (2 * values.size() > count) {
        values.clear();
    }
    const auto samples = Strata(spacing, low, high, count - values.size(), seed);
    values.insert(values.end(), samples.begin(), samples.end());
    Shuffle(values, Mix(seed, "order"));
    return values;
}

Result<ValueList> FloatsInRange(const Input& input, const TypeShape& shape, std::uint64_t seed,
                                bool side_by_side) {
    const Spacing spacing = input.sample == "linear"
                                ? Spacing::kLinear
                                : (input.sample == "log" ? Spacing::kLog : Spacing::kBits);
    ETALON_TRY(range, FloatRange(input, spacing));
    const auto [low, high] = range;
    ValueList list{shape.size(), {}};
    if (shape.size() == 1 && !side_by_side) {
        std::vector<float> values = Landmarks(spacing, low, high);
        const auto samples = Strata(spacing, low, high, input.count, seed);
        values.insert(values.end(), samples.begin(), samples.end());
        SortUnique(values);
        for (const float value : values) {
            list.words.push_back(ToBits(value));
        }
        return list;
    }
    list.words.resize(input.count * list.components);
    for (unsigned c = 0; c < list.components; ++c) {
        const auto values = ShuffledFloats(spacing, low, high, input.count, Mix(seed, c));
        for (std::size_t k = 0; k < values.size(); ++k) {
            list.words[k * list.components + c] = ToBits(values[k]);
        }
    }
    return list;
}

// Evenly over the range, one per stratum, with both ends.
std::vector<std::int64_t> Integers(std::int64_t low, std::int64_t high, std::uint64_t count,
                                   std::uint64_t seed) {
    const auto all = static_cast<std::uint64_t>(high - low + 1);
    std::vector<std::int64_t> values;
    for (std::uint64_t k = 0; k < count; ++k) {
        const std::uint64_t begin = all * k / count;
        const std::uint64_t size = std::max<std::uint64_t>(all * (k + 1) / count - begin, 1);
        values.push_back(low + static_cast<std::int64_t>(begin + Mix(seed, k) % size));
    }
    if (count > 0) {
        values.front() = low;
        values.back() = count > 1 ? high : low;
    }
    return values;
}

Result<ValueList> IntegersInRange(const Input& input, const TypeShape& shape, std::uint64_t seed,
                                  bool side_by_side) {
    if (!input.sample.empty() && input.sample != "linear") {
        return Error{"sample '" + input.sample + "' is for floats"};
    }
    for (const double end : {input.range->first, input.range->second}) {
        if (auto word = WordOf(shape.scalar, end); !word) {
            return word.error();
        }
    }
    const auto low = static_cast<std::int64_t>(input.range->first);
    const auto high = static_cast<std::int64_t>(input.range->second);
    if (low > high) {
        return Error{"the range is empty"};
    }
    ValueList list{shape.size(), {}};
    const bool sorted = list.components == 1 && !side_by_side;
    const auto all = static_cast<std::uint64_t>(high - low + 1);
    const std::uint64_t count =
        sorted ? std::min(std::max<std::uint64_t>(input.count, 2), all) : input.count;
    list.words.resize(count * list.components);
    for (unsigned c = 0; c < list.components; ++c) {
        const std::uint64_t stream = Mix(seed, c);
        const auto values = Integers(low, high, count, stream);
        for (std::uint64_t k = 0; k < count; ++k) {
            list.words[k * list.components + c] = static_cast<std::uint32_t>(values[k]);
        }
        for (std::uint64_t k = sorted ? 0 : count; k > 1; --k) {
            std::swap(list.words[(k - 1) * list.components + c],
                      list.words[Mix(stream, k + count) % k * list.components + c]);
        }
    }
    return list;
}

Result<ValueList> Directions(const Input& input, const TypeShape& shape, std::uint64_t seed,
                             bool side_by_side) {
    ValueList list{shape.size(), {}};
    for (unsigned axis = 0; axis < 2 * list.components && !side_by_side; ++axis) {
        for (unsigned c = 0; c < list.components; ++c) {
            const float sign = axis % 2 == 0 ? 1.0f : -1.0f;
            list.words.push_back(ToBits(axis / 2 == c ? sign : 0.0f));
        }
    }
    float vector[3] = {};
    for (std::uint64_t k = 0; k < input.count; ++k) {
        // Side by side with others the even order would tie the inputs together.
        const std::uint64_t index = side_by_side ? Mix(seed, k) % input.count : k;
        Direction(index, input.count, Mix(seed, k), {vector, list.components});
        for (unsigned c = 0; c < list.components; ++c) {
            list.words.push_back(ToBits(vector[c]));
        }
    }
    return list;
}

}  // namespace

Result<TypeShape> ShapeOf(const std::string& type) {
    if (const auto scalar = ScalarFromName(type)) {
        return TypeShape{*scalar, 1, 1};
    }
    const auto size = [](char digit) -> unsigned {
        return digit >= '2' && digit <= '4' ? static_cast<unsigned>(digit - '0') : 0;
    };
    constexpr std::pair<std::string_view, Scalar> kVectors[] = {{"vec", Scalar::kFloat},
                                                                {"ivec", Scalar::kInt},
                                                                {"uvec", Scalar::kUint},
                                                                {"bvec", Scalar::kBool}};
    for (const auto& [prefix, scalar] : kVectors) {
        if (type.size() == prefix.size() + 1 && type.starts_with(prefix) && size(type.back()) > 0) {
            return TypeShape{scalar, size(type.back()), 1};
        }
    }
    if (type.starts_with("mat") && (type.size() == 4 || (type.size() == 6 && type[4] == 'x'))) {
        const unsigned columns = size(type[3]);
        const unsigned rows = size(type.back());
        if (columns > 0 && rows > 0) {
            return TypeShape{Scalar::kFloat, rows, columns};
        }
    }
    return Error{"'" + type + "' is not a scalar, vector or matrix type"};
}

Result<std::uint32_t> WordOf(Scalar scalar, double value) {
    if (scalar == Scalar::kFloat) {
        const auto rounded = static_cast<float>(value);
        if (std::isinf(rounded) && !std::isinf(value)) {
            return Error{Shortest(value) + " does not fit a float"};
        }
        return ToBits(rounded);
    }
    const double low = scalar == Scalar::kInt ? -0x1p31 : 0;
    const double high =
        scalar == Scalar::kBool ? 1 : (scalar == Scalar::kInt ? 0x1p31 - 1 : 0x1p32 - 1);
    if (!(value >= low && value <= high) || value != std::floor(value)) {
        return Error{Shortest(value) + " is not " + (scalar == Scalar::kInt ? "an " : "a ") +
                     std::string(ScalarName(scalar))};
    }
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(value));
}

Result<ValueList> OwnValues(const Input& input, std::uint64_t seed, bool side_by_side) {
    ETALON_TRY(shape, ShapeOf(input.type));
    if (input.count > kMostValues) {
        return Error{"a count of more than 2^24"};
    }
    if (input.sample == "any") {
        return AnyBits(shape, input.count, seed, side_by_side);
    }
    if (input.sample == "sphere") {
        return Directions(input, shape, seed, side_by_side);
    }
    if (input.range) {
        return shape.scalar == Scalar::kFloat ? FloatsInRange(input, shape, seed, side_by_side)
                                              : IntegersInRange(input, shape, seed, side_by_side);
    }
    ValueList list{shape.size(), {}};
    for (const std::vector<double>& value : input.values) {
        if (value.size() != list.components) {
            return Error{"a value of type " + input.type + " has " +
                         std::to_string(list.components) + " components, not " +
                         std::to_string(value.size())};
        }
        for (const double component : value) {
            ETALON_TRY(word, WordOf(shape.scalar, component));
            list.words.push_back(word);
        }
    }
    return list;
}

}  // namespace etalon
