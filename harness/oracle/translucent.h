// What the eye sees of a flat translucent layer of index n2, in a medium of index n1, over a flat
// solid layer of one colour.
//
//   translucent.light(to_lamp(3), n1, n2, thickness, half_distance, absorb_color(3))
//     the share of a lamp's light, per channel, that passes the layer's face and reaches the solid
//   translucent.flat(to_eye(3), to_lamp(3), n1, n2, thickness, half_distance, absorb_color(3),
//                    albedo(3), sky(3), ambient(3), diffuse(3))
//     the light that comes to the eye: R sky + T a albedo (ambient + diffuse cos (n1 / n2)^2
//     share), R and T the face's shares for the eye's direction, a what the refracted ray's way to
//     the solid leaves, share that of translucent.light, and cos the lamp's cosine outside, for the
//     face spreads the light as the solid would
//
// Directions are of any length and point up; a channel halves every half_distance / absorb_color
// along the refracted ray. There is one passage of the face each way, no light that comes back to
// the solid from the face. Where the face lets nothing through its share is 0. Domain of the
// bounds: floats; indices 1 to 4, directions of about unit length whose cosines are above 0.01
// outside and 0.1 inside, thickness up to 2 and absorb_color up to 1, half_distance from 1/16; the
// rest 0 to 1.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> TranslucentFunctions();

}  // namespace etalon::oracle
