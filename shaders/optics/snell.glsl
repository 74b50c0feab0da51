// Refraction at a smooth interface between two media.
//
// Everywhere in this folder: n1 is the index of the medium that the light is in, n2 that of the
// medium behind the interface; only their ratio has a meaning. cos_i is the cosine of the angle
// between the ray and the normal, 0 grazing, 1 normal incidence. v is the direction of travel and
// n the surface normal, unit length, dot(v, n) <= 0. Indices are clamped to [1/1024, 1024],
// cosines to [0, 1] and components of vectors to +-2^40, a NaN to the limit on the side of its
// sign bit, so that no input yields NaN or infinity. The errors stated hold for indices from 1 to
// 4 and every cosine, on a device that rounds + - * / sqrt correctly and keeps subnormals.
//
// Near the critical angle the transmitted cosine is the root of a difference that cancels without
// limit. There, and only there, the difference is formed in integers, exactly: no `precise`, no
// fused operation and no rearrangement of a compiler can touch it, and whether there is total
// internal reflection is decided right to the last float.
#ifndef ETALON_OPTICS_SNELL
#define ETALON_OPTICS_SNELL

#include "limit.glsl"

float optics_clamp_index(float n)
{
    return optics_limit(n, 1.0 / 1024.0, 1024.0);
}

vec3 optics_clamp_vector(vec3 v)
{
    return optics_limit(v, 1099511627776.0);
}

// The 64 bits of a * b, high word first.
uvec2 optics_wide_product(uint a, uint b)
{
    uint a_high = a >> 16;
    uint a_low = a & 0xffffu;
    uint b_high = b >> 16;
    uint b_low = b & 0xffffu;
    uint low = a_low * b_low;
    uint middle = a_high * b_low + (low >> 16);
    uint other = a_low * b_high + (middle & 0xffffu);
    return uvec2(a_high * b_high + (middle >> 16) + (other >> 16), (other << 16) | (low & 0xffffu));
}

// (n1 c)^2 - (n1^2 - n2^2) with its true sign, within 2 ulp however much it cancels.
// For n2 < n1 <= 32 n2 and c from 2^-12 to 1 where the value is in [-2^-18, 1] n2^2.
//
// With p = m1 mc the product of the mantissas it is p^2 - (m1^2 - m2^2) 2^(46 + 2 f) in units of
// 2^(2 (e1 - shift - 23 - f)): a difference of two numbers of at most 112 bits.
float optics_exact_square(float n1, float n2, float c)
{
    uint bits1 = floatBitsToUint(n1);
    uint bits2 = floatBitsToUint(n2);
    uint bits_c = floatBitsToUint(c);
    uint shift = (bits1 >> 23) - (bits2 >> 23);
    uint m1 = ((bits1 & 0x7fffffu) | 0x800000u) << shift;
    uint m2 = (bits2 & 0x7fffffu) | 0x800000u;
    uint mc = (bits_c & 0x7fffffu) | 0x800000u;
    uint f = 127u - (bits_c >> 23);

    uvec2 p = optics_wide_product(m1, mc);
    uvec2 low = optics_wide_product(p.y, p.y);
    uvec2 cross_term = optics_wide_product(p.x, p.y);
    uvec2 high = optics_wide_product(p.x, p.x);
    uint w0 = low.y;
    uint w1 = low.x + (cross_term.y << 1);
    uint carry = w1 < low.x ? 1u : 0u;
    uint doubled = (cross_term.x << 1) | (cross_term.y >> 31);
    uint w2 = high.y + doubled;
    uint w3 = high.x + (w2 < doubled ? 1u : 0u);
    w2 += carry;
    w3 += w2 < carry ? 1u : 0u;

    uvec2 k = optics_wide_product(m1 - m2, m1 + m2);
    uint k_high = (k.x << (2u * f)) | ((k.y >> 1) >> (31u - 2u * f));
    uint k_low = k.y << (2u * f);
    uint s1 = k_low << 14;
    uint s2 = (k_high << 14) | (k_low >> 18);
    uint s3 = k_high >> 18;
    bool borrow1 = w1 < s1;
    bool borrow2 = w2 < s2 || (w2 == s2 && borrow1);
    w1 -= s1;
    w2 -= s2 + (borrow1 ? 1u : 0u);
    w3 -= s3 + (borrow2 ? 1u : 0u);

    float sign_of = 1.0;
    if ((w3 & 0x80000000u) != 0u) {
        sign_of = -1.0;
        w0 = ~w0 + 1u;
        w1 = ~w1 + (w0 == 0u ? 1u : 0u);
        w2 = ~w2 + (w0 == 0u && w1 == 0u ? 1u : 0u);
        w3 = ~w3 + (w0 == 0u && w1 == 0u && w2 == 0u ? 1u : 0u);
    }
    int exponent = int(bits1 >> 23) - int(shift + f) - 141;
    // Two steps and no loop: Mesa takes half a minute to unroll one over constant inputs.
    if (w3 == 0u) {
        w3 = w2;
        w2 = w1;
        w1 = w0;
        exponent -= 16;
    }
    if (w3 == 0u) {
        w3 = w2;
        w2 = w1;
        exponent -= 16;
    }
    // Twice a half of the exponent, as the whole may be out of a float's range.
    float unit = uintBitsToFloat(uint(exponent + 127) << 23);
    return sign_of * (((float(w3) * 4294967296.0 + float(w2)) * unit) * unit);
}

