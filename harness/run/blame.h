// Blame: what a record tells beside its judgement. Which values the device's specification does not
// allow, whose fault the refused ones are, and what the error of all is made of.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "judge/budget.h"
#include "report/record.h"
#include "run/evaluation.h"
#include "run/prepared_case.h"

namespace etalon {

// Of one call's results on one device. Where the program cannot be evaluated the record says why,
// and nothing is added.
class Blame {
  public:
    // All must outlive it.
    Blame(Evaluation& evaluation, const Table& table, const evaluate::Profile& profile,
          Record& record);

    // The words of a column, or of a law's sides, at all rows, of which so many were refused.
    void AddColumn(const JudgedColumn& column, std::span<const std::uint32_t> words,
                   std::uint64_t refused);
    void AddLaw(const PreparedLaw& law, std::size_t pair, std::span<const std::uint32_t> left,
                std::span<const std::uint32_t> right, std::uint64_t refused);

    // Adds the budget, and what is allowed where that is not told yet, to the observation of a row.
    // `is_refused`: there is somebody to blame.
    void Explain(const JudgedColumn& column, std::uint32_t word, std::uint64_t row, bool is_refused,
                 Observation& observation);
    void ExplainLaw(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                    std::uint32_t right, std::uint64_t row, bool is_refused,
                    Observation& observation);

  private:
    bool IsKnown() const { return values_ != nullptr && bounds_ != nullptr; }
    std::size_t IndexOf(std::size_t column, std::uint64_t row) const {
        return column * table_.rows + row;
    }
    const Allowed& AllowedAt(std::size_t column, std::uint64_t row) const {
        return bounds_->allowed[IndexOf(column, row)];
    }
    // M by binary64.
    Readings ReadingsAt(const JudgedColumn& column, std::uint32_t word, std::uint64_t row) const;
    // M by Big.
    Parts ExactParts(const JudgedColumn& column, std::uint32_t word, std::uint64_t row);
    Culprit LawCulprit(const PreparedLaw& law, std::size_t pair, std::uint32_t left,
                       std::uint32_t right, std::uint64_t row, const Sides<double>& method) const;
    void AddParts(const JudgedColumn& column, std::span<const std::uint32_t> words, bool blames);
    void AddWorstPart(WorstPart worst, std::uint64_t row);
    // Holds values to the specification. `what` failed where one is outside; `column` tells of it.
    void Hold(const std::string& what, const JudgedColumn& column,
              std::span<const std::uint32_t> words);
    void Count(Culprit culprit, std::uint64_t values = 1);

    Evaluation& evaluation_;
    const Table& table_;
    Record& record_;
    const Evaluation::Values* values_ = nullptr;
    const Evaluation::Bounds* bounds_ = nullptr;
};

}  // namespace etalon
