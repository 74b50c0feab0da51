// How far the results of a point are from the truth.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "chart/family.h"
#include "report/chart_record.h"
#include "run/gathered.h"
#include "run/prepared_case.h"

namespace etalon {

// What was found at the rows of one scene, or of several.
struct Errors {
    std::uint64_t rows = 0;
    std::uint64_t undecided = 0;
    std::uint64_t not_finite = 0;
    std::uint64_t refused = 0;  // values
    std::uint64_t hits = 0;     // of the truth, in a search
    std::uint64_t missed = 0;
    std::uint64_t wrong = 0;
    bool shares_held = true;      // missed and wrong are within what is granted, in each scene
    std::vector<double> of_rows;  // the error of each row that has one
    double worst_absolute = 0;
    double greatest_truth = 0;         // magnitude, of the same rows
    double worst = 0;                  // of of_rows
    bool is_shown_off = false;         // `shown` is a wrong or missed hit
    std::optional<Observation> shown;  // see ChartAccuracy
    std::string shown_scene;           // where

    void Add(const Errors& other);
};

// The errors of a call's results at all rows of the case, in this measure: absolute, as a share of
// |truth| (infinite at a truth of 0 that is missed), or in ulp of the truth. Subnormals may count
// as zero; integers differ or are exact. A truth that is NaN, or whose own error has no bound, is
// undecided and left out, one component at a time.
Errors ErrorsOf(const PreparedCase& prepared, const Gathered& results, ErrorMeasure measure);

// `errors` is left in another order. `repeat` is empty.
ChartAccuracy AccuracyOf(Errors& errors);

}  // namespace etalon