// (n2 cos_t)^2, negative where there is total internal reflection; within 10 ulp. Indices and c
// must have been clamped.
float optics_transmitted_square(float n1, float n2, float c)
{
    if (n1 <= n2) {
        float x = n1 * c;
        return (n2 - n1) * (n2 + n1) + x * x;
    }
    float n2_square = n2 * n2;
    float square = n2_square - n1 * (n1 * ((1.0 - c) * (1.0 + c)));
    if (square > 0.5 * n2_square || square < -n2_square / 524288.0 || n1 > 32.0 * n2) {
        return square;
    }
    // Two different floats have a critical cosine above 2^-12.
    if (c < 1.0 / 4096.0) {
        return (n2 - n1) * (n2 + n1);
    }
    return optics_exact_square(n1, n2, c);
}

// The float nearest to the critical cosine, for n1 > n2, both clamped.
float optics_nearest_critical(float n1, float n2)
{
    float cosine = min(sqrt((n1 - n2) * (n1 + n2)) / n1, 1.0);
    if (n1 > 32.0 * n2) {
        return cosine;
    }
    return min(cosine - optics_exact_square(n1, n2, cosine) / (2.0 * n1 * n1 * cosine), 1.0);
}

// True where all light is reflected: n1 > n2 and cos_i below the critical cosine. Exact for
// n1 <= 32 n2, decided within the last float or two beyond. No float is exactly critical, but for
// n1 = n2 and cos_i = 0, which is not total reflection.
// Source: thesis eqs. (7), (8); an angle from the normal is meant, so (7) holds with cos_t = 0.
bool total_internal_reflection(float n1, float n2, float cos_i)
{
    return optics_transmitted_square(optics_clamp_index(n1), optics_clamp_index(n2),
                                     optics_limit(cos_i, 0.0, 1.0)) < 0.0;
}

// The cosine of the critical angle, sqrt(1 - (n2 / n1)^2), rounded up: the least float that is
// transmitted, so that total_internal_reflection is cos_i < critical_cosine. 0 where n1 <= n2:
// nothing is below it, there is no critical angle. Error: below 1 ulp.
// Source: thesis eq. (7), as a cosine.
float critical_cosine(float n1, float n2)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    if (n1 <= n2) {
        return 0.0;
    }
    float cosine = optics_nearest_critical(n1, n2);
    if (n1 <= 32.0 * n2 && optics_exact_square(n1, n2, cosine) < 0.0) {
        cosine = uintBitsToFloat(floatBitsToUint(cosine) + 1u);
    }
    return cosine;
}

