float root(float x, float y)
{
    return sqrt(x - y);
}
