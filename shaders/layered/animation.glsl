// The inner layer's depth over time.
#ifndef ETALON_LAYERED_ANIMATION
#define ETALON_LAYERED_ANIMATION

#include "finite.glsl"

// 2 (1 + sin(time)), from 0 to 4 texels and never outside, for any input; time in radians, NaN and
// infinities counting as 0 and +-1e9. Error: 4e-4 for |time| <= 4e5 on a device whose sine is as
// good as Vulkan asks, 2^-11. Beyond, the phase of the animation is lost, its range is not.
// Source: Oat, comment in the second listing, whose sine leaves the range that it states.
float layer_depth(float time)
{
    time = layered_finite(time, 1e9);
    // The device's sine need be good from -pi to pi only. The first part of 2 pi has 8 bits, so
    // that its products with up to 2^16 turns are exact.
    float turns = floor(time * 0.15915494 + 0.5);
    float angle = (time - turns * 6.28125) - turns * 0.0019353072;
    return clamp(2.0 + 2.0 * sin(clamp(angle, -3.1415927, 3.1415927)), 0.0, 4.0);
}

#endif