// The critical cosine as two floats: x the nearest to it, y what is left, within 8 ulp of itself.
// What the functions that take `critical` want, once per pair of indices; (0, 0) where n1 <= n2.
// Prepared on the host it needs more than binary64: y is then good to 2^-53 of x only.
vec2 critical_cosine_split(float n1, float n2)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    if (n1 <= n2) {
        return vec2(0.0);
    }
    float cosine = optics_nearest_critical(n1, n2);
    if (n1 > 32.0 * n2) {
        return vec2(cosine, 0.0);
    }
    return vec2(cosine, -optics_exact_square(n1, n2, cosine) / (2.0 * n1 * n1 * cosine));
}

// The cosine of the angle between the refracted ray and the normal,
// sqrt(1 - (n1 / n2)^2 (1 - cos_i^2)); 0 at total internal reflection; cos_i for equal indices.
// Error: 4 ulp, on both sides of the critical angle to the last float. Costs 20 to 30 times the
// published form on llvmpipe, which executes both sides of every branch: nearly all of that is
// the exact difference, which only light about the critical angle needs.
// Source: thesis eqs. (6), (19).
float cos_transmitted(float n1, float n2, float cos_i)
{
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    cos_i = optics_limit(cos_i, 0.0, 1.0);
    if (n1 == n2) {
        return cos_i;
    }
    return min(sqrt(max(optics_transmitted_square(n1, n2, cos_i), 0.0)) / n2, 1.0);
}

// The mirrored direction v - 2 dot(v, n) n. The side that n is on does not matter; v may have any
// length and keeps it. Error: 4e-7 of the length of v in each component. Costs twice the published
// form: the limits.
// Source: thesis eqs. (14), (16), with the sign that keeps the length.
vec3 reflect_ray(vec3 v, vec3 n)
{
    v = optics_clamp_vector(v);
    n = optics_clamp_vector(n);
    return v - (2.0 * dot(v, n)) * n;
}

// The refracted direction, of unit length; the zero vector at total internal reflection; v for
// equal indices. A normal on the side that v points to is turned round: n1 is always the medium
// that v travels in; a dot(v, n) from 0 to 4e-7, which rounding alone may make, is grazing.
// Error in each component: 2e-6 where cos_t > 0.5, 6e-6 where cos_t > 0.1; at the critical angle
// the rounding of dot(v, n) alone moves the direction by its root, 1e-3; for n1 far above n2 its
// length is off by up to 2e-7 (n1 / n2)^2.
// Source: thesis eqs. (17), (18); (n1 cos_i - n2 cos_t) without its cancellation.
vec3 refract_ray(vec3 v, vec3 n, float n1, float n2)
{
    v = optics_clamp_vector(v);
    n = optics_clamp_vector(n);
    n1 = optics_clamp_index(n1);
    n2 = optics_clamp_index(n2);
    if (n1 == n2) {
        return v;
    }
    float c = -dot(v, n);
    if (c < -4e-7) {
        c = -c;
        n = -n;
    }
    c = clamp(c, 0.0, 1.0);
    float square = optics_transmitted_square(n1, n2, c);
    if (square < 0.0) {
        return vec3(0.0);
    }
    float along_normal = (n2 - n1) * (n2 + n1) / (n1 * c + sqrt(square));
    return (n1 * v - along_normal * n) / n2;
}

// Dispersion: refract_ray for each colour channel with its own indices, a column per channel; a
// column is zero where that channel is totally reflected. Error: as refract_ray.
// Source: thesis section 3.1.1.
mat3 refract_ray_rgb(vec3 v, vec3 n, vec3 n1, vec3 n2)
{
    return mat3(refract_ray(v, n, n1.r, n2.r), refract_ray(v, n, n1.g, n2.g),
                refract_ray(v, n, n1.b, n2.b));
}

#endif
