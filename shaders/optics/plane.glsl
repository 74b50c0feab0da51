// Where a ray meets a plane.
//
// The ray is i + t v: i its start, v its direction of any length, t in units of that length. A ray
// that is parallel to the plane, or meets it beyond |t| = 2^100, yields -1, and so does one with a
// NaN or with numbers whose products are beyond a float's. A negative t says that the plane is
// behind the start: where only t >= 0 counts as a hit, -1 needs no test of its own. No input yields
// NaN or infinity.
#ifndef ETALON_OPTICS_PLANE
#define ETALON_OPTICS_PLANE

#ifdef GL_ES
precision highp float;
#endif

float optics_ray_quotient(float distance_to_plane, float approach)
{
    // So written that a NaN on either side is no hit.
    bool hits = abs(distance_to_plane) * 7.88860905e-31 < abs(approach) && abs(approach) <= 3e38;
    return hits ? distance_to_plane / approach : -1.0;
}

// t = dot(s - i, n) / dot(v, n) for the plane through s with normal n, of any length and on either
// side. Error: 4 ulp of t, and 3e-7 (|s - i| + |t v|) |n| / |dot(v, n)|, the rounding of the dot
// products. Costs 1.6 times the published form: two comparisons.
// Source: thesis eqs. (21)-(23).
float plane_ray_parameter(vec3 i, vec3 v, vec3 s, vec3 n)
{
    return optics_ray_quotient(dot(s - i, n), dot(v, n));
}

// t = (h - i.z) / v.z for the flat layer z = h of tangent space. Error: 2 ulp. Costs two
// comparisons more than the published form, which is a difference and a quotient.
// Source: thesis eqs. (24), (25).
float flat_layer_ray_parameter(float h, vec3 i, vec3 v)
{
    return optics_ray_quotient(h - i.z, v.z);
}

// t where a ray that goes down meets the flat layer z = h ahead of its start, -1 where it does not:
// it goes up or along the layer, or starts below it. Error: 2 ulp.
// Source: thesis section 4.1.3, whose test is v.z < 0 alone, and its t >= 0 of eq. (22).
float flat_layer_hit(float h, vec3 i, vec3 v)
{
    float t = flat_layer_ray_parameter(h, i, v);
    return v.z < 0.0 && t >= 0.0 ? t : -1.0;
}

#endif
