// Where a ray meets a plane.
//
// The ray is i + t v: i its start, v its direction of any length, t in units of that length. A ray
// that is parallel to the plane, or meets it beyond |t| = 2^100, yields -1. A negative t says that
// the plane is behind the start: where only t >= 0 counts as a hit, -1 needs no test of its own.
// Positions are clamped to +-2^100 and directions to +-2^20 in each component, a NaN to the bound
// on the side of its sign bit; no input yields NaN or infinity.
#ifndef ETALON_OPTICS_PLANE
#define ETALON_OPTICS_PLANE

#include "limit.glsl"

float optics_ray_quotient(float distance_to_plane, float approach)
{
    if (abs(distance_to_plane) / 1267650600228229401496703205376.0 >= abs(approach)) {
        return -1.0;
    }
    return distance_to_plane / approach;
}

// t = dot(s - i, n) / dot(v, n) for the plane through s with normal n, of any length and on either
// side. Error: 4 ulp of t, and 3e-7 (|s - i| + |t v|) |n| / |dot(v, n)|, the rounding of the dot
// products.
// Source: thesis eqs. (21)-(23).
float plane_ray_parameter(vec3 i, vec3 v, vec3 s, vec3 n)
{
    const float far = 1267650600228229401496703205376.0;
    const float longest = 1048576.0;
    i = optics_limit(i, far);
    s = optics_limit(s, far);
    v = optics_limit(v, longest);
    n = optics_limit(n, longest);
    return optics_ray_quotient(dot(s - i, n), dot(v, n));
}

// t = (h - i.z) / v.z for the flat layer z = h of tangent space. Error: 2 ulp.
// Source: thesis eqs. (24), (25).
float flat_layer_ray_parameter(float h, vec3 i, vec3 v)
{
    const float far = 1267650600228229401496703205376.0;
    return optics_ray_quotient(optics_limit(h, far) - optics_limit(i.z, far),
                               optics_limit(v.z, 1048576.0));
}

// t where a ray that goes down meets the flat layer z = h ahead of its start, -1 where it does not:
// it goes up or along the layer, or starts below it. Error: 2 ulp.
// Source: thesis section 4.1.3, whose test is v.z < 0 alone, and its t >= 0 of eq. (22).
float flat_layer_hit(float h, vec3 i, vec3 v)
{
    float t = flat_layer_ray_parameter(h, i, v);
    return optics_limit(v.z, 1.0) < 0.0 && t >= 0.0 ? t : -1.0;
}

#endif
