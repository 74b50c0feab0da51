#include "numeric/acceptance.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<float>::max();
// The largest binary64 below 2^-126: a truth of 2^-126 is normal and must not become zero.
constexpr double kLargestFlushed = 0x1.fffffffffffffp-127;

// A rule with nothing optional left: tolerances that are not granted are zero.
struct Grant {
    double ulp;
    double absolute;
    double relative;
    double flushed;  // reach of a zero result
    bool exact;

    explicit Grant(const Acceptance& rule)
        : ulp(rule.ulp.value_or(0)),
          absolute(rule.absolute.value_or(0)),
          relative(rule.relative.value_or(0)),
          flushed(rule.flush ? kLargestFlushed : 0),
          exact(!rule.ulp && !rule.absolute && !rule.relative) {}

    double At(double magnitude, double unit) const {
        return std::max(std::max(ulp * unit, absolute), relative * magnitude);
    }
};

float RoundToFloat(double x) {
    return static_cast<float>(x);
}

Judgement Refused() {
    return {false, kInfinity, kInfinity, kInfinity, Outcome::kRight};
}

Judgement JudgeOne(const Grant& grant, float value, double truth, double truth_error) {
    const double result = value;
    if (!std::isfinite(truth)) {
        const bool same = std::isnan(truth) ? std::isnan(result) : result == truth;
        return same || truth_error == kInfinity ? Judgement{.accepted = true} : Refused();
    }
    if (std::isnan(result)) {
        return Refused();
    }
    const double unit = Ulp(truth);
    const double tolerance = grant.At(std::fabs(truth), unit) + truth_error;
    Judgement judgement;
    judgement.error = std::fabs(result - truth);
    if (result == 0) {
        judgement.error = std::max(judgement.error - grant.flushed, 0.0);
    }
    if (grant.exact) {
        judgement.accepted = (value >= RoundToFloat(truth - truth_error) &&
                              value <= RoundToFloat(truth + truth_error)) ||
                             (result == 0 && judgement.error <= truth_error);
    } else {
        judgement.accepted = judgement.error <= tolerance && !std::isinf(result);
    }
    const bool saturated = std::fabs(result) >= kLargest && std::signbit(result) == (truth < 0) &&
                           std::fabs(truth) + tolerance > kLargest;
    if (saturated && (!judgement.accepted || std::isinf(result))) {
        judgement.accepted = true;
        judgement.error = std::max(kLargest - std::fabs(truth), 0.0);
    }
    judgement.ulp_error = judgement.error / unit;
    if (grant.exact || judgement.error == 0) {
        judgement.used = judgement.accepted ? 0 : kInfinity;
    } else {
        judgement.used = tolerance > 0 ? judgement.error / tolerance : kInfinity;
    }
    return judgement;
}

// The rows that one pass of the fast loop takes; and its lanes, which let the compiler keep the
// maxima in vectors although it may not reorder them.
constexpr std::size_t kBlock = 512;
constexpr std::size_t kLanes = 4;

// What a block of results holds, without saying where.
struct BlockMaxima {
    double ulp_error = 0;
    double used = 0;
    bool special = false;  // something is not finite: the maxima are void
};

