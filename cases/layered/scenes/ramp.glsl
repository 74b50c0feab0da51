// An inner layer that rises with the texture coordinate.
vec3 inner_layer(vec2 uv, float level)
{
    return vec3(uv, 1.0);
}
