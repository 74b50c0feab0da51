// The cones of published_cone_map, by the sampler's own filter; beside sampled.glsl.
uniform highp sampler2D published_cone_map;

float cone_at(vec2 uv)
{
    return textureLod(published_cone_map, uv, 0.0).x;
}
