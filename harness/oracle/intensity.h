// The share of a light's intensity that enters a surface.
//
//   intensity.refraction(normal, light_dir, n1, n2)
//
// is fresnel.transmittance(n1, n2, cos_i) with cos_i = -dot(light_dir, normal) of the given floats,
// not normalised, limited to 1; 0 where it is negative, for light from behind. Domain of the
// bounds: indices as in fresnel.h, vectors of floats of about unit length. The cosine is kept to
// 106 bits, as the transmittance has a vertical tangent at the critical angle.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> IntensityFunctions();

}  // namespace etalon::oracle
