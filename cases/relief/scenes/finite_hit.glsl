#include "relief/ray.glsl"

// Whether a hit's numbers are finite, its way on the ray, its layer one of three and its bracket in
// order.
bool finite_hit(ReliefHit hit)
{
    return abs(hit.t - 32.0) <= 33.0 && dot(abs(hit.position), vec3(1.0)) <= 4e6 &&
           hit.t_above >= 0.0 && hit.t_above <= hit.t_below && hit.t_below <= RELIEF_MAX_WAY &&
           hit.layer >= RELIEF_NONE && hit.layer <= RELIEF_SOLID;
}
