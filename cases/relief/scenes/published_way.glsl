#include "published/relief.glsl"

// The way along a ray from the box's top to the point that the published search finds for the same
// ray: its fragment lies where the ray passes the middle of the box.
float published_way(vec3 start, vec3 velocity, int steps, int iterations)
{
    vec3 point;
    vec2 uv = start.xy + velocity.xy * (0.5 / -velocity.z);
    vec3 eye = vec3(-velocity.xy / 0.1, -velocity.z);
    find_relief(point, steps, iterations, eye, uv, 0.05);
    return (0.5 - point.z) / -velocity.z;
}
