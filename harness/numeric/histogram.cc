#include "numeric/histogram.h"

#include <cmath>
#include <limits>
#include <numeric>

#include "base/check.h"

namespace etalon {

double UlpHistogram::Upper(std::size_t bin) {
    ETALON_CHECK(bin < kBins);
    if (bin == 0) {
        return 0;
    }
    const int binade = kLeast + static_cast<int>(bin) - 1;
    return binade > kMost ? std::numeric_limits<double>::infinity() : std::ldexp(1.0, binade);
}

void UlpHistogram::Add(const UlpHistogram& other) {
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        counts_[bin] += other.counts_[bin];
    }
}

std::uint64_t UlpHistogram::Total() const {
    return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

}  // namespace etalon
