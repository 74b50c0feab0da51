// Where a ray first meets a height field of closed form.
//
// The ray is that of shaders/relief/ray.glsl: at start + t * velocity after the way t, its xy in
// texture coordinates, its z in the box's; t runs from 0 to end. Heights are clamped to the box,
// -0.5 .. 0.5. The result is the first t at which the height is not below the ray (0 for a ray that
// starts in the solid), -1 where there is none.
//
//   relief.plane(start(3), velocity(3), end, level)
//     the height is level
//   relief.ramp(start(3), velocity(3), end, slope(2), level)
//     level + dot(slope, uv)
//   relief.sine(start(3), velocity(3), end, amplitude, wave(2), phase, level)
//     level + amplitude * sin(2 pi (dot(wave, uv) + phase))
//   relief.sphere_cap(start(3), velocity(3), end, centre(2), radius, level, texture_per_height)
//     the greater of level and a sphere's; its centre lies on the box's floor at the texture
//     coordinates `centre`, its radius is in box heights
//   relief.steps(start(3), velocity(3), end, width, rise, level)
//     level + rise * (floor(u / width) modulo 2), and the vertical walls between the terraces
//
// NaN, undecided, where heights raised or lowered by 2^-20 (for steps, walls moved by 2^-20 widths
// too) would move the hit by more than 2^-8 on the whole, or make it a miss, or a miss a hit: at a
// ray that nearly touches, or runs along, the surface, and at a hit within 2^-8 of the ray's end.
// NaN also where the ray crosses more than 65536 waves or steps, or where it is no ray: something
// is not finite, the end or a length negative.
//
// Domain of the bounds: floats; the ray within 16 textures from their origin, its end at most 64;
// sine: at most 128 waves along the ray; sphere_cap: at most 64 box heights from the centre.
#pragma once

#include <vector>

#include "oracle/function.h"

namespace etalon::oracle {

std::vector<Function> ReliefFunctions();

}  // namespace etalon::oracle
