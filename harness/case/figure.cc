#include "case/figure.h"

#include <cmath>

#include "numeric/number_text.h"

namespace etalon {

std::string Figure::Text() const {
    return std::string(kMeasureNames[static_cast<int>(measure)]) + " " + Shortest(value) +
           " within " + Shortest(within);
}

bool Figure::Agrees(double seen) const {
    if (std::isnan(value) || std::isnan(seen)) {
        return std::isnan(value) && std::isnan(seen);
    }
    return seen == value || std::fabs(seen - value) <= within * std::fabs(value);
}

}  // namespace etalon
