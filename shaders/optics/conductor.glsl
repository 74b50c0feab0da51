// How much light a smooth metal reflects, whose index is complex: n2 + i k2.
//
// n1, n2 and cos_i: snell.glsl; k2, how fast the wave dies in the metal, is limited to 0 .. 1024.
// What is not reflected is absorbed. No input yields NaN or infinity.
#ifndef ETALON_OPTICS_CONDUCTOR
#define ETALON_OPTICS_CONDUCTOR

#include "limit.glsl"
#include "snell.glsl"

// |z - w|^2 / |z + w|^2 for z = a + i b and a real w.
float optics_complex_share(float a, float b, float w)
{
    float difference = a - w;
    float sum = a + w;
    float b_squared = b * b;
    // The limit serves a dielectric of the same index, along whose surface all of them are 0.
    return min((difference * difference + b_squared) / max(sum * sum + b_squared, 1e-37), 1.0);
}

// The reflected shares (R_s, R_p), 0 to 1. Normal incidence: both
// ((n1 - n2)^2 + k2^2) / ((n1 + n2)^2 + k2^2); grazing: both 1. k2 = 0 is a dielectric, which
// fresnel.glsl does better. Error for metals, k2 / n1 of 1 or more: 12 ulp.
// Source: Fresnel's equations, thesis eqs. (9), (10), with a complex index.
vec2 conductor_reflectance_sp(float n1, float n2, float k2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    float n = optics_clamp_index(n2) / n1;
    float k = optics_limit(k2, 0.0, 1024.0) / n1;
    float c = optics_limit(cos_i, 0.0, 1.0);
    float s_squared = (1.0 - c) * (1.0 + c);

    // a + i b = sqrt((n + i k)^2 - s^2), the metal's index times its complex cosine. The larger of
    // the two parts is a root without cancellation, the other follows from a b = n k.
    float real = (n - k) * (n + k) - s_squared;
    float product = n * k;
    float larger = sqrt(0.5 * (abs(real) + length(vec2(real, 2.0 * product))));
    float smaller = product / max(larger, 1e-12);
    float a = real >= 0.0 ? larger : smaller;
    float b = real >= 0.0 ? smaller : larger;

    float s_share = optics_complex_share(a, b, c);
    float p_share = s_share * optics_complex_share(a * c, b * c, s_squared);
    return c > 0.0 ? vec2(s_share, p_share) : vec2(1.0);
}

// The reflected share of unpolarised light. Error: as above.
float conductor_reflectance(float n1, float n2, float k2, float cos_i)
{
    vec2 shares = conductor_reflectance_sp(n1, n2, k2, cos_i);
    return 0.5 * (shares.x + shares.y);
}

// The same for each colour channel, with the metal's indices there.
vec3 conductor_reflectance_rgb(float n1, vec3 n2, vec3 k2, float cos_i)
{
    return vec3(conductor_reflectance(n1, n2.r, k2.r, cos_i),
                conductor_reflectance(n1, n2.g, k2.g, cos_i),
                conductor_reflectance(n1, n2.b, k2.b, cos_i));
}

#endif
