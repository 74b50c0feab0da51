// How a lamp's light fades with distance.
#ifndef ETALON_OPTICS_ATTENUATION
#define ETALON_OPTICS_ATTENUATION

#include "limit.glsl"

float optics_nonnegative(float x)
{
    return optics_limit(optics_number(x), 0.0, 1099511627776.0);
}

// 1 / (constant + linear d + quadratic d^2), at most 1. d is the distance, in any unit; the factors
// count as 0 where they are negative or no number, and all are limited to 2^40. With a denominator
// below 1 (all factors 0 among them) the lamp is not brighter than itself: 1. Error: 4 ulp. Costs
// about twice the published form: the limits.
// Source: thesis appendix A.2, OpenGL 2.0 section 2.14.1.
float light_attenuation(float d, float constant, float linear, float quadratic)
{
    float distance_to_light = optics_nonnegative(d);
    float denominator = optics_nonnegative(constant) +
                        distance_to_light * (optics_nonnegative(linear) +
                                             distance_to_light * optics_nonnegative(quadratic));
    return 1.0 / max(denominator, 1.0);
}

#endif
