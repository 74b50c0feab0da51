// What a light over a height field of closed form has between itself and a point of the surface, in
// the vertical plane through both.
//
//   shadow.ramp(direction(3), slope(2), texture_per_height)
//     on level + dot(slope, uv)
//   shadow.steps(point(3), direction(3), width, rise, level, texture_per_height)
//     on level + rise * (floor(u / width) modulo 2), rise >= 0
//   shadow.cap(point(3), direction(3), centre(2), radius, level, texture_per_height)
//     on the greater of level and a sphere's height; its centre lies on the box's floor at the
//     texture coordinates `centre`, its radius is in box heights; the point is not in the sphere,
//     nor on the side of it that faces away from the light
//
// is the tangent of the angle between the direction to the light (of any length, in isotropic units
// above the horizon, 2^-10 of the way or more aside; the light is farther than all of the surface)
// and the least one that the surface leaves free: negative where the light's middle is hidden. The
// point is vec3(texture coordinates, z) on the surface or above it; the level plane has no end.
// Heights are not clamped to the box.
//
//   shadow.disc(x)
//     the share of a disc of radius 1 that lies on the near side of a straight edge x from its
//     middle: 1 - (acos x - x sqrt(1 - x^2)) / pi; 0 and 1 beyond -1 and 1
//
// Domain of the bounds: floats within 2^6, the horizon's tangent within 2^6; steps: a wall at 2^-6
// box heights or more from the point; cap: a radius of 2^-4 or more, a point at 2^-6 box heights or
// more from the sphere.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ShadowFunctions();

}  // namespace etalon::oracle
