// Where a ray meets a plane.
//
// The ray is i + t v: i its start, v its direction of any length, t in units of that length. A ray
// that is parallel to the plane, or meets it beyond |t| = 2^100, yields -1. A negative t says that
// the plane is behind the start: where only t >= 0 counts as a hit, -1 needs no test of its own.
// Positions are clamped to +-2^100 and directions to +-2^20 in each component; no finite input
// yields NaN or infinity.
#ifndef ETALON_OPTICS_PLANE
#define ETALON_OPTICS_PLANE

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

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
    i = clamp(i, -far, far);
    s = clamp(s, -far, far);
    v = clamp(v, -longest, longest);
    n = clamp(n, -longest, longest);
    return optics_ray_quotient(dot(s - i, n), dot(v, n));
}

// t = (h - i.z) / v.z for the flat layer z = h of tangent space. Error: 2 ulp.
// Source: thesis eqs. (24), (25).
float flat_layer_ray_parameter(float h, vec3 i, vec3 v)
{
    const float far = 1267650600228229401496703205376.0;
    return optics_ray_quotient(clamp(h, -far, far) - clamp(i.z, -far, far),
                               clamp(v.z, -1048576.0, 1048576.0));
}

#endif
