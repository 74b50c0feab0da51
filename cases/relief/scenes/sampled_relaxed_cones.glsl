// The cones of relaxed_map, by the sampler's own filter; beside sampled.glsl.
uniform highp sampler2D relaxed_map;

float cone_at(vec2 uv)
{
    return textureLod(relaxed_map, uv, 0.0).x;
}
