// 1 for light that is a number and not negative.
float sane(vec3 light)
{
    return dot(light, vec3(0.25)) <= 3e38 && min(min(light.x, light.y), light.z) >= 0.0 ? 1.0 : 0.0;
}
