// The inner layer's depth over time.
#ifndef ETALON_LAYERED_ANIMATION
#define ETALON_LAYERED_ANIMATION

#include "../optics/limit.glsl"

// 2 (1 + sin(time)), from 0 to 4 texels and never outside, for any input; time in radians, limited
// to +-1e9. Error: 4e-7 |time|, the rounding of time itself, beside
// twice that of the device's sine, which may be 2^-11 on Vulkan. Costs 1.7 to 3 times the published
// form: the sine's range is made its own.
// Source: Oat, comment in the second listing, whose sine leaves the range that it states.
float layer_depth(float time)
{
    time = optics_limit(time, 1e9);
    // Vulkan asks of a sine that it be good from -pi to pi only.
    float angle = time - 6.2831853 * floor(time * 0.15915494 + 0.5);
    return clamp(2.0 + 2.0 * sin(clamp(angle, -3.1415927, 3.1415927)), 0.0, 4.0);
}

#endif
