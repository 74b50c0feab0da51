// What the cases below cases/drivers ask of a driver's own functions.
#ifndef ETALON_DRIVERS_TRAPS
#define ETALON_DRIVERS_TRAPS

#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// 1 where x is a NaN, 0 else. By its bits: isnan, and x != x, may be folded by a compiler that
// takes for granted that there are none.
float is_nan(float x)
{
    return (floatBitsToUint(x) & 0x7fffffffu) > 0x7f800000u ? 1.0 : 0.0;
}

// x^5, three products.
float fifth_power(float x)
{
    float square = x * x;
    return square * square * x;
}

#endif
