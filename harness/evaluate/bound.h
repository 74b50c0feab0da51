// Bound: every result that a conforming implementation may return for a probe at an input.
//
// Each operation is widened by what a specification's profile allows: rounding to either
// neighbour, errors in ulp or absolute, errors inherited from formulas, subnormal numbers taken as
// zeros, and, but for what is decorated NoContraction, any contraction and rearrangement by
// associativity, commutativity and distributivity. Where a comparison may go either way both ways
// are taken and the bound is their hull. What is undefined has no bound (a division by zero, a
// float that no int is, a shift beyond the word, a variable of floats without a value), nor has
// what is decorated RelaxedPrecision.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/result.h"
#include "evaluate/evaluate.h"
#include "evaluate/profile.h"

namespace etalon::evaluate {

// Of one output at one row.
struct Bound {
    enum class Kind : std::uint8_t {
        kNumber,     // a float in [low, high]; an infinite end: that infinity is allowed too
        kWord,       // an int, a uint or a bool: `word` alone
        kUnbounded,  // anything, NaN too
    };
    Kind kind = Kind::kUnbounded;
    float low = 0;
    float high = 0;
    std::uint32_t word = 0;
    // A number is a multiple of this power of two; 0 where nothing is known. It is what shows that
    // operations were fused which may not be: their result lies between what each may return, but
    // has digits that those have not.
    float quantum = 0;

    // Zeros of both signs are one value.
    bool Holds(std::uint32_t word) const;
};

// True where both profiles bound the program alike: they differ in nothing that it does.
bool BoundAlike(const Plan& plan, const Profile& a, const Profile& b);

// The bounds of all outputs, by columns: of output `o` at row `r`, [o * rows + r]. A row whose ways
// are more than the limits allow, or that fails as the evaluator would, is unbounded.
std::vector<Bound> BoundOutputs(std::shared_ptr<const Plan> plan,
                                const std::vector<Texture>& images, const Profile& profile,
                                std::uint32_t rows, std::span<const std::uint32_t> inputs,
                                std::uint32_t output_words, Limits limits = {});

}  // namespace etalon::evaluate
