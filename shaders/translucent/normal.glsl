// Normals from texels.
#ifndef ETALON_TRANSLUCENT_NORMAL
#define ETALON_TRANSLUCENT_NORMAL

#include "../optics/limit.glsl"

// The unit normal of a texel whose channels 0..1 stand for -1..1; y is turned round where the map's
// green channel points down (flip_y). The neutral texel of an eight-bit map, 128 of 255, is taken
// as exactly level: values within half a step of 0.5 count as 0.5, so that a flat map gives a flat
// surface (the published form tilts it by 0.3178 degrees). A texel that is no direction (all
// channels at 0.5, NaN) gives (0, 0, 1). Error: 4e-7 per component. Costs 1.8 times the published
// form: the neutral texel and the limits.
// Source: thesis appendix A.2, the decoding before each use of a normal.
vec3 decode_normal(vec3 texel, bool flip_y)
{
    vec3 d = optics_limit(optics_number(texel), 0.0, 1.0) - 0.5;
    // Half a step of eight bits, and a little for the texture unit's own rounding.
    const float level = 0.00197;
    d = vec3(abs(d.x) < level ? 0.0 : d.x, abs(d.y) < level ? 0.0 : d.y,
             abs(d.z) < level ? 0.0 : d.z);
    if (flip_y) {
        d.y = -d.y;
    }
    return dot(d, d) > 0.0 ? normalize(d) : vec3(0.0, 0.0, 1.0);
}

#endif
