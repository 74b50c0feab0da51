// What the cases of this folder call beside GLSL's own functions and operations.

float fraction_by_modf(float x)
{
    float whole;
    return modf(x, whole);
}

float whole_by_modf(float x)
{
    float whole;
    modf(x, whole);
    return whole;
}
