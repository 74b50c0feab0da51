// What the cells of a map are worth on one device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "map/map_plan.h"
#include "run/runner.h"

namespace etalon {

// The results of one device, by output columns over all cells.
struct MapResults {
    std::vector<std::vector<std::uint32_t>> outputs;            // of the call
    std::vector<std::vector<std::vector<std::uint32_t>>> laws;  // by law
    std::vector<std::uint32_t> spent;                           // empty without that condition
};

Result<MapResults, EvaluationFailure> RunCells(const MapPlan& plan, Runner& runner,
                                               const Recipe& recipe);

// "ulp", else "absolute", else "relative": the first of them by which the mapped thing is judged;
// "absolute" where it must be exact.
std::string MeasureOf(const MapPlan& plan);
// The rules, each once: "ulp 4".
std::string ToleranceOf(const MapPlan& plan);
// What is mapped: "result.x, result.y".
std::string OutputOf(const MapPlan& plan);

// Fills error, mark and worst. Of several outputs, components or laws a cell has the worst mark, in
// the order nan, infinity, spent, missed, wrong, refused, undecided, holds; and the greatest error.
void JudgeCells(const MapPlan& plan, const MapResults& results, MappedDevice& device);

// True at the cells where no device can be right or wrong: `where` leaves them out, or the oracle
// has no truth, or no bound on its error.
std::vector<bool> UndecidedCells(const MapPlan& plan);

// The greatest distance in ulp between any two of the results, over all mapped columns: 0 for equal
// ones and where both are NaN, infinite where one alone is NaN or infinite, or where they are
// different integers.
std::vector<double> Disagreement(const MapPlan& plan, const std::vector<const MapResults*>& all);

}  // namespace etalon
