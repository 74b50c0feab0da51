// x within +-limit, 0 for NaN.
float limited(float x, float limit)
{
    return x >= -limit ? min(x, limit) : (x < 0.0 ? -limit : 0.0);
}
