#include "judge/budget.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "judge/judge.h"
#include "numeric/ulp.h"

namespace etalon {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kLargest = std::numeric_limits<float>::max();
constexpr double kLeastNormal = std::numeric_limits<float>::min();

double Distance(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) {
        return std::isnan(a) && std::isnan(b) ? 0 : kInfinity;
    }
    if (a == b) {
        return 0;
    }
    const double larger = std::max(std::fabs(a), std::fabs(b));
    const double smaller = std::min(std::fabs(a), std::fabs(b));
    if (!std::isinf(larger)) {
        return std::fabs(a - b);
    }
    const bool is_beyond = std::signbit(a) == std::signbit(b) && smaller >= kLargest;
    if (!is_beyond) {
        return kInfinity;
    }
    return std::max(0x1p128 - smaller, 0.0);
}

// The ulp in which the parts of a value are told.
double UnitOf(const Readings& readings) {
    for (const double x : {readings.truth.value_or(std::numeric_limits<double>::quiet_NaN()),
                           readings.method, readings.strict, readings.device}) {
        if (!std::isnan(x)) {
            return Ulp(x);
        }
    }
    return Ulp(0);
}

// The distance of a number from the nearest multiple of the quantum.
double OffGrid(const Allowed& allowed, double value) {
    return allowed.quantum == 0 || std::isinf(value)
               ? 0
               : std::fabs(std::remainder(value, static_cast<double>(allowed.quantum)));
}

Culprit DriverWhere(bool is_outside, bool is_unbounded) {
    if (is_outside) {
        return Culprit::kDriver;
    }
    return is_unbounded ? Culprit::kDriverUnstated : Culprit::kDriverAllowed;
}

std::uint32_t WordOf(Scalar scalar, double x) {
    switch (scalar) {
        case Scalar::kFloat:
            return std::bit_cast<std::uint32_t>(static_cast<float>(x));
        case Scalar::kInt:
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(x));
        case Scalar::kUint:
        case Scalar::kBool:
            break;
    }
    return static_cast<std::uint32_t>(x);
}

}  // namespace

double Excess(const Allowed& allowed, std::uint32_t word) {
    switch (allowed.kind) {
        case Allowed::Kind::kUnbounded:
            return 0;
        case Allowed::Kind::kWord:
            return word == allowed.word ? 0 : kInfinity;
        case Allowed::Kind::kNumber:
            break;
    }
    const auto value = std::bit_cast<float>(word);
    if (allowed.low <= value && value <= allowed.high) {
        return OffGrid(allowed, value) / Ulp(value);
    }
    if (!std::isfinite(value)) {
        return kInfinity;
    }
    const double end = value < allowed.low ? allowed.low : allowed.high;
    return std::fabs(value - end) / Ulp(end);
}

Judgement JudgeAllowed(const Allowed& allowed, std::uint32_t word) {
    ETALON_CHECK(allowed.kind != Allowed::Kind::kUnbounded);
    Judgement judgement;
    judgement.ulp_error = Excess(allowed, word);
    judgement.accepted = judgement.ulp_error == 0;
    if (allowed.kind == Allowed::Kind::kWord) {
        judgement.error = judgement.used = judgement.ulp_error;
        return judgement;
    }
    const double value = std::bit_cast<float>(word);
    const double low = allowed.low;
    const double high = allowed.high;
    const bool is_between = low <= value && value <= high;
    judgement.error = is_between ? OffGrid(allowed, value)
                                 : std::min(Distance(value, low), Distance(value, high));
    const double half = (high - low) / 2;
    const bool is_measured = half > 0 && std::isfinite(half) && std::isfinite(value);
    if (judgement.accepted) {
        const double used = is_measured ? std::fabs(value - (low + high) / 2) / half : 0;
        judgement.used = std::min(used, 1.0);
    } else if (is_measured && !is_between) {
        judgement.used = std::max(std::fabs(value - (low + high) / 2) / half, 1 + 0x1p-20);
    } else {
        judgement.used = kInfinity;
    }
    return judgement;
}

Parts PartsOf(Scalar scalar, const Readings& readings, bool flush) {
    const double unit = UnitOf(readings);
    const auto part = [scalar, unit](double distance) -> Part {
        const double wrong = distance == 0 ? 0 : kInfinity;
        return {distance, scalar == Scalar::kFloat ? distance / unit : wrong};
    };
    Parts parts;
    if (readings.truth) {
        const double distance = Distance(readings.method, *readings.truth);
        parts.method = part(
            std::isinf(readings.truth_error) ? 0 : std::max(distance - readings.truth_error, 0.0));
    }
    parts.rounding = part(Distance(readings.strict, readings.method));
    const bool is_flushed =
        flush && scalar == Scalar::kFloat && readings.device == 0 &&
        (std::fabs(readings.strict) < kLeastNormal || std::fabs(readings.method) < kLeastNormal);
    parts.driver = part(is_flushed ? 0 : Distance(readings.device, readings.strict));
    return parts;
}

std::string_view CulpritName(Culprit culprit) {
    switch (culprit) {
        case Culprit::kMethod:
            return "method";
        case Culprit::kRounding:
            return "rounding";
        case Culprit::kDriver:
            return "driver";
        case Culprit::kDriverAllowed:
            return "driver, within the specification";
        case Culprit::kDriverUnstated:
            return "driver, where the specification is silent";
    }
    return "";
}

Culprit CulpritOf(const Parts& parts, const Allowed& allowed, double excess) {
    if (parts.method.ulp >= parts.rounding.ulp && parts.method.ulp >= parts.driver.ulp) {
        return Culprit::kMethod;
    }
    if (parts.rounding.ulp >= parts.driver.ulp) {
        return Culprit::kRounding;
    }
    return DriverWhere(excess > 0, allowed.kind == Allowed::Kind::kUnbounded);
}

Judgement JudgeLawByMethod(const Law& law, Scalar scalar, const Sides<double>& method) {
    if (Holds(law.relation, method.left, method.right)) {
        return Judgement{.accepted = true};
    }
    return JudgeLaw(law, scalar, WordOf(scalar, method.left), WordOf(scalar, method.right));
}

Culprit CulpritOfLaw(const Law& law, Scalar scalar, const Sides<double>& method,
                     const Sides<std::uint32_t>& strict, const Sides<std::uint32_t>& device,
                     const Sides<Allowed>& allowed) {
    if (!JudgeLawByMethod(law, scalar, method).accepted) {
        return Culprit::kMethod;
    }
    if (!JudgeLaw(law, scalar, strict.left, strict.right).accepted) {
        return Culprit::kRounding;
    }
    return DriverWhere(
        Excess(allowed.left, device.left) > 0 || Excess(allowed.right, device.right) > 0,
        allowed.left.kind == Allowed::Kind::kUnbounded ||
            allowed.right.kind == Allowed::Kind::kUnbounded);
}

}  // namespace etalon
