#include "evaluate/bound.h"

#include <bit>

namespace etalon::evaluate {

bool Bound::Holds(std::uint32_t bits) const {
    switch (kind) {
        case Kind::kNumber: {
            const auto value = std::bit_cast<float>(bits);
            return low <= value && value <= high;
        }
        case Kind::kWord:
            return bits == word;
        case Kind::kUnbounded:
            return true;
    }
    return true;
}

std::vector<Bound> BoundOutputs(std::shared_ptr<const Plan>, const std::vector<Texture>&,
                                const Profile&, std::uint32_t rows, std::span<const std::uint32_t>,
                                std::uint32_t output_words, Limits) {
    return std::vector<Bound>(std::size_t{rows} * output_words);
}

}  // namespace etalon::evaluate
