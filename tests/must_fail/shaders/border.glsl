// Values that stand just on or just off a border.

// The float `steps` floats above x, for positive x.
float above(float x, int steps)
{
    return intBitsToFloat(floatBitsToInt(x) + steps);
}

// x, but `steps` floats above it where x is `at`.
float above_at(float x, float at, int steps)
{
    return x == at ? above(x, steps) : x;
}

float no_number(float x)
{
    return uintBitsToFloat(floatBitsToUint(x) | 0x7fc00000u);
}

float infinite(float x)
{
    return uintBitsToFloat((floatBitsToUint(x) & 0x80000000u) | 0x7f800000u);
}

// Negative zero, however the compiler thinks of signs.
float zero_like(float x)
{
    return uintBitsToFloat(floatBitsToUint(x) & 0x80000000u);
}

void split(float x, int steps, out float whole, out float rest)
{
    whole = floor(x);
    rest = above(x - floor(x), steps);
}

// A search that finds the hit at x, but for the row where x is `at`: there it returns `instead`.
float found(float x, float at, float instead)
{
    return x == at ? instead : x;
}
