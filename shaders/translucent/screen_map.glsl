// Looking up a map of the surroundings that was rendered as seen by the eye: a reflection or
// refraction map, for surfaces that are flat but for small waves.
//
// Space is the eye's: the eye at 0 looks along -z; a point is on the screen at
// 0.5 + 0.5 * focal * xy / -z, where `focal` (x and y) is the cotangent of half the field of view.
// NaN counts as 0; positions are limited to +-1e6, focal to +-1e3, components of rays to +-1.
#ifndef ETALON_TRANSLUCENT_SCREEN_MAP
#define ETALON_TRANSLUCENT_SCREEN_MAP

#include "../optics/limit.glsl"

struct ScreenSample {
    vec2 uv;     // in the map, always within 0..1
    bool valid;  // false where the point is not on the map: behind the eye or beyond its edge
};

// Where a point is on the screen. Nearer to the eye's plane than 1e-6 it is not. Error: 4 ulp of
// the offset from the screen's middle.
ScreenSample screen_position(vec3 point, vec2 focal)
{
    vec3 p = optics_limit(optics_number(point), 1e6);
    vec2 f = optics_limit(optics_number(focal), 1e3);
    if (!(p.z <= -1e-6)) {
        return ScreenSample(vec2(0.5), false);
    }
    vec2 uv = 0.5 + 0.5 * f * p.xy / -p.z;
    vec2 inside = clamp(uv, 0.0, 1.0);
    return ScreenSample(inside, inside == uv);
}

// Where the map shows what a ray from `surface` along the unit vector `ray` meets after `way`. The
// distance must be known; then the look-up is exact for whatever the map shows unoccluded, and the
// shift fades to nothing where the way does, as at the shore of a pond. A way counts as 0..1e6.
// Source: thesis 3.3.2, with the depth that it names as missing.
ScreenSample screen_map_sample(vec3 surface, vec3 ray, float way, vec2 focal)
{
    float reach = optics_limit(optics_number(way), 0.0, 1e6);
    vec3 from = optics_limit(optics_number(surface), 1e6);
    return screen_position(from + reach * optics_limit(optics_number(ray), 1.0), focal);
}

#endif
