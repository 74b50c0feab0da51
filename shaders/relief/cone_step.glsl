// Cone stepping (Dummer): hops to the border of a cone that stands on the surface under the ray and
// has no surface in it.
//
// Safe with the cones of `etalon bake cone`, which hold between the texels too (cones from texel to
// texel do not: Ban et al.). On bricks, as in lipschitz.glsl, a ray takes 11, 15, 21 and 34 hops;
// 0, 0.03, 0.06 and 0.27 % of 20,000 rays are off by more than 0.01 texels, and on ridges one texel
// wide 0.07 % at 70-85. With published cones and 64 hops 51 % are off by more than two texels on
// bricks at 70-85.
#ifndef ETALON_RELIEF_CONE_STEP
#define ETALON_RELIEF_CONE_STEP

#include "lipschitz.glsl"

// The ratio of radius to height, both in box heights, of an empty cone on the layers that the
// search asks for at uv, on the higher one where it asks for both; what is not above 0 is no cone.
float cone_at(vec2 uv);

// The way to the border of the cone under the ray.
float relief_cone_hop(ReliefRay ray, float along, float above, float t)
{
    float ratio = cone_at(relief_position(ray, t).xy);
    return relief_slope_hop(ray, along, above, ratio > 0.0 ? 1.0 / ratio : RELIEF_WALL);
}

// The first hop at whose end one of `layers` is met. At most steps + 1 samples of each layer and
// `steps` of the cones.
ReliefBracket step_cones(ReliefRay ray, float texture_per_height, float least, int layers,
                         int steps)
{
    float along = relief_along(ray, texture_per_height);
    float shortest = relief_hop(least);
    int count = relief_steps(steps);
    ReliefBracket bracket = relief_first_bracket(ray, layers);
    if (relief_met(bracket.below) != RELIEF_NONE) {
        return bracket;
    }
    for (int i = 0; i < count; ++i) {
        float hop = relief_cone_hop(ray, along, relief_above(bracket.above), bracket.t_above);
        float t = min(bracket.t_above + max(hop, shortest), ray.end);
        vec2 gaps = relief_gaps(ray, t, layers);
        bracket.t_below = t;
        bracket.below = gaps;
        if (relief_met(gaps) != RELIEF_NONE || t >= ray.end) {
            break;
        }
        bracket.t_above = t;
        bracket.above = gaps;
    }
    return bracket;
}

// The first encounter with either layer.
ReliefHit find_relief_by_cones(ReliefRay ray, float texture_per_height, float least, int steps)
{
    ReliefBracket bracket = step_cones(ray, texture_per_height, least, RELIEF_BOTH, steps);
    return relief_hop_hit(ray, bracket, 0);
}

#endif
