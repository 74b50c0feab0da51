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

#ifdef TERMS
// The reciprocal of the exponential's series, by Horner's rule.
float by_series(float d, float k)
{
    float y = 0.69314718056 * k * d;
    float sum = 1.0;
    for (int i = TERMS; i > 0; --i) {
        sum = 1.0 + sum * y / float(i);
    }
    return 1.0 / sum;
}
#endif
