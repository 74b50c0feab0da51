// From tangent space to the world.
#ifndef ETALON_LAYERED_WORLD
#define ETALON_LAYERED_WORLD

#include "unit.glsl"

// v turned by the rows tangent, binormal and normal of the interpolated inverse tangent space: (the
// rows' scalar products with v). Interpolation leaves rows that are short and not square on each
// other. They are made a frame again, the normal's row first, so that lengths and angles are kept;
// the binormal's row only says to which side. Rows that cannot be (zero, NaN, parallel) are
// replaced by any that fit. v is limited to +-1e18 in each component. Error: 6e-7 of the length of
// v.
// Costs two normalisations, two cross products and the published three scalar products, 25 to
// 30 times as much as these alone.
// Source: Oat, second listing, where the rows are taken as they come.
vec3 tangent_to_world(vec3 v, vec3 tangent, vec3 binormal, vec3 normal)
{
    v = optics_limit(v, 1e18);
    vec3 third = layered_unit(normal, vec3(0.0, 0.0, 1.0));
    vec3 first = layered_unit(tangent, vec3(1.0, 0.0, 0.0));
    first -= dot(first, third) * third;
    if (!(dot(first, first) > 1e-6)) {
        first = abs(third.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
        first -= dot(first, third) * third;
    }
    first = normalize(first);
    // Near-parallel rows leave the first inexact along the third.
    first = normalize(first - dot(first, third) * third);
    vec3 second = cross(third, first);
    if (dot(second, optics_limit(binormal, 1e18)) < 0.0) {
        second = -second;
    }
    return vec3(dot(first, v), dot(second, v), dot(third, v));
}

#endif
