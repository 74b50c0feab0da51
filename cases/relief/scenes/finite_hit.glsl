// Whether what a search returns is made of numbers within their bounds. In integers: what a comparison
// with NaN says is open.
#include "relief/search.glsl"

// Whether x is from 0 to `most`; -0 is.
bool from_zero(float x, float most)
{
    return floatBitsToUint(x) <= floatBitsToUint(most) || floatBitsToUint(x) == 0x80000000u;
}

bool within(float x, float limit)
{
    return (floatBitsToUint(x) & 0x7fffffffu) <= floatBitsToUint(limit);
}

bool within(vec2 v, float limit)
{
    return within(v.x, limit) && within(v.y, limit);
}

bool within(vec3 v, float limit)
{
    return within(v.xy, limit) && within(v.z, limit);
}

// A hit's way on the ray or -1 for none, its layer one of three and its bracket in order.
bool finite_hit(ReliefHit hit)
{
    bool none = hit.layer == RELIEF_NONE && hit.t == -1.0;
    bool met = hit.layer >= RELIEF_TRANSLUCENT && hit.layer <= RELIEF_SOLID;
    return (none || (met && from_zero(hit.t, RELIEF_MAX_WAY))) && within(hit.position, 2e6) &&
           from_zero(hit.t_above, hit.t_below) && from_zero(hit.t_below, RELIEF_MAX_WAY);
}

// A bracket's ends in order, and gaps that heights within the box may have.
bool finite_bracket(ReliefBracket bracket)
{
    return from_zero(bracket.t_above, bracket.t_below) &&
           from_zero(bracket.t_below, RELIEF_MAX_WAY) && within(bracket.above, 2.0) &&
           within(bracket.below, 2.0);
}

bool finite_ray(ReliefRay ray)
{
    return within(ray.start, 65536.0) && within(ray.velocity, 1024.001) &&
           within(ray.velocity.z, 1.000001) && from_zero(ray.end, RELIEF_MAX_WAY);
}
