// The colours of a soap film: waves from both faces of a film of index n2 in a medium of index n1
// add, as the film is thinner than the light is coherent; slab.glsl is for what is thicker.
//
// thickness and wavelength, that in vacuum, have one unit; both are limited to 2^-40 .. 2^40 of it,
// their quotient to 2^16. n1, n2 and cos_i: snell.glsl. What a film thinner than a wavelength lets
// through beyond the critical angle is left out. No input yields NaN or infinity.
#ifndef ETALON_OPTICS_THIN_FILM
#define ETALON_OPTICS_THIN_FILM

#include "angle.glsl"
#include "fresnel.glsl"

// The reflected share of one polarisation, for its (reflected, transmitted) share of one face.
// interference is the squared sine of half the phase between both faces' waves.
float optics_film_share(float reflected, float transmitted, float interference)
{
    float both = 4.0 * reflected * interference;
    float all = transmitted * transmitted + both;
    return transmitted > 0.0 && all > 0.0 ? both / all : 1.0;
}

// The reflected share of unpolarised light, 0 to 1: 0 for a film far thinner than the wave, which
// is black, and for equal indices; 1 at total internal reflection and, but for equal indices, at
// grazing. Error: 14 ulp, and 1e-6 x of the rounding of the phase, where
// x = 2 n2 cos_t thickness / wavelength is the number of waves there and back.
// Source: the two-beam phase 4 pi n2 cos_t thickness / wavelength, and G. B. Airy's sum of all
// re-reflections: 4 R sin^2 / (T^2 + 4 R sin^2).
float thin_film_reflectance(float n1, float n2, float cos_i, float thickness, float wavelength)
{
    const float longest = 1099511627776.0;
    float cos_t = cos_transmitted(n1, n2, cos_i);
    float ratio = optics_limit(thickness, 1.0 / longest, longest) /
                  optics_limit(wavelength, 1.0 / longest, longest);
    float waves = 2.0 * optics_clamp_index(n2) * cos_t * min(ratio, 65536.0);
    float part = waves - floor(waves);
    float sine = optics_sine(3.14159265359 * min(part, 1.0 - part));
    vec4 face = optics_fresnel(n1, n2, cos_i);
    float interference = sine * sine;
    return 0.5 * (optics_film_share(face.x, face.z, interference) +
                  optics_film_share(face.y, face.w, interference));
}

// The same for each colour channel, with its wavelength.
vec3 thin_film_reflectance_rgb(float n1, float n2, float cos_i, float thickness, vec3 wavelength)
{
    return vec3(thin_film_reflectance(n1, n2, cos_i, thickness, wavelength.r),
                thin_film_reflectance(n1, n2, cos_i, thickness, wavelength.g),
                thin_film_reflectance(n1, n2, cos_i, thickness, wavelength.b));
}

#endif
