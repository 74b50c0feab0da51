// No translucent layer: it lies on the box's floor.
float translucent_height(vec2 uv)
{
    return -0.5;
}
