// Acceptance: the rule that judges one result against its truth. Acceptance is an interval around
// the truth.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "numeric/histogram.h"
#include "numeric/number_text.h"

namespace etalon {

// How many of a column's values may be off altogether. A column is then judged as a whole: it fails
// where a share is exceeded, or where any other value is beyond the tolerance.
//
// With `beyond` the column is what a search returns: the way to a hit along a ray; a negative
// number says that nothing is met.
// - missed: the truth is a hit and the result is none. Their share is of the truths that are hits.
// - wrong: the truth is none and the result a hit; or the result is further than `beyond` from the
//   truth, that is another hit than the first; or NaN. Their share is of all rows.
// - right: both are none; or both are hits, and the tolerance holds for their distance.
// Without `beyond` the rule is exact, and wrong is every value that is not the truth.
// A truth of NaN is undecided: its row is left out and counted.
struct Shares {
    double missed = 0;             // 0 .. < 0.5
    double wrong = 0;              // 0 .. < 0.5
    std::optional<double> beyond;  // in the result's unit
};

// Every tolerance given is enough by itself: a result passes where any of them holds. With none of
// them only the exact value passes (for float: the truth rounded to nearest; -0 equals +0).
struct Acceptance {
    std::optional<double> ulp;  // of the truth, see Ulp()
    std::optional<double> absolute;
    std::optional<double> relative;  // of |truth|
    bool flush = true;               // a device may take subnormal inputs and results as zero (all
                                     // specifications allow it)
    std::optional<Shares> shares;  // judged by tally.h; Judge and JudgeAll know single values only

    std::string Text() const;  // "ulp 16 or absolute 1e-09, missed 0.01, wrong 0, beyond 2"
};

// What a value is under a rule with shares.
enum class Outcome : std::uint8_t { kNone, kRight, kMissed, kPhantom, kOther, kUndecided };

// What a judged result is worth.
struct Judgement {
    bool accepted = false;
    double error = 0;      // |value - truth|; infinity for NaN and wrong infinities
    double ulp_error = 0;  // the same in ulp(truth)
    double used = 0;       // share of the tolerance used: error / tolerance; 0 exact, > 1 refused
    Outcome outcome = Outcome::kRight;
};

// The widest tolerance that the rule grants at this truth, in absolute terms; 0 for an exact rule,
// and for a truth that is not finite.
double Tolerance(const Acceptance& rule, double truth);

// Judges a float. `truth_error` is the oracle's own bound at this truth; it widens the tolerance,
// so that no device is blamed for the oracle.
//
// - A NaN result is accepted only for a truth that is NaN (the quantity has no value there), and
//   then nothing else is. A truth that is infinite accepts that infinity alone.
// - Where truth and tolerance reach past the largest float, the infinity of that sign and the
//   largest float are accepted; their error is what the largest float lacks to the truth.
// - With `flush` a zero of either sign stands for every subnormal: its error is the truth's
// distance
//   from the nearest value below 2^-126 in magnitude.
// - An exact rule accepts the truth rounded to nearest, for any truth within `truth_error`; `used`
//   is then 0 or infinity.
Judgement Judge(const Acceptance& rule, float value, double truth, double truth_error);

// True where nothing could fail under this rule at this truth: each of 0, -truth, 2 truth and
// truth + 1 that differs from the truth would be accepted. Shares are not looked at.
bool IsBlind(const Acceptance& rule, double truth, double truth_error = 0);

// What many judged results are worth together.
struct Summary {
    static constexpr std::uint64_t kNone = ~std::uint64_t{0};

    std::uint64_t judged = 0;
    std::uint64_t refused = 0;
    std::uint64_t first_refused = kNone;  // index
    double worst_ulp_error = 0;
    std::uint64_t worst_ulp_at = kNone;  // the first index of the worst; kNone where all are exact
    double worst_used = 0;
    std::uint64_t worst_used_at = kNone;

    void Add(std::uint64_t index, const Judgement& judgement);
    // Keeps the worst only, without counting.
    void Compare(std::uint64_t index, const Judgement& judgement);
    // What both say together, whichever of them comes first.
    void Add(const Summary& other);

    friend bool operator==(const Summary&, const Summary&) = default;
};

// Judges values[i] against truths[i] under the index first + i, as Judge would, and adds to the
// summary, and where there is one to the histogram. The truths' own errors are one bound each (as
// many as truths), or the relative and absolute bound of their oracle.
void JudgeAll(const Acceptance& rule, std::span<const float> values, std::span<const double> truths,
              std::span<const double> truth_errors, std::uint64_t first, Summary& summary,
              UlpHistogram* histogram = nullptr);
void JudgeAll(const Acceptance& rule, std::span<const float> values, std::span<const double> truths,
              double relative_bound, double absolute_bound, std::uint64_t first, Summary& summary,
              UlpHistogram* histogram = nullptr);

// The bound on |truth - exact| of a truth whose oracle states its bounds relative to the exact
// value; 0 where the truth is not finite.
double TruthError(double truth, double relative_bound, double absolute_bound);

}  // namespace etalon
