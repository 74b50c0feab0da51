// A record as a person reads it.
#pragma once

#include <string>

#include "report/record.h"

namespace etalon {

// Case, device, recipe, input, both values in decimal and hexadecimal, error, rule, whose fault it
// is, and the command that repeats it.
std::string FailureText(const Record& record);

// "figure absolute 2.57115 within 0.01, saw 2.571149"; empty for a record without figures.
std::string FiguresText(const Record& record);

// "method 0 ulp, rounding 3.2 ulp, driver 0.5 ulp"; of a law "method holds, strict evaluation
// breaks it by 2 ulp, device breaks it by 3 ulp".
std::string BudgetText(const Budget& budget);

// "parts at most method 0.2 ulp, rounding 3.2 ulp"; empty where all are 0 or not known.
std::string PartsText(const Record& record);

// "result.x: 3.2 ulp (20 % of the tolerance) at n1=1, cos_i=0.5".
std::string WorstText(const Observation& observation);

// "result: missed 3 of 900 (0.333 %, 1 % allowed), wrong 4 of 1000 (0.4 %, 1 % allowed), worst
// right hit off by 0.013, undecided 2".
std::string ShareText(const ShareCount& count);

// The table at the end of a run: verdicts by device, the worst margins, how many values were held
// to which specification, what could not be evaluated, skips and known failures with their causes.
std::string SummaryText(const RunRecord& run);

// The `count` cases that took longest: seconds over all devices and recipes and the preparation,
// their share of what all cases took together, and the preparation alone. Several devices work at
// the same time, so that a run takes less than the sum.
std::string SlowestText(const RunRecord& run, std::size_t count);

// The table of `etalon devices`.
std::string DevicesText(const RunRecord& run, bool with_absent);

// An error in ulp or another magnitude, short: "0", "3.21", "1.5e+07".
std::string ShortNumber(double value);

}  // namespace etalon
