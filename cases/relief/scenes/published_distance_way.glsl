#include "published/relief_maps.glsl"

// The way along a ray to the point that the published search on a distance map finds; never beyond
// the ray's end.
float published_distance_way(vec3 start, vec3 velocity, float end, float threshold, int iterations)
{
    vec3 point = trace_distance_map(start, velocity, threshold, iterations);
    return min((start.z - point.z) / -velocity.z, end);
}
