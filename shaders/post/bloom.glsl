// Light that spreads around what is brighter than the display.
#ifndef ETALON_POST_BLOOM
#define ETALON_POST_BLOOM

#include "hdr.glsl"

// The colour with `share` (0..1) of its bright part replaced by the blurred bright part of the
// picture, at the same place. Where the blur keeps the picture's light, so does the sum of all
// pixels: nothing is added that is not taken away. A share of 1 is the paper's additive blend of
// the blurred part with what the display shows; a share of 0 is `color`. Error: 2 ulp of the
// largest of the three.
// Source: paper section 3.2, light blooming.
vec3 bloom(vec3 color, vec3 blurred_high, float limit, float share)
{
    float part = optics_limit(optics_number(share), 0.0, 1.0);
    vec3 high = hdr_high(color, limit);
    // (1 - part) high is never more than high: the sum has no negative term.
    return hdr_low(color, limit) + (1.0 - part) * high + part * post_radiance(blurred_high);
}

#endif
