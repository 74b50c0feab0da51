// The share of a search's steps from a map.
uniform highp sampler2D density_map;

float step_density(vec2 uv)
{
    return textureLod(density_map, uv, 0.0).x;
}
