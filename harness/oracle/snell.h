// Refraction at a smooth interface.
//
// n1 is the index of the medium that the ray is in, n2 the other; cos_i the cosine between ray and
// normal. Domain of the bounds: n1, n2 floats in [2^-10, 2^10], cos_i a float in [0, 1], v and n
// vectors of floats of about unit length.
//
//   snell.cos_transmitted(n1, n2, cos_i)            0 at total internal reflection
//   snell.critical_cosine(n1, n2)                   NaN where n1 <= n2
//   snell.total_internal_reflection(n1, n2, cos_i)  1 or 0, never wrong
//   snell.reflect(v, n)                             v - 2 dot(v, n) n
//   snell.refract(v, n, n1, n2)                     zero at total internal reflection
//   snell.refract_rgb(v, n, n1, n2)                 n1, n2 with an index per channel; 3 columns
//
// Vectors are taken as they stand and never normalised: cos_i is -dot(v, n) of the given floats,
// limited to [0, 1] (n turned round where it is negative), and the refracted ray is
// (n1 / n2) v + ((n1 / n2) cos_i - cos_t) n with the cos_t of that cosine. A function that
// normalises its inputs differs from this by as much as they differ from unit length.
#pragma once

#include <vector>

#include "oracle/batch.h"
#include "oracle/function.h"

namespace etalon::oracle {

// (n2 cos_t)^2 for the cosine c; negative at total internal reflection. For floats n1, n2 and
// c.high with c.low = 0 it is correctly rounded but for one unit, and its sign is right; else its
// error is about 2^-103 n1^2.
ETALON_STEP double TransmittedSquare(double n1, double n2, Pair c) {
    const Pair difference = ExactProduct(n2 - n1, n2 + n1);
    const Pair x = ExactProduct(n1, c.high);
    const double x_low = x.low + n1 * c.low;
    return std::fma(x.high, x.high, difference.high) + (difference.low + 2 * x.high * x_low);
}

std::vector<Function> SnellFunctions();

}  // namespace etalon::oracle
