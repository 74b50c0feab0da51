// What an evaluation over intervals carries beside values: which way each lane goes where a
// comparison, a conversion to an integer or a bit cast is undecided.
//
// The bits of a float that is not decided are a range of words of one sign, as long as nothing more
// is done to them than what keeps it one: they are what code sets limits in that no NaN passes. Any
// other use of such a word decides it.
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
    std::vector<std::uint8_t> taken;
    std::vector<std::uint8_t> alternatives;  // how many there were, choice by choice
    std::size_t at = 0;
};

inline constexpr std::uint32_t kSignBit = 0x80000000;

// All words from first to last; both have the same highest bit.
struct WordRange {
    std::uint32_t first = 0;
    std::uint32_t last = 0;

    bool IsPoint() const { return first == last; }
};

// The least and the greatest of each channel.
using TexelRange = std::array<std::pair<float, float>, 4>;

template <>
struct Context<Interval> {
    std::array<Way, kLanes> ways;
    std::size_t most_choices = 0;  // on one way, and alternatives of one choice; more, and the
                                   // lane is lost
    Mask lost;                     // lanes whose results are unbounded
    std::span<Bound> bounds;       // of all outputs, as Rows::outputs
    std::vector<bool> is_stored;   // of `bounds`
    std::map<std::pair<const Image*, std::uint32_t>, TexelRange> levels;  // found so far

    bool has_ranges = false;
    std::vector<Mask> open;            // by column of words: lanes where they are ranges
    std::vector<std::uint32_t> lasts;  // of the ranges, as Machine::words

    void Lose(std::uint32_t lane) { lost.Add(lane); }
    // One of 0 .. alternatives - 1.
    std::uint32_t Decide(std::uint32_t lane, std::uint64_t alternatives);
    // The integer that a value becomes, where it may be any in [low, high]; undefined beyond
    // [least, most].
    std::int64_t DecideInteger(std::uint32_t lane, double low, double high, double least,
                               double most);
    // Adds to the hull of the output at `place`.
    void Store(std::size_t place, const Bound& bound);
    // Of one level, all faces.
    const TexelRange& RangeOf(const Image& image, std::uint32_t level);
    // Of one lane.
    WordRange RangeAt(Machine<Interval>& m, std::uint32_t column, std::uint32_t lane);
    void SetRange(Machine<Interval>& m, std::uint32_t column, std::uint32_t lane, WordRange range);
    // Of the lanes at work.
    void CopyRange(Machine<Interval>& m, std::uint32_t from, std::uint32_t to);
    void Close(Machine<Interval>& m, std::uint32_t column);
    // At the start of a run no word is a range.
    void Forget();
    // Before a step: what was in its result's place is of no use any more.
    void Before(Machine<Interval>& m, const Step& step);
    // After a step: loses lanes where its result is undefined; of what is decorated
    // RelaxedPrecision nothing is known, and NoContraction has been rounded by itself.
    void After(Machine<Interval>& m, const Step& step);
};

}  // namespace etalon::evaluate
