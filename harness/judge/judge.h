// Judges columns of results. Never sees a device.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "case/case.h"
#include "numeric/acceptance.h"
#include "numeric/number_text.h"
#include "numeric/tally.h"

namespace etalon {

// The truth of one output column at every row of a table.
struct Truth {
    // What a device may take for the truth at a row with subnormal inputs: the truth at zeros in
    // their place.
    struct Alternative {
        std::uint64_t row = 0;
        double value = 0;
        double error = 0;
    };
    std::vector<double> values;
    std::vector<double> errors;             // the oracle's own bounds, one each
    std::vector<Alternative> alternatives;  // ascending rows
};

// Judges words[i], of row first_row + i, against the truth at that row. Floats by the rule; int,
// uint and bool must be equal. The summary's indices are rows; the errors go into the histogram
// too, where there is one. For rules without shares.
void JudgeColumn(const Acceptance& rule, Scalar scalar, std::span<const std::uint32_t> words,
                 const Truth& truth, std::uint64_t first_row, Summary& summary,
                 UlpHistogram* histogram = nullptr);

// The same under a rule with shares: adds to the tally, which is settled after the last row.
void TallyColumn(const Acceptance& rule, Scalar scalar, std::span<const std::uint32_t> words,
                 const Truth& truth, std::uint64_t first_row, Tally& tally);

// The judgement of a single value, as JudgeColumn and TallyColumn make it.
Judgement JudgeValue(const Acceptance& rule, Scalar scalar, std::uint32_t word, const Truth& truth,
                     std::uint64_t row);

// The relation itself, without tolerance; false for a NaN.
bool Holds(Relation relation, double left, double right);

// Judges `left relation right`. A NaN on either side breaks every law.
Judgement JudgeLaw(const Law& law, Scalar scalar, std::uint32_t left, std::uint32_t right);

}  // namespace etalon
