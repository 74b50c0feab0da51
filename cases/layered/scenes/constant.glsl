// An inner layer of one colour.
uniform vec3 color;

vec3 inner_layer(vec2 uv, float level)
{
    return color;
}
