// How much light a smooth interface of two dielectrics reflects and how much it lets through.
// Parameters and their clamping: snell.glsl.
//
// Neither share is made by a subtraction that cancels. In units of n1: x = cos_i, g = n2 cos_t / n1
// and D = (n2 / n1)^2 - 1. The amplitude (x - g) / (x + g) is -D / (x + g)^2, and the one of the
// other polarisation is that times cos(i + t) / cos(i - t). Of each polarisation's two shares the
// smaller is computed so, and the larger is what it leaves of one.
//
// On llvmpipe, which executes both sides of every branch, this costs 9 to 12 times the published
// form, most of it optics_exact_square, for the light about the critical angle. With `critical` it
// costs 3 times as much as that form, at the same accuracy: the shares, each without cancellation,
// and the limits.
#ifndef ETALON_OPTICS_FRESNEL
#define ETALON_OPTICS_FRESNEL

#include "snell.glsl"

// (R_s, R_p, T_s, T_p); g = n2 cos_t / n1. All but R_p are relatively accurate.
vec4 optics_fresnel_shares(float n1, float n2, float c, float g)
{
    float excess = (n2 - n1) / n1;
    float ratio = n2 / n1;
    float ratio_squared = ratio * ratio;
    // The limits are below all sums of true inputs; they serve a `critical` of other indices.
    float s_sum = max(c + g, 1.0 / 1073741824.0);
    float p_sum = max(g + ratio_squared * c, 1.0 / 1125899906842624.0);
    float s_squared = s_sum * s_sum;
    float along = c * g;
    float across = (1.0 - c) * (1.0 + c);

    float s_amplitude = excess * (2.0 + excess) / s_squared;
    // Its magnitude is near 1 at most angles and near 0 about Brewster's; each has its best form.
    float least = min(along, across);
    float sum = along + across;
    float p_to_s = 4.0 * least < sum ? 1.0 - 2.0 * least / sum : (along - across) / sum;
    float s_reflected = s_amplitude * s_amplitude;
    float p_reflected = s_reflected * (p_to_s * p_to_s);
    // c last: it may be subnormal.
    float s_transmitted = min(c * (4.0 * g / s_squared), 1.0);
    float p_transmitted = min(c * (4.0 * g * ratio_squared / (p_sum * p_sum)), 1.0);

    if (s_reflected < 0.5) {
        s_transmitted = 1.0 - s_reflected;
    } else {
        s_reflected = 1.0 - s_transmitted;
    }
    if (p_reflected < 0.5) {
        p_transmitted = 1.0 - p_reflected;
    } else {
        p_reflected = 1.0 - p_transmitted;
    }
    return vec4(s_reflected, p_reflected, s_transmitted, p_transmitted);
}

// n2 cos_t / n1 for n1 <= n2, all clamped.
float optics_fresnel_into_denser(float n1, float n2, float c)
{
    float excess = (n2 - n1) / n1;
    return sqrt(excess * (2.0 + excess) + c * c);
}

// One call of optics_fresnel_shares in each of these, for a device that executes both sides of a
// branch; equal indices come out as (0, 0, 1, 1) by it.
vec4 optics_fresnel(float n1, float n2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    cos_i = optics_limit(cos_i, 0.0, 1.0);
    float g;
    if (n1 <= n2) {
        g = optics_fresnel_into_denser(n1, n2, cos_i);
    } else {
        float square = optics_transmitted_square(n1, n2, cos_i);
        if (square < 0.0) {
            return vec4(1.0, 1.0, 0.0, 0.0);
        }
        g = sqrt(square) / n1;
    }
    return optics_fresnel_shares(n1, n2, cos_i, g);
}

vec4 optics_fresnel(float n1, float n2, float cos_i, vec2 critical)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    cos_i = optics_limit(cos_i, 0.0, 1.0);
    float g;
    if (n1 <= n2) {
        g = optics_fresnel_into_denser(n1, n2, cos_i);
    } else {
        critical = optics_limit(critical, 1.0);
        float above = (cos_i - critical.x) - critical.y;
        if (above <= 0.0) {
            return vec4(1.0, 1.0, 0.0, 0.0);
        }
        g = sqrt(above * max(cos_i + critical.x, 0.0));
    }
    return optics_fresnel_shares(n1, n2, cos_i, g);
}

