// How much of a light's intensity enters a surface.
#ifndef ETALON_OPTICS_INTENSITY
#define ETALON_OPTICS_INTENSITY

#include "fresnel.glsl"

// The share of unpolarised light that passes an interface with that normal, from index n1 into n2,
// 0 to 1. light_dir is the direction that the light travels in, normal opposes it; both of unit
// length. 0 at total internal reflection, and for light from behind: a dot(light_dir, normal) above
// 4e-7, for up to that rounding alone may make it of grazing light.
// Equal indices: 1. Error: as fresnel_transmittance at the rounded -dot(light_dir, normal); that
// rounding costs 2e-5 where cos_t > 0.1, but near the critical angle its root, up to 4e-3.
// Costs 12 to 19 times the published form, as fresnel.glsl says.
// Source: thesis appendix A.2, refraction_intensity, with eqs. (9)-(12).
float refraction_intensity(vec3 normal, vec3 light_dir, float n1, float n2)
{
    float cos_i = -dot(optics_clamp_vector(light_dir), optics_clamp_vector(normal));
    if (cos_i < -4e-7) {
        return 0.0;
    }
    return fresnel_transmittance(n1, n2, max(cos_i, 0.0));
}

#endif
