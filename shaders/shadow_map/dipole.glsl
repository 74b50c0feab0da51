// The dipole: light that enters a half space at one point and leaves it at another, after many
// scatterings, as if from one source below the surface and one that takes away above it.
//
// Coefficients are per unit of length, one for each channel: sigma_a absorbs, sigma_s scatters
// (reduced, as of an isotropic medium). Lengths are in the same unit. sigma_a is limited to
// 0..2^20, sigma_s to 2^-20..2^20, the index to 1..3, lengths to 2^20; NaN counts as the lower
// bound. A Dipole comes from dipole_medium; then no number yields NaN or infinity.
#ifndef ETALON_SHADOW_MAP_DIPOLE
#define ETALON_SHADOW_MAP_DIPOLE

#include "light_space.glsl"

struct Dipole {
    vec3 albedo;         // the reduced one, sigma_s / (sigma_a + sigma_s)
    vec3 real_depth;     // of the source in the medium, a mean free path
    vec3 virtual_depth;  // of the other, its height over the surface
    vec3 extinction;     // effective, sqrt(3 sigma_a (sigma_a + sigma_s))
};

// The share of diffuse light that the surface reflects back inside, for indices from 1 to 3.
// Source: H. W. Jensen et al., A Practical Model for Subsurface Light Transport, 2001, section 2.
float dipole_internal_reflectance(float refr_index)
{
    float inverse = 1.0 / light_limit(refr_index, 1.0, 3.0);
    return (-1.440 * inverse + 0.710) * inverse + 0.668 + 0.0636 / inverse;
}

// The medium, to be prepared once. Error: 8 ulp, of virtual_depth 32 ulp.
// Source: as above, with A = (1 + F) / (1 - F).
Dipole dipole_medium(vec3 sigma_a, vec3 sigma_s, float refr_index)
{
    vec3 absorbed = light_limit(sigma_a, 0.0, 1048576.0);
    vec3 scattered = light_limit(sigma_s, 1.0 / 1048576.0, 1048576.0);
    vec3 total = absorbed + scattered;
    float reflected = dipole_internal_reflectance(refr_index);
    float boundary = (1.0 + reflected) / (1.0 - reflected);
    Dipole medium;
    medium.albedo = scattered / total;
    medium.real_depth = 1.0 / total;
    medium.virtual_depth = medium.real_depth * (1.0 + 4.0 / 3.0 * boundary);
    medium.extinction = sqrt(3.0 * absorbed * total);
    return medium;
}

vec3 dipole_pole(vec3 z, vec3 extinction, float square)
{
    vec3 d = sqrt(square + z * z);
    vec3 x = extinction * d;
    return z * ((1.0 + x) * exp2(-min(1.44269504 * x, 256.0))) / (d * d * d);
}

// R_d: the share of the light entering at a point that leaves per unit of area at the distance r,
// 1 / length^2. The distance is a straight line; the same both ways. Error: 1.2e-6 (1 + x)
// relative, the medium's own included, x the extinction times the way from the real source. Falls
// to 0 where it underflows.
vec3 dipole_reflectance(Dipole medium, float r)
{
    r = light_limit(abs(r), 0.0, 1048576.0);
    return medium.albedo * (0.25 / 3.14159265)
        * (dipole_pole(medium.real_depth, medium.extinction, r * r)
           + dipole_pole(medium.virtual_depth, medium.extinction, r * r));
}

vec3 dipole_pole_beyond(vec3 z, vec3 extinction, float square)
{
    vec3 d = sqrt(square + z * z);
    return z * exp2(-min(1.44269504 * extinction * d, 256.0)) / d;
}

// The integral of R_d over that part of a plane which is farther than the root of `square` from the
// point: the share that comes from there where the irradiance is even. The integral is exact, for
// r dr = d dd makes each pole's term a derivative. With 0 it is the whole plane's,
// dipole_plane_integral. Error: as dipole_reflectance.
vec3 dipole_beyond(Dipole medium, float square)
{
    square = light_limit(square, 0.0, 1099511627776.0);
    return 0.5 * medium.albedo
        * (dipole_pole_beyond(medium.real_depth, medium.extinction, square)
           + dipole_pole_beyond(medium.virtual_depth, medium.extinction, square));
}

// The share of evenly entering light that leaves the plane again: the medium's diffuse colour.
vec3 dipole_plane_integral(Dipole medium)
{
    return dipole_beyond(medium, 0.0);
}

#endif
