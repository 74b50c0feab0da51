// Acceptance: the rule that judges one result against its truth. Acceptance is an interval around
// the truth.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "numeric/number_text.h"

namespace etalon {

// Every tolerance given is enough by itself: a result passes where any of them holds. With none of
// them only the exact value passes (for float: the truth rounded to nearest; -0 equals +0).
struct Acceptance {
    std::optional<double> ulp;  // of the truth, see Ulp()
    std::optional<double> absolute;
    std::optional<double> relative;  // of |truth|
    bool flush = true;               // a device may take subnormal inputs and results as zero (all
                                     // specifications allow it)

    std::string Text() const;  // "ulp 16 or absolute 1e-09"
};

// What a judged result is worth.
struct Judgement {
    bool accepted = false;
    double error = 0;      // |value - truth|; infinity for NaN and wrong infinities
    double ulp_error = 0;  // the same in ulp(truth)
    double used = 0;       // share of the tolerance used: error / tolerance; 0 exact, > 1 refused
};

// The widest tolerance that the rule grants at this truth, in absolute terms; 0 for an exact rule.
double Tolerance(const Acceptance& rule, double truth);

// Judges a float. `truth_error` is the oracle's own bound at this truth; it widens the tolerance,
// so that no device is blamed for the oracle. A NaN result is never accepted for a truth that is a
// number; an infinite one only for an infinite truth, or where the tolerance reaches past the
// largest float.
Judgement Judge(const Acceptance& rule, float value, double truth, double truth_error);

// The reason why nothing could fail under this rule at this truth, if so: each of 0, -truth, 2
// truth and truth + 1 that differs from the truth would be accepted.
bool IsBlind(const Acceptance& rule, double truth);

}  // namespace etalon
