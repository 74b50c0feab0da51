// Count: the operations that a program executes at each row, exactly, by class.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "evaluate/evaluate.h"
#include "evaluate/plan.h"

namespace etalon::evaluate {

enum class OperationClass : std::uint8_t {
    kArithmetic,
    kDivision,
    kSpecial,
    kComparison,
    kInteger,
    kFetch,
    kOther,
};
inline constexpr std::size_t kOperationClasses = 7;

// By class; differences of two may be taken.
struct Operations {
    std::array<std::int64_t, kOperationClasses> counts{};

    std::int64_t& operator[](OperationClass kind) { return counts[static_cast<std::size_t>(kind)]; }
    std::int64_t operator[](OperationClass kind) const {
        return counts[static_cast<std::size_t>(kind)];
    }
    Operations& operator+=(const Operations& more);
    Operations& operator-=(const Operations& less);
    bool operator==(const Operations&) const = default;
};

// What one execution of the step is for a lane. A function that stands for a formula is its
// operations: those of the evaluator, but for normalize, which divides nothing (its vector times an
// inverse square root), and for rounding and reducing, which are one each. Moves are nothing.
Operations OperationsOf(const Plan& plan, const Step& step);

// Of each row, by the way that binary32 takes. Fails as the evaluator does.
Result<std::vector<Operations>> CountOperations(const std::shared_ptr<const Plan>& plan,
                                                const std::vector<Texture>& images,
                                                std::uint32_t rows,
                                                std::span<const std::uint32_t> inputs,
                                                std::uint32_t output_words, Limits limits = {});

}  // namespace etalon::evaluate
