// The error budget of one value: how |result - truth| came about, and so whose fault it is.
//
//   method    |M - T|   the formula is not the physics
//   rounding  |R - M|   the formula loses digits at this input
//   driver    |D - R|   the device does not follow the program's strict reading
//
// T is the truth, M the program without rounding, R the program in binary32 with each operation
// rounded correctly in source order, D what the device returned.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "case/case.h"
#include "numeric/acceptance.h"
#include "numeric/number_text.h"

namespace etalon {

// What a conforming implementation may return for one value.
struct Allowed {
    enum class Kind : std::uint8_t {
        kNumber,     // a float from low to high; an infinite end is allowed itself
        kWord,       // `word` alone
        kUnbounded,  // the specification is silent, or the bound grew past use
    };
    Kind kind = Kind::kUnbounded;
    float low = 0;
    float high = 0;
    std::uint32_t word = 0;
    float quantum = 0;  // a number is a multiple of this power of two; 0 where nothing is known
};

// How far a result lies outside, in ulp of the nearer end: 0 inside and where there is no bound;
// infinity for a NaN, for an infinity that is not allowed, and for a word that is another. Of a
// number between the ends that is no multiple of the quantum, the distance to the nearest one in
// its own ulp. Zeros of both signs are one value.
double Excess(const Allowed& allowed, std::uint32_t word);

// Judges by what is allowed alone. `used` is the distance from the interval's middle as a share of
// half its width: at most 1 inside; 0 inside an interval that is a point, a word or infinite;
// infinity for what is no multiple of the quantum. The errors are Excess and the same in absolute
// terms. Not for what is unbounded.
Judgement JudgeAllowed(const Allowed& allowed, std::uint32_t word);

// One value by all readings. Numbers of ints, uints and bools are those of WordValue.
struct Readings {
    std::optional<double> truth;  // nothing where there is no oracle
    double truth_error = 0;       // the oracle's own bound, which no method is blamed for
    double method = 0;
    double strict = 0;
    double device = 0;
};

struct Part {
    double absolute = 0;
    double ulp = 0;  // of the truth
};

struct Parts {
    Part method;  // nothing where there is no truth
    Part rounding;
    Part driver;
};

// The parts of a value. An ulp is that of the truth; where that is missing or NaN, of the first
// number among M, R and D.
//   - A NaN is infinitely far from a number and at no distance from a NaN; so is an infinity from
//     numbers and from itself. But an infinity stands for all that is beyond the largest float, and
//     lies at 2^128 for the largest float itself.
//   - With `flush` the driver has no part in a zero where R or M is below 2^-126: a device may take
//     subnormal results as zero.
//   - What is no float is right or wrong: its parts are 0 or infinite in ulp.
Parts PartsOf(Scalar scalar, const Readings& readings, bool flush);

enum class Culprit : std::uint8_t {
    kMethod,
    kRounding,
    kDriver,          // outside of what the specification allows, or nobody else's: its bug
    kDriverAllowed,   // inside: the implementation's right
    kDriverUnstated,  // the specification is silent
};
// "method", "rounding", "driver", "driver, within the specification", "driver, where the
// specification is silent".
std::string_view CulpritName(Culprit culprit);

// Whose fault a refused value is: the largest part in ulp (of equal ones the first of method,
// rounding, driver) names it. `excess` is Excess of the device's result.
Culprit CulpritOf(const Parts& parts, const Allowed& allowed, double excess);

// The two sides of a law by one reading.
template <typename T>
struct Sides {
    T left{};
    T right{};
};

// Judges a law by M: it holds, too, where it does once its sides are rounded to binary32.
Judgement JudgeLawByMethod(const Law& law, Scalar scalar, const Sides<double>& method);

// Whose fault a broken law is: the first of M, R and D by which it does not hold.
Culprit CulpritOfLaw(const Law& law, Scalar scalar, const Sides<double>& method,
                     const Sides<std::uint32_t>& strict, const Sides<std::uint32_t>& device,
                     const Sides<Allowed>& allowed);

}  // namespace etalon