// Where kErrors, the errors in ulp of all rows are left in `errors`.
template <bool kExact, bool kErrors, typename ErrorAt>
BlockMaxima Scan(const Grant& given, const float* values, const double* truths, std::size_t first,
                 std::size_t rows, const ErrorAt& error_at, double* errors) {
    const Grant grant = given;
    double ulp_error[kLanes] = {};
    double used[kLanes] = {};
    double poison[kLanes] = {};
    for (std::size_t row = first; row + kLanes <= first + rows; row += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            const double value = values[row + lane];
            const double truth = truths[row + lane];
            const double magnitude = std::fabs(truth);
            const double truth_error = error_at(row + lane, magnitude);
            // Ulp(), in a form that vectorises.
            double bounded = magnitude > 0x1p-125 ? magnitude : 0x1p-125;
            bounded = bounded < 0x1.fffffep127 ? bounded : 0x1.fffffep127;
            const double unit = std::bit_cast<double>(
                ((std::bit_cast<std::uint64_t>(bounded) - 1) & 0x7ff0000000000000u) -
                (std::uint64_t{23} << 52));
            const double plain = std::fabs(value - truth);
            poison[lane] += plain * 0;
            const double less = plain - (value == 0 ? grant.flushed : 0);
            const double error = less > 0 ? less : 0;
            const double in_ulp = error / unit;
            double share;
            if constexpr (kExact) {
                const double low = RoundToFloat(truth - truth_error);
                const double high = RoundToFloat(truth + truth_error);
                const double refused = error == 0 ? 0 : 2;
                share = value >= low && value <= high ? 0 : refused;
            } else {
                double tolerance = grant.ulp * unit;
                tolerance = tolerance > grant.absolute ? tolerance : grant.absolute;
                const double relative = grant.relative * magnitude;
                tolerance = tolerance > relative ? tolerance : relative;
                tolerance += truth_error;
                tolerance = tolerance > 5e-324 ? tolerance : 5e-324;
                share = error / tolerance;
            }
            if constexpr (kErrors) {
                errors[row - first + lane] = in_ulp;
            }
            ulp_error[lane] = in_ulp > ulp_error[lane] ? in_ulp : ulp_error[lane];
            used[lane] = share > used[lane] ? share : used[lane];
        }
    }
    BlockMaxima maxima;
    maxima.special = rows % kLanes != 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        maxima.ulp_error = std::max(maxima.ulp_error, ulp_error[lane]);
        maxima.used = std::max(maxima.used, used[lane]);
        maxima.special = maxima.special || poison[lane] != 0;
    }
    return maxima;
}

// Counts the errors of a block. Neighbours mostly fall into one bin, and a counter that was just
// written is slow to read: hence one for each lane.
void Count(const double* errors, std::size_t rows, UlpHistogram& histogram) {
    std::uint32_t counts[kLanes][UlpHistogram::kBins] = {};
    for (std::size_t row = 0; row < rows; row += kLanes) {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
            ++counts[lane][UlpHistogram::BinOf(errors[row + lane])];
        }
    }
    for (const auto& lane : counts) {
        for (std::size_t bin = 0; bin < UlpHistogram::kBins; ++bin) {
            histogram.counts()[bin] += lane[bin];
        }
    }
}

template <bool kErrors, typename ErrorAt>
void JudgeBlocks(const Acceptance& rule, std::span<const float> values,
                 std::span<const double> truths, std::uint64_t first, Summary& summary,
                 UlpHistogram* histogram, const ErrorAt& error_at) {
    ETALON_CHECK(values.size() == truths.size());
    const Grant grant(rule);
    double errors[kErrors ? kBlock : 1];
    const auto judge = [&](std::size_t row) {
        return JudgeOne(grant, values[row], truths[row], error_at(row, std::fabs(truths[row])));
    };
    // Where the worst lies is looked up once, at the end, in the blocks that hold it.
    constexpr std::size_t kNowhere = ~std::size_t{0};
    std::size_t worst_ulp_block = kNowhere;
    std::size_t worst_used_block = kNowhere;
    double worst_ulp_error = summary.worst_ulp_error;
    double worst_used = summary.worst_used;
    for (std::size_t at = 0; at < values.size(); at += kBlock) {
        const std::size_t rows = std::min(kBlock, values.size() - at);
        const BlockMaxima maxima = grant.exact
                                       ? Scan<true, kErrors>(grant, values.data(), truths.data(),
                                                             at, rows, error_at, errors)
                                       : Scan<false, kErrors>(grant, values.data(), truths.data(),
                                                              at, rows, error_at, errors);
        if (maxima.special || maxima.used > 1) {
            for (std::size_t row = at; row < at + rows; ++row) {
                const Judgement judgement = judge(row);
                summary.Add(first + row, judgement);
                if constexpr (kErrors) {
                    histogram->Add(judgement.ulp_error);
                }
            }
            continue;
        }
        summary.judged += rows;
        if constexpr (kErrors) {
            Count(errors, rows, *histogram);
        }
        if (maxima.ulp_error > worst_ulp_error) {
            worst_ulp_error = maxima.ulp_error;
            worst_ulp_block = at;
        }
        if (maxima.used > worst_used) {
            worst_used = maxima.used;
            worst_used_block = at;
        }
    }
    for (const std::size_t block : {worst_ulp_block, worst_used_block}) {
        for (std::size_t row = block; row < values.size() && row - block < kBlock; ++row) {
            summary.Compare(first + row, judge(row));
        }
    }
}

}  // namespace

