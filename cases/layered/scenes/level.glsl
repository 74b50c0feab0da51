// An inner layer that shows the mip level it is asked for.
vec3 inner_layer(vec2 uv, float level)
{
    return vec3(level);
}
