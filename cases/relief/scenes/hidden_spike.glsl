// A spike as high as the box, half a texel wide, between two texels of a map of 128 that see only
// the floor.
float solid_height(vec2 uv)
{
    return abs(uv.x - 0.5) < 0.25 / 128.0 ? 0.5 : -0.5;
}
