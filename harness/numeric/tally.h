// Judges columns of which a share may be off altogether: the hits of searches, and exact values.
#pragma once

#include "numeric/acceptance.h"

namespace etalon {

// Judges one value under a rule with shares. Accepted is what is right and within the tolerance,
// and what is undecided; the error, in every unit, of a missed, a phantom and a NaN is infinite,
// and so is what any value that is not right has used.
Judgement JudgeShared(const Acceptance& rule, float value, double truth, double truth_error);
// The same for int, uint and bool: equal, or wrong.
Judgement JudgeSharedExact(double value, double truth);

// What a column under such a rule holds, over any number of chunks.
struct Tally {
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};

    std::uint64_t decided = 0;
    std::uint64_t undecided = 0;
    std::uint64_t hits = 0;  // truths
    std::uint64_t missed = 0;
    std::uint64_t wrong = 0;
    std::uint64_t first_missed = kNone;  // index
    std::uint64_t first_wrong = kNone;
    double worst_wrong_error = 0;
    std::uint64_t worst_wrong_at = kNone;  // the first index of the worst
    double worst_right_error = 0;          // absolute, of the right hits, refused ones included
    Summary right;                         // the right ones by the tolerance

    void Add(std::uint64_t index, const Judgement& judgement);

    double MissedShare() const;  // of the hits; 0 where there are none
    double WrongShare() const;

    // The column's verdict, after its last chunk. Where a share is exceeded all its values are
    // refused and the worst is one of them: the wrong one of the greatest error, else the first
    // missed; it has used infinitely much. Else the worst is the right one that used most of its
    // tolerance, or the example of the share that used more of what is allowed.
    Summary Settle(const Shares& shares) const;
};

}  // namespace etalon
