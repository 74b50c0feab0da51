// Relaxed cone stepping (Policarpo and Oliveira): cones that a falling ray enters the surface in at
// most once, so that a hop to the border brackets the first crossing, and bisection finds it.
//
// Safe with the cones of `etalon bake relaxed-cone`. Those are much wider than others only where
// the surface rises to plateaus that are wider than the way to them: on bricks a ray saves no hop,
// on waves and noise one or two, fewer than its bisections.
#ifndef ETALON_RELIEF_RELAXED_CONE
#define ETALON_RELIEF_RELAXED_CONE

#include "cone_step.glsl"

// The first encounter with the solid layer, by relaxed cones at cone_at and then `iterations`
// bisections of the last hop. Relaxed cones say nothing of rising rays: those take equal steps.
ReliefHit find_relief_by_relaxed_cones(ReliefRay ray, float texture_per_height, float least,
                                       int steps, int iterations)
{
    ReliefBracket bracket;
    if (ray.velocity.z > 0.0) {
        bracket = search_bracket(ray, RELIEF_SOLID, steps);
    } else {
        bracket = step_cones(ray, texture_per_height, least, RELIEF_SOLID, steps);
    }
    return relief_hop_hit(ray, bracket, iterations);
}

#endif
