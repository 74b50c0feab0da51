// CaseMap: over which two inputs a case is mapped, and what theory says of the picture.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "case/expression.h"
#include "case/place.h"

namespace etalon {

// low < high, both finite; of a logarithmic one low > 0.
struct MapRange {
    double low = 0;
    double high = 0;
    bool is_log = false;
};

// What must come out in a cell where the expression, over the inputs, is true.
struct MapPrediction {
    Expression expression;
    Place place;
};

struct CaseMap {
    std::string x;  // two different inputs of type float, int or uint
    std::string y;
    std::map<std::string, MapRange> ranges;  // in place of the input's own
    std::string at;                          // the other inputs: "n1=1.6"; else their first value
    std::uint32_t width = 96;                // cells
    std::uint32_t height = 64;
    std::string output;  // the output, its component, or the law that is mapped; empty: all
                         // outputs, or where there is none all laws
    std::string spent;   // GLSL over the inputs: true where the iteration budget was used up; or
                         // empty
    std::optional<MapPrediction> fails;  // no cell is accepted
    std::optional<MapPrediction> safe;   // every cell is accepted
    std::string because;                 // the theory, where something is predicted
    Place place;
    Place at_place;
    Place output_place;
    Place spent_place;
};

// The most cells along one axis.
inline constexpr std::uint32_t kMostMapCells = 1024;

}  // namespace etalon
