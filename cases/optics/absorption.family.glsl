// Ways to compute the share 2^(-k d) of the light that is left of a channel, for absorption.family.toml:
// k is how strongly it is absorbed, 0 to 1, and d the way in half distances.

float by_exp2(float d, float k)
{
    return exp2(-k * d);
}

float by_exp(float d, float k)
{
    return exp(-0.69314718056 * k * d);
}

float by_pow(float d, float k)
{
    return pow(0.5, k * d);
}

// share is what is left after one half distance.
float by_pow_of_share(float d, float share)
{
    return pow(share, d);
}

// 1 - k I with the absorbed share I = 1 - 2^-d (thesis eq. (13) and section 4.1.2).
float by_mix(float d, float k)
{
    return mix(1.0, exp2(-d), k);
}

#ifdef DEGREE
// 2^-y, y up to 126: the exponent's bits from the integer part, and a polynomial, the best of its
// degree that is exact at both ends, for the rest.
float by_polynomial(float d, float k)
{
    float x = -min(k * d, 126.0);
    float whole = floor(x);
    float f = x - whole;
#if DEGREE == 1
    float power = 1.0 + f;
#elif DEGREE == 2
    float power = 1.0 + f * (0.660233971 + f * 0.339766029);
#elif DEGREE == 3
    float power = 1.0 + f * (0.695424347 + f * (0.226307683 + f * 0.07826797));
#elif DEGREE == 4
    float power = 1.0 + f * (0.693032121 + f * (0.241379763 + f * (0.052032369 + f * 0.013555747)));
#elif DEGREE == 5
    float power = 1.0 + f * (0.693151739 + f * (0.240159271 + f * (0.055818676 + f * (0.008990995
                           + f * 0.001879319))));
#endif
    return intBitsToFloat((int(whole) + 127) << 23) * power;
}
#endif
