// The cones of cone_map, by the sampler's own filter; beside sampled.glsl.
uniform highp sampler2D cone_map;

float cone_at(vec2 uv)
{
    return textureLod(cone_map, uv, 0.0).x;
}
