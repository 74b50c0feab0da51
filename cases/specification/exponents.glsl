// What the cases of this folder call of GLSL 4.00 and above.

float significand(float x)
{
    int exponent;
    return frexp(x, exponent);
}

int binary_exponent(float x)
{
    int exponent;
    frexp(x, exponent);
    return exponent;
}
