#include "cost/estimate.h"

#include <algorithm>
#include <limits>

#include "base/check.h"

namespace etalon {
namespace {

double LowerQuartile(std::vector<double> values) {
    const auto quartile = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 4);
    std::nth_element(values.begin(), quartile, values.end());
    return *quartile;
}

std::vector<double> Part(const std::vector<double>& values, std::size_t part) {
    std::vector<double> chosen;
    for (std::size_t i = part; i < values.size(); i += kParts) {
        chosen.push_back(values[i]);
    }
    return chosen;
}

double SecondsOf(const LoopTimes& times, double evaluations) {
    return std::max(0.0, LowerQuartile(times.full) - LowerQuartile(times.less)) / evaluations;
}

}  // namespace

double LoopEstimate::Spread() const {
    return seconds > 0 ? (high - low) / seconds : std::numeric_limits<double>::infinity();
}

LoopEstimate Estimate(const LoopTimes& times, double evaluations) {
    ETALON_CHECK(times.full.size() == times.less.size() && times.full.size() >= kParts);
    LoopEstimate estimate;
    estimate.seconds = SecondsOf(times, evaluations);
    estimate.low = estimate.seconds;
    estimate.high = estimate.seconds;
    for (std::size_t part = 0; part < kParts; ++part) {
        const double alone =
            SecondsOf({Part(times.full, part), Part(times.less, part)}, evaluations);
        estimate.low = std::min(estimate.low, alone);
        estimate.high = std::max(estimate.high, alone);
    }
    return estimate;
}

}  // namespace etalon
