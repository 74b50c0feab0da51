// The part of a picture that is brighter than a display, split off and put into eight bits.
//
// Colours are linear radiance, at least 0. What is negative or no number counts as 0, and more than
// 65504, the largest half float, as that: no input yields NaN or infinity.
#ifndef ETALON_POST_HDR
#define ETALON_POST_HDR

#include "../optics/limit.glsl"

float post_radiance(float x)
{
    return optics_limit(optics_number(x), 0.0, 65504.0);
}

vec3 post_radiance(vec3 color)
{
    return optics_limit(optics_number(color), 0.0, 65504.0);
}

// What a display of that limit shows: each channel up to `limit`.
vec3 hdr_low(vec3 color, float limit)
{
    return min(post_radiance(color), post_radiance(limit));
}

// The rest: color - hdr_low(color, limit), correctly rounded.
// Source: paper section 3.2, light blooming.
vec3 hdr_high(vec3 color, float limit)
{
    vec3 radiance = post_radiance(color);
    return radiance - min(radiance, post_radiance(limit));
}

// Radiance up to `brightest` as a code of 0..1 whose even steps are finer where it is dark: its
// square root. `brightest` is at least 2^-14. Error: 4 ulp.
// Source: paper section 3.2, "square root based value controlling".
vec3 hdr_encode(vec3 high, float brightest)
{
    float scale = max(post_radiance(brightest), 0.00006103515625);
    return sqrt(min(post_radiance(high) / scale, 1.0));
}

// The radiance of a code. Error: 1.5 ulp.
vec3 hdr_decode(vec3 code, float brightest)
{
    vec3 c = min(post_radiance(code), 1.0);
    return c * c * max(post_radiance(brightest), 0.00006103515625);
}

#endif
