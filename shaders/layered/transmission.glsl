// Where an inner layer is seen through a surface: the refracted ray from the surface down to the
// layer.
//
// Tangent space: z points out of the surface, v to the eye, n is the surface's normal. Directions
// need no unit length; a zero vector counts as (0, 0, 1). Lengths (depth d, way s) share one unit,
// the article's is the texel. n1 is the index outside, n2 the one between the layers. A NaN counts
// as the limit on the side of its sign. No input yields NaN or infinity.
#ifndef ETALON_LAYERED_TRANSMISSION
#define ETALON_LAYERED_TRANSMISSION

#include "../optics/snell.glsl"
#include "unit.glsl"

// The direction to the eye, mirrored at the normal, of the length of v where n has unit length.
// Components are limited to +-2^40. Error: 5e-7 of that length.
// Costs the published form's arithmetic and the limits, twice as much in all.
// Source: Oat, equation (1), first row.
vec3 mirrored_vector(vec3 v, vec3 n)
{
    return reflect_ray(-v, n);
}

// The unit direction of sight below the surface, bent by Snell's law. A normal that faces away from
// the eye is turned as far as it takes to be seen from the side, so that T.z < 0 for every eye and
// normal above the surface where n1 <= n2. The zero vector at total internal reflection, -v for
// equal indices. Error: 2e-6 where the refracted cosine is above 0.5, 6e-6 where it is above 0.1.
// Costs two normalisations and a refraction, about four times the mirrored vector that the article
// uses in its place, which is wrong by up to 2 (the opposite direction).
// Source: thesis eqs. (17), (18), in place of Oat, equation (1), second row.
vec3 transmission_vector(vec3 v, vec3 n, float n1, float n2)
{
    const vec3 up = vec3(0.0, 0.0, 1.0);
    v = layered_unit(v, up);
    n = layered_unit(n, up);
    float away = dot(n, v);
    if (away < 0.0) {
        n -= away * v;
        // Against the eye nothing of the normal is left; the surface's own takes its place.
        n = dot(n, n) > 1e-6 ? normalize(n) : up;
        n -= min(dot(n, v), 0.0) * v;
    }
    return refract_ray(-v, n, n1, n2);
}

// The way along the unit direction T to a layer at the depth d, d / -T.z, and `longest` at most;
// `longest` as well where T does not lead down, 0 where d <= 0. A flat surface needs no more than
// d / sqrt(1 - (n1 / n2)^2). Error: 2 ulp.
// Source: Oat, equation (1), third row; the limit and the sign of T.z are ours.
float transmission_distance(float d, vec3 transmission, float longest)
{
    d = optics_limit(d, 0.0, 1e18);
    longest = optics_limit(longest, 0.0, 1e18);
    float down = optics_limit(-transmission.z, 0.0, 1.0);
    return d < longest * down ? d / down : (d > 0.0 ? longest : 0.0);
}

// uv moved by s along T. unit_size is the length unit in texture coordinates along u and along v:
// (1 / width, 1 / height) where the unit is a texel and texels are square on the surface, whatever
// the map's proportions. Texture coordinates are limited to +-65536, s to 65536, unit_size to
// 0..1024. Error: 2 ulp of the larger of uv and the offset. Costs 4 times the published form, a
// handful of operations: the limits.
// Source: Oat, equation (1), fourth row.
vec2 offset_coordinate(vec2 uv, float s, vec3 transmission, vec2 unit_size)
{
    vec2 size = vec2(optics_limit(unit_size.x, 0.0, 1024.0),
                     optics_limit(unit_size.y, 0.0, 1024.0));
    vec2 along = optics_limit(transmission.xy, 1.0);
    return optics_limit(uv, 65536.0) + size * (optics_limit(s, 0.0, 65536.0) * along);
}

// From a point of the surface to the point of the layer at depth d that is seen there: xy the
// offset along the surface, z the way between them, in the unit of d; the way is `longest` at most,
// and the offset then shorter in proportion. Flat surface: the offset is -d v.xy / v.z for equal
// indices, (0, 0) from above. Mirrored with v and n. Error: 1e-5 (d + s) where T.z < -0.1 and the
// refracted cosine is above 0.1.
// Source: Oat, equation (1), with the refracted T.
vec3 layer_way(vec3 v, vec3 n, float n1, float n2, float d, float longest)
{
    vec3 transmission = transmission_vector(v, n, n1, n2);
    float s = transmission_distance(d, transmission, longest);
    return vec3(s * transmission.xy, s);
}

#endif
