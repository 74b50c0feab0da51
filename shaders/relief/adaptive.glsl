// How many steps a linear search needs: by the map's texels, its roughness, the ray's angle, the
// distance, or a map of densities (thesis 2.3.1). Counts are 1 .. RELIEF_MAX_STEPS for any input.
//
// Two steps a texel, 6 bisections and a secant step take 0.6, 0.4, 1.2 and 0.6 % of the rays on
// bricks at 0-45, 45-70, 70-85 and 85-89 degrees for another hit (24 steps: 0.4, 2.2, 12.8, 48 %),
// six a texel 7.8 % on ridges one texel wide at 70-85 (24 steps: 63.6 %).
#ifndef ETALON_RELIEF_ADAPTIVE
#define ETALON_RELIEF_ADAPTIVE

#include "refine.glsl"

// The share of a search's steps that the scene wants at uv, 0 .. 1: from a texture, beside the
// heights. NaN counts as 1, one with a sign as 0.
float step_density(vec2 uv);

// The next whole number as a count of steps. A NaN is the most, one with a sign the fewest.
int relief_ceil_steps(float steps)
{
    return int(ceil(optics_limit(steps, 1.0, float(RELIEF_MAX_STEPS))));
}

// From `least` for a ray along the normal to `most` for one along the surface, linear in the
// cosine (Tatarchuk's parallax occlusion mapping, thesis 2.3.1).
int steps_for_angle(ReliefRay ray, int least, int most)
{
    float few = float(relief_steps(least));
    float many = float(relief_steps(most));
    return relief_ceil_steps(many + (few - many) * abs(ray.velocity.z));
}

// So many steps that per_texel of them fall on each texel that the ray passes, of a map of so many
// texels per texture coordinate. Where that is more than RELIEF_MAX_STEPS a step is longer: with
// 51.2 texels to the box height and 2 per texel from 84 degrees on. Two per texel, 12.8 texels to
// the box height, cost 1.9 times the published 24 steps and 6 bisections at 0 to 45 degrees, and 4
// to 5 times at 45 to 85.
int steps_for_texels(ReliefRay ray, vec2 map_size, float per_texel)
{
    vec2 texels = ray.end * ray.velocity.xy * map_size;
    return relief_ceil_steps(max(abs(texels.x), abs(texels.y)) * per_texel);
}

// The part of `steps` that a map no steeper than `slope` (height by length, both in box heights)
// needs. A ray steeper than the map crosses it once, and one step cannot lose a crossing; the
// share grows from there to all steps for a wall or a ray along the surface. A negative slope
// counts as 0, and NaN as a wall (as 0 with a sign).
int steps_for_slope(ReliefRay ray, float texture_per_height, float slope, int steps)
{
    float along = length(ray.velocity.xy) / relief_texture_per_height(texture_per_height);
    float approach = along * optics_limit(slope, 0.0, 1e18);
    float share = 1.0 - abs(ray.velocity.z) / max(approach, 1e-30);
    return relief_ceil_steps(float(relief_steps(steps)) * share);
}

// The part of `steps` that is left where a pixel covers so many texels of the map: what is smaller
// than a pixel need not be found.
int steps_for_distance(float texels_per_pixel, int steps)
{
    float count = float(relief_steps(steps));
    return relief_ceil_steps(count / optics_limit(optics_number(texels_per_pixel), 1.0, 1e18));
}

// search_bracket with steps that are longer where step_density is below 1: its share of `steps` for
// the whole ray. Never more than `steps` steps. One sample of the density for each.
ReliefBracket search_bracket_by_density(ReliefRay ray, int layers, int steps)
{
    int count = relief_steps(steps);
    vec2 gaps = relief_gaps(ray, 0.0, layers);
    ReliefBracket bracket = ReliefBracket(0.0, 0.0, gaps, gaps);
    if (relief_met(gaps) != RELIEF_NONE) {
        return bracket;
    }
    for (int i = 1; i <= count; ++i) {
        float density = step_density(relief_position(ray, bracket.t_above).xy);
        float divisor = max(optics_limit(density, 0.0, 1.0) * float(count), 1.0);
        float t = i < count ? min(bracket.t_above + ray.end / divisor, ray.end) : ray.end;
        gaps = relief_gaps(ray, t, layers);
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

// find_relief on the steps of a density map.
ReliefHit find_relief_by_density(ReliefRay ray, int steps, int iterations)
{
    ReliefBracket bracket = search_bracket_by_density(ray, RELIEF_BOTH, steps);
    bracket = narrow_binary(ray, bracket, iterations);
    return relief_hit(ray, bracket, relief_secant(bracket));
}

#endif
