// What an evaluation over intervals carries beside values: which way each lane goes where a
// comparison, a conversion to an integer or a bit cast is undecided.
//
// A lane runs with the choices of its way so far and takes the first alternative wherever it meets
// a new one. Who drives the lanes (bound.cc) then sends others along the alternatives that are
// left.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "evaluate/bound.h"
#include "evaluate/interval.h"
#include "evaluate/machine.h"

namespace etalon::evaluate {

struct Way {
    // More alternatives in one place, and the lane is lost.
    static constexpr std::uint32_t kMostAlternatives = 64;

    std::vector<std::uint8_t> taken;
    std::vector<std::uint8_t> alternatives;  // how many there were, choice by choice
    std::size_t at = 0;
};

// The least and the greatest of each channel.
using TexelRange = std::array<std::pair<float, float>, 4>;

template <>
struct Context<Interval> {
    std::array<Way, kLanes> ways;
    std::size_t most_choices = 0;  // on one way; more, and the lane is lost
    Mask lost;                     // lanes whose results are unbounded
    std::span<Bound> bounds;       // of all outputs, as Rows::outputs
    std::vector<bool> is_stored;   // of `bounds`
    std::map<std::pair<const Image*, std::uint32_t>, TexelRange> levels;  // found so far

    void Lose(std::uint32_t lane) { lost.Add(lane); }
    // One of 0 .. alternatives - 1.
    std::uint32_t Decide(std::uint32_t lane, std::uint64_t alternatives);
    // The integer that a value becomes, where it may be any in [low, high].
    std::int64_t DecideInteger(std::uint32_t lane, double low, double high);
    // Adds to the hull of the output at `place`.
    void Store(std::size_t place, const Bound& bound);
    // Of one level, all faces.
    const TexelRange& RangeOf(const Image& image, std::uint32_t level);
    // After a step: what is decorated NoContraction has been rounded by itself.
    void After(Machine<Interval>& m, const Step& step) const;
};

}  // namespace etalon::evaluate
