// What many runs of a loop and of the same loop with fewer calls say of the time of one evaluation.
#pragma once

#include <vector>

namespace etalon {

// Seconds of each run, in the order of the rounds: as many of either.
struct LoopTimes {
    std::vector<double> full;
    std::vector<double> less;
};

struct LoopEstimate {
    double seconds = 0;
    double low = 0;
    double high = 0;

    double Spread() const;  // (high - low) / seconds; infinite where that is 0
};

// Rounds are dealt to so many parts, one to each in turn.
inline constexpr std::size_t kParts = 4;

// The lower quartile of the full loop's times less that of the other one's, for each of the
// `evaluations` that the other has not, never below 0. Noise makes most of what it touches slower,
// now and then something faster; so neither the mean nor the least is to be believed. `low` and
// `high` are the least and greatest that any part of the rounds says alone, or all together. At
// least kParts rounds.
LoopEstimate Estimate(const LoopTimes& times, double evaluations);

}  // namespace etalon