std::string Acceptance::Text() const {
    std::string text;
    const auto add = [&text](const char* name, const std::optional<double>& tolerance) {
        if (tolerance) {
            text += text.empty() ? "" : " or ";
            text += name + Shortest(*tolerance);
        }
    };
    add("ulp ", ulp);
    add("absolute ", absolute);
    add("relative ", relative);
    if (text.empty()) {
        text = "exact";
    }
    if (shares) {
        if (shares->beyond) {
            text += ", missed " + Shortest(shares->missed);
        }
        text += ", wrong " + Shortest(shares->wrong);
        if (shares->beyond) {
            text += ", beyond " + Shortest(*shares->beyond);
        }
    }
    return flush ? text : text + ", no flush";
}

double Tolerance(const Acceptance& rule, double truth) {
    return std::isfinite(truth) ? Grant(rule).At(std::fabs(truth), Ulp(truth)) : 0;
}

Judgement Judge(const Acceptance& rule, float value, double truth, double truth_error) {
    return JudgeOne(Grant(rule), value, truth, truth_error);
}

bool IsBlind(const Acceptance& rule, double truth, double truth_error) {
    const float right = RoundToFloat(truth);
    for (const double candidate : {0.0, -truth, 2 * truth, truth + 1}) {
        const float wrong = RoundToFloat(candidate);
        const bool differs = wrong != right && !std::isnan(wrong);
        if (differs && !Judge(rule, wrong, truth, truth_error).accepted) {
            return false;
        }
    }
    return true;
}

void Summary::Add(std::uint64_t index, const Judgement& judgement) {
    ++judged;
    if (!judgement.accepted) {
        ++refused;
        first_refused = std::min(first_refused, index);
    }
    Compare(index, judgement);
}

void Summary::Compare(std::uint64_t index, const Judgement& judgement) {
    const auto keep = [index](double value, double& worst, std::uint64_t& at) {
        if (value > worst || (value == worst && worst > 0 && index < at)) {
            worst = value;
            at = index;
        }
    };
    keep(judgement.ulp_error, worst_ulp_error, worst_ulp_at);
    keep(judgement.used, worst_used, worst_used_at);
}

void Summary::Add(const Summary& other) {
    judged += other.judged;
    refused += other.refused;
    first_refused = std::min(first_refused, other.first_refused);
    Compare(other.worst_ulp_at, {.ulp_error = other.worst_ulp_error});
    Compare(other.worst_used_at, {.used = other.worst_used});
}

void JudgeAll(const Acceptance& rule, std::span<const float> values, std::span<const double> truths,
              std::span<const double> truth_errors, std::uint64_t first, Summary& summary,
              UlpHistogram* histogram) {
    ETALON_CHECK(truth_errors.size() == truths.size());
    const auto error_at = [errors = truth_errors.data()](std::size_t row, double) {
        return errors[row];
    };
    const auto judge = histogram == nullptr ? JudgeBlocks<false, decltype(error_at)>
                                            : JudgeBlocks<true, decltype(error_at)>;
    judge(rule, values, truths, first, summary, histogram, error_at);
}

void JudgeAll(const Acceptance& rule, std::span<const float> values, std::span<const double> truths,
              double relative_bound, double absolute_bound, std::uint64_t first, Summary& summary,
              UlpHistogram* histogram) {
    const double relative = relative_bound / (1 - relative_bound);
    const double absolute = absolute_bound / (1 - relative_bound);
    const auto error_at = [relative, absolute](std::size_t, double magnitude) {
        return magnitude < kInfinity ? relative * magnitude + absolute : 0;
    };
    const auto judge = histogram == nullptr ? JudgeBlocks<false, decltype(error_at)>
                                            : JudgeBlocks<true, decltype(error_at)>;
    judge(rule, values, truths, first, summary, histogram, error_at);
}

double TruthError(double truth, double relative_bound, double absolute_bound) {
    return std::isfinite(truth)
               ? (relative_bound * std::fabs(truth) + absolute_bound) / (1 - relative_bound)
               : 0;
}

}  // namespace etalon
