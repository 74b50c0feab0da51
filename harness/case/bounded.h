// Bounded: a number in the 64-bit mantissa of long double with a bound on its error, and the
// operations of host expressions over it.
//
// The bound of a result covers every exact operand within the operands' bounds, and the operation's
// own rounding. It is meant to be sound before it is tight: where nothing is known it is infinite.
// A condition is 1 or 0; where the bounds leave it undecided it has the centre's value and bound 1.
#pragma once

namespace etalon {

struct Bounded {
    long double value = 0;
    long double error = 0;
};

// Unused operands are ignored; one signature lets a table hold them all.
using BoundedMap = Bounded (*)(const Bounded& a, const Bounded& b, const Bounded& c);

// Over vectors of `size` components; `out` takes the result's.
using BoundedFold = void (*)(const Bounded* a, const Bounded* b, unsigned size, Bounded* out);

Bounded operator+(const Bounded& a, const Bounded& b);
Bounded operator-(const Bounded& a, const Bounded& b);
Bounded operator-(const Bounded& a);
Bounded operator*(const Bounded& a, const Bounded& b);
Bounded operator/(const Bounded& a, const Bounded& b);
Bounded Sqrt(const Bounded& a);
Bounded Power(const Bounded& base, const Bounded& exponent);
Bounded Minimum(const Bounded& a, const Bounded& b);
Bounded Maximum(const Bounded& a, const Bounded& b);
Bounded Floor(const Bounded& a);
Bounded Modulo(const Bounded& a, const Bounded& b);  // a - b floor(a / b)
Bounded Absolute(const Bounded& a);

// Increasing or decreasing on [low, high], and evaluated by the library. An argument that leaves
// that range by no more than its error is taken to lie on its end.
Bounded Monotone(long double (*function)(long double), const Bounded& a, long double low,
                 long double high);

// A function whose slope is at most `slope` over all that `a` may be, and that spans `span` at
// most.
Bounded Sloped(long double value, const Bounded& a, long double slope, long double span);

Bounded Arctangent(const Bounded& y, const Bounded& x);

Bounded Less(const Bounded& a, const Bounded& b);
Bounded LessEqual(const Bounded& a, const Bounded& b);
Bounded Equal(const Bounded& a, const Bounded& b);
Bounded Not(const Bounded& a);
Bounded And(const Bounded& a, const Bounded& b);
Bounded Or(const Bounded& a, const Bounded& b);

}  // namespace etalon
