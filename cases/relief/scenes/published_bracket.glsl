#include "published/relief.glsl"

// How far apart along the surface, in box heights, the ends of the bracket are that the published
// search is left with, for an eye of that slope to the normal.
float published_bracket(float slope, int steps, int iterations)
{
    vec3 range1;
    vec3 range2;
    vec2 heights;
    int encounter =
        search_intersection(range1, range2, steps, vec3(slope, 0.0, 1.0), vec2(0.5), 0.05);
    refine_range(range1, range2, heights, iterations, encounter);
    return abs(range2.x - range1.x) / 0.1;
}
