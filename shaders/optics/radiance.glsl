// What the eye sees through an interface: radiance, which an interface changes by more than the
// shares of the energy. A ray's radiance over the square of the index stays but for the share that
// is reflected, as the rays of one bundle fill another solid angle behind the interface.
//
// Radiance is per channel, in any unit, and limited to 0 .. 2^80; the rest: snell.glsl. No input
// yields NaN or infinity.
#ifndef ETALON_OPTICS_RADIANCE
#define ETALON_OPTICS_RADIANCE

#include "fresnel.glsl"

vec3 optics_clamp_radiance(vec3 radiance)
{
    return optics_limit(radiance, 0.0, 1208925819614629174706176.0);
}

// The radiance behind the interface of light that comes from index n1 into n2:
// T (n2 / n1)^2 radiance. 0 at total internal reflection. Light that enters a denser medium grows
// in radiance, and loses it again on its way out. Error: 8 ulp.
// Source: thesis eq. (12) for the share T; (n2 / n1)^2 is the law of the constant etendue.
vec3 transmitted_radiance(vec3 radiance, float n1, float n2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    float ratio = n2 / n1;
    return optics_clamp_radiance(radiance) *
           (fresnel_transmittance(n1, n2, cos_i) * (ratio * ratio));
}

// The radiance that the eye, in index n1, sees of an interface to n2: R reflected +
// T (n1 / n2)^2 refracted, where `reflected` comes along the reflected ray in the eye's medium, and
// `refracted` along the refracted one in the other. Only `reflected` counts at total internal
// reflection. Error: 10 ulp.
// Source: thesis section 4.2.1, paper algorithm 1, whose weights are R and T.
vec3 composed_radiance(vec3 reflected, vec3 refracted, float n1, float n2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    float ratio = n1 / n2;
    vec4 shares = optics_fresnel(n1, n2, cos_i);
    return optics_clamp_radiance(reflected) * (0.5 * (shares.x + shares.y)) +
           optics_clamp_radiance(refracted) * (0.5 * (shares.z + shares.w) * (ratio * ratio));
}

#endif
