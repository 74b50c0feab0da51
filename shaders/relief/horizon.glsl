// Light by a horizon map (thesis 2.4.2, after Max and Forsyth): how high the surface rises around a
// point is looked up instead of searched for.
//
// With the map of `etalon bake horizon` a point light is right for all but 0.05 % of points at
// texels and directions in the map's bearings, which nearly touch. Between them the horizon is
// interpolated: with 16 bearings it is wrong for 1.4 % of the points on waves and 5.1 % on bricks,
// beside the edges of their shadows. Static maps only.
#ifndef ETALON_RELIEF_HORIZON
#define ETALON_RELIEF_HORIZON

#include "ray.glsl"

// The tangent of the least elevation at which a ray from the surface at uv meets nothing, in the
// bearing 2 pi bearing / bearings from +x to +y; bearing is 0 .. bearings - 1.
float horizon_at(vec2 uv, int bearing);

// The same in any direction along the surface (of any length), linear between the two bearings
// beside it; 0 .. 65536, and what is no number counts as 0. `bearings` is 1 .. 4096. No direction
// (zero, NaN) is that of bearing 0.
float horizon_tangent(vec2 uv, vec2 direction, int bearings)
{
    int count = clamp(bearings, 1, 4096);
    vec2 d = vec2(relief_finite(direction.x, 1e18), relief_finite(direction.y, 1e18));
    float turn = max(abs(d.x), abs(d.y)) >= 1e-18 ? atan(d.y, d.x) * 0.15915494 : 0.0;
    float place = (turn - floor(turn)) * float(count);
    int lower = clamp(int(place), 0, count - 1);
    int upper = lower + 1 < count ? lower + 1 : 0;
    float first = clamp(relief_finite(horizon_at(uv, lower), 65536.0), 0.0, 65536.0);
    float second = clamp(relief_finite(horizon_at(uv, upper), 65536.0), 0.0, 65536.0);
    return first + clamp(place - float(lower), 0.0, 1.0) * (second - first);
}

// The lit share, 0 .. 1, of a light in this direction (of any length, in isotropic units) whose
// radius has this sine: how much of a square light stands above the horizon, as in thesis (4) with
// its factor of two put right (a disc is lit by up to 0.06 more or less). A radius of 0 or NaN is a
// point's. Without a direction (zero, NaN in all components) the light is overhead.
float horizon_light(vec2 uv, vec3 to_light, float sine_of_radius, int bearings)
{
    vec3 d = vec3(relief_finite(to_light.x, 1e18), relief_finite(to_light.y, 1e18),
                  relief_finite(to_light.z, 1e18));
    float longest = max(abs(d.x), max(abs(d.y), abs(d.z)));
    d = longest >= 1e-18 ? normalize(d / longest) : vec3(0.0, 0.0, 1.0);
    float along = length(d.xy);
    float tangent = along >= 1e-6 ? horizon_tangent(uv, d.xy, bearings) : 0.0;
    // The sine of the light's elevation above the horizon.
    float above = (d.z - along * tangent) * inversesqrt(1.0 + tangent * tangent);
    float radius = sine_of_radius >= 1e-6 ? min(sine_of_radius, 1.0) : 0.0;
    if (abs(above) >= radius) {
        return above > 0.0 ? 1.0 : 0.0;
    }
    return 0.5 + 0.5 * (above / radius);
}

#endif
