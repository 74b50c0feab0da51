// Light that fades on its way through a medium.
//
// d is the length of the way and half_distance the length that halves the light, in the same unit.
// A negative d counts as 0. half_distance must be at least 2^-126; anything less counts as that.
// absorb_color is how strongly each channel is absorbed, clamped to 0..1. A NaN counts as the
// largest number, one with a sign as the least. No input yields NaN or infinity. Errors are stated
// for a device whose division is correctly rounded and whose exp2 is as good as Vulkan asks,
// 3 + 2 |x| ulp; y stands for d / half_distance.
#ifndef ETALON_OPTICS_ABSORPTION
#define ETALON_OPTICS_ABSORPTION

#include "limit.glsl"

// d / half_distance, 0 to 2^64.
float optics_half_distances(float d, float half_distance)
{
    d = optics_limit(d, 0.0, 3.402823466e38);
    half_distance = optics_limit(half_distance, 1.17549435e-38, 3.402823466e38);
    // Keeps the quotient finite.
    return d / max(half_distance, d / 18446744073709551616.0);
}

// The absorbed share 1 - 2^(-d / half_distance), 0 to 1: 0 at d = 0, 1/2 at d = half_distance.
// Error: 8 ulp, for the shortest way as well. Costs 3.5 times the published form, which has lost
// its digits there.
// Source: thesis eq. (13), paper eq. (1).
float absorbed_fraction(float d, float half_distance)
{
    float y = optics_half_distances(d, half_distance);
    if (y >= 1.0) {
        return 1.0 - exp2(-min(y, 256.0));
    }
    // 1 - exp(-2 w) = 2 tanh w / (1 + tanh w) with the [5/4] Pade approximant of tanh, whose
    // relative error is below 2e-9 for w <= ln(2) / 2. y / 2 multiplies last: y may be subnormal.
    float w = 0.34657359028 * y;
    float w_squared = w * w;
    float odd = 105.0 + 10.0 * w_squared;
    float even = 105.0 + w_squared * (45.0 + w_squared);
    return y * (0.69314718056 * odd / (even + w * odd));
}

// The share that is left, 2^(-d / half_distance), 0 to 1: 1 at d = 0, 1/2 at d = half_distance.
// Error: 3 + 3 y ulp.
// Source: thesis eq. (13), paper eq. (1).
float transmitted_fraction(float d, float half_distance)
{
    return exp2(-min(optics_half_distances(d, half_distance), 256.0));
}

// The thesis' colour rule 1 - absorb_color * absorbed_fraction, as a sum that does not cancel.
// Not multiplicative: two layers are not one of their joint thickness, and a channel never falls
// below 1 - absorb_color. Error: 3 ulp beside the error of transmitted_fraction.
// Source: thesis section 4.1.2 and appendix A.2; beer_lambert is the physical rule.
vec3 hued_transmittance(float d, float half_distance, vec3 absorb_color)
{
    absorb_color = optics_limit(absorb_color, 0.0, 1.0);
    return (1.0 - absorb_color) + absorb_color * transmitted_fraction(d, half_distance);
}

// The law of Beer and Lambert: 2^(-absorb_color d / half_distance) in each channel, which halves
// every half_distance / absorb_color. Multiplicative over d. Error: 3 + 4 absorb_color y ulp.
// Source: the exponential law behind thesis eq. (13), one coefficient per channel.
vec3 beer_lambert(float d, float half_distance, vec3 absorb_color)
{
    float y = optics_half_distances(d, half_distance);
    return exp2(-min(optics_limit(absorb_color, 0.0, 1.0) * y, 256.0));
}

#endif
