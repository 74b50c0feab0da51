// Searches by hops: each as long as the ray can go without meeting a layer, by what is known of the
// layers' slope. Here it is one slope for all of the map; cones (cone_step.glsl) and distances
// (sphere_trace.glsl) are knowledge for each place.
//
// A hop that is safe gets shorter towards the surface and never reaches it; `least`, in box
// heights, ends that: no hop is shorter, and what a ray crosses twice on such a way can be lost.
// Rays that meet the surface at a small angle take many hops. On bricks (a slope of 6.8), 12.8
// texels to the box height, and with a least hop of 2^-13, a ray takes 24, 55, 146 and 416 of 512
// hops on average at 0-45, 45-70, 70-85 and 85-89 degrees. Of 20,000 rays in each band 0, 0.03 and
// 0.09 % are off by more than 0.01 texels (crests lower than the least hop), and above 85 degrees
// 12 %, whose 1024 hops are used up (49 % with 512).
#ifndef ETALON_RELIEF_LIPSCHITZ
#define ETALON_RELIEF_LIPSCHITZ

#include "refine.glsl"

// No slope is taken to be greater: a wall.
const float RELIEF_WALL = 65536.0;

// Lengths of hops: 2^-16 .. RELIEF_MAX_WAY; the least for NaN.
float relief_hop(float hop)
{
    return hop >= 1.5258789e-5 ? min(hop, RELIEF_MAX_WAY) : 1.5258789e-5;
}

// How far the ray moves along the surface on a way of one box height, in box heights.
float relief_along(ReliefRay ray, float texture_per_height)
{
    return length(ray.velocity.xy) / relief_texture_per_height(texture_per_height);
}

// The way on which a ray that is so far above the surface cannot meet it, where nothing ahead is
// higher than on a slope from here (height by length, both in box heights): 0 .. RELIEF_MAX_WAY. A
// NaN counts as a wall.
float relief_slope_hop(ReliefRay ray, float along, float above, float slope)
{
    float steepest = slope <= RELIEF_WALL ? max(slope, 0.0) : RELIEF_WALL;
    float approach = along * steepest - ray.velocity.z;
    return above < approach * RELIEF_MAX_WAY ? above / approach : RELIEF_MAX_WAY;
}

// How far the ray is above the layers whose gaps these are; negative within one.
float relief_above(vec2 gaps)
{
    return -max(gaps.x, gaps.y);
}

// A bracket without a hop yet, at the ray's start.
ReliefBracket relief_first_bracket(ReliefRay ray, int layers)
{
    vec2 gaps = relief_gaps(ray, 0.0, layers);
    return ReliefBracket(0.0, 0.0, gaps, gaps);
}

// The hit in the last hop. A ray that has met nothing when its steps are used up has met the solid
// where it is: it hangs just above a surface as a rule.
ReliefHit relief_hop_hit(ReliefRay ray, ReliefBracket bracket, int iterations)
{
    if (relief_met(bracket.below) == RELIEF_NONE && bracket.t_below < ray.end) {
        return ReliefHit(RELIEF_SOLID, bracket.t_below, relief_position(ray, bracket.t_below),
                         bracket.t_above, bracket.t_below);
    }
    ReliefBracket narrow = narrow_binary(ray, bracket, iterations);
    return relief_hit(ray, narrow, relief_secant(narrow));
}

// The first hop at whose end one of `layers` is met, on layers no steeper than `slope`. At most
// steps + 1 samples of each layer.
ReliefBracket march_lipschitz(ReliefRay ray, float texture_per_height, float slope, float least,
                              int layers, int steps)
{
    float along = relief_along(ray, texture_per_height);
    float shortest = relief_hop(least);
    int count = relief_steps(steps);
    ReliefBracket bracket = relief_first_bracket(ray, layers);
    if (relief_met(bracket.below) != RELIEF_NONE) {
        return bracket;
    }
    for (int i = 0; i < count; ++i) {
        float hop = relief_slope_hop(ray, along, relief_above(bracket.above), slope);
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

// The first encounter with either layer, both no steeper than `slope`.
ReliefHit find_relief_by_slope(ReliefRay ray, float texture_per_height, float slope, float least,
                               int steps)
{
    ReliefBracket bracket =
        march_lipschitz(ray, texture_per_height, slope, least, RELIEF_BOTH, steps);
    return relief_hop_hit(ray, bracket, 0);
}

#endif