// The reflected shares (R_s, R_p) of light polarised across and in the plane of incidence, 0 to 1.
// Normal incidence: both ((n1 - n2) / (n1 + n2))^2; grazing and total internal reflection: both 1;
// Brewster's angle, tan i = n2 / n1: R_p = 0; equal indices: both 0.
// Error: R_s 16 ulp; R_p 16 ulp or 6e-8 (its zero cannot be met relatively).
// Source: thesis eqs. (9), (10), in cosines.
vec2 fresnel_reflectance_sp(float n1, float n2, float cos_i)
{
    return optics_fresnel(n1, n2, cos_i).xy;
}

// As above; `critical` is critical_cosine_split(n1, n2), for many cosines at one pair of indices.
vec2 fresnel_reflectance_sp(float n1, float n2, float cos_i, vec2 critical)
{
    return optics_fresnel(n1, n2, cos_i, critical).xy;
}

// The reflected share of unpolarised light, 0 to 1. Grazing and total internal reflection: 1;
// equal indices: 0, also at cos_i = 0. Error: 16 ulp, near the critical angle and for nearly equal
// indices as well.
// Source: thesis eqs. (9)-(11).
float fresnel_reflectance(float n1, float n2, float cos_i)
{
    vec4 shares = optics_fresnel(n1, n2, cos_i);
    return 0.5 * (shares.x + shares.y);
}

// As above; `critical` is critical_cosine_split(n1, n2), for many cosines at one pair of indices.
float fresnel_reflectance(float n1, float n2, float cos_i, vec2 critical)
{
    vec4 shares = optics_fresnel(n1, n2, cos_i, critical);
    return 0.5 * (shares.x + shares.y);
}

// The transmitted share of unpolarised light, 0 to 1: of the energy, not of the radiance, which
// also gains (n2 / n1)^2. Grazing and total internal reflection: 0; equal indices: 1, also at
// cos_i = 0. Error: 16 ulp, near grazing and the critical angle as well.
// Source: thesis eq. (12), without 1 - R.
float fresnel_transmittance(float n1, float n2, float cos_i)
{
    vec4 shares = optics_fresnel(n1, n2, cos_i);
    return 0.5 * (shares.z + shares.w);
}

// As above; `critical` is critical_cosine_split(n1, n2), for many cosines at one pair of indices.
float fresnel_transmittance(float n1, float n2, float cos_i, vec2 critical)
{
    vec4 shares = optics_fresnel(n1, n2, cos_i, critical);
    return 0.5 * (shares.z + shares.w);
}

// Schlick's approximation of the reflected share, R0 + (1 - R0) (1 - cos)^5 with
// R0 = ((n1 - n2) / (n1 + n2))^2 and the cosine on the thin side: cos_i, or cos_t where n1 > n2.
// 1 at total internal reflection. Equal indices: (1 - cos_i)^5, where the truth is 0. Differs from
// fresnel_reflectance by up to 0.08 for ratios of 1.3 to 2.42, by more the nearer they are to 1.
// Error against its own formula: 16 ulp.
// Source: C. Schlick, An Inexpensive BRDF Model for Physically-based Rendering, 1994, eq. (24).
float fresnel_schlick(float n1, float n2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    cos_i = optics_limit(cos_i, 0.0, 1.0);
    float amplitude = (n2 - n1) / (n2 + n1);
    float r0 = amplitude * amplitude;
    float rest = 1.0 - cos_i;
    if (n1 > n2) {
        float square = optics_transmitted_square(n1, n2, cos_i);
        if (square < 0.0) {
            return 1.0;
        }
        float cos_t = sqrt(square) / n2;
        // Where 1 - cos_t cancels: (1 - cos_i) + (cos_i^2 - cos_t^2) / (cos_i + cos_t).
        if (cos_t > 0.5) {
            rest += (n1 - n2) * (n1 + n2) * (rest * (1.0 + cos_i)) / (n2 * n2 * (cos_i + cos_t));
        } else {
            rest = 1.0 - cos_t;
        }
    }
    float rest_squared = rest * rest;
    return r0 + (1.0 - r0) * (rest_squared * rest_squared * rest);
}

#endif
