// A map of one parabola, blurred: a Gaussian adds its variance to it. The first level's is one.
vec3 blurred(vec2 uv, int level)
{
    return vec3(uv.x * uv.x + (level > 0 ? exp2(2.0 * float(level - 1)) : 0.0));
}
